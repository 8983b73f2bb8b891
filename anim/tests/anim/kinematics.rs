//! Forward kinematics and layers of poses, one by one and in lanes.

use ga_anim::bvh;
use ga_anim::kinematics::{Hierarchy, KinematicsError, blend_layers};
use ga_anim::pose::Pose;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::scalar::{Lanes, Real};
use glam::{DAffine3, DMat4};
use nullcone_shared_data::shared;
use proptest::prelude::*;

fn motor() -> impl Strategy<Value = Motor<f64>> {
    let numbers = prop::array::uniform3(-1.0..1.0_f64);
    (numbers.clone(), -3.0..3.0_f64, numbers).prop_filter_map("no axis", |(axis, angle, shift)| {
        Some(Translator::from_displacement(shift) * Rotor::from_axis_angle(axis, angle)?)
    })
}

fn affine(motor: Motor<f64>) -> DAffine3 {
    let [x, y, z] = motor.to_matrix();
    DAffine3::from_mat4(DMat4::from_cols_array_2d(&[x, y, z, [0.0, 0.0, 0.0, 1.0]]).transpose())
}

/// The largest distance by which two motors move points within a unit of the origin apart.
fn apart(a: Motor<f64>, b: DAffine3) -> f64 {
    [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        .into_iter()
        .map(|place| {
            let found = a.transform(Point::from(place)).coordinates();
            b.transform_point3(place.into()).distance(found.into())
        })
        .fold(0.0, f64::max)
}

/// A random tree, and poses of it.
fn poses() -> impl Strategy<Value = (Vec<Option<usize>>, Vec<Motor<f64>>)> {
    (1..12_usize, 1..4_usize).prop_flat_map(|(joints, count)| {
        let parents = prop::collection::vec(any::<Option<u8>>(), joints).prop_map(|above| {
            let parent = |(joint, above): (usize, Option<u8>)| {
                above
                    .filter(|_| joint > 0)
                    .map(|above| above as usize % joint)
            };
            above.into_iter().enumerate().map(parent).collect()
        });
        (parents, prop::collection::vec(motor(), joints * count))
    })
}

fn coefficients<S: Real>(m: Motor<S>) -> [S; 8] {
    let rotation = [m.scalar(), m.e12(), m.e13(), m.e23()];
    let moment = [m.e1i(), m.e2i(), m.e3i(), m.e123i()];
    std::array::from_fn(|k| if k < 4 { rotation[k] } else { moment[k - 4] })
}

fn single(motor: Motor<f64>) -> Motor<f32> {
    let [s, e12, e13, e23, e1i, e2i, e3i, e123i] = coefficients(motor).map(|x| x as f32);
    Motor::new_unchecked(s, e12, e13, e23, e1i, e2i, e3i, e123i)
}

fn double(motor: Motor<f32>) -> Motor<f64> {
    let [s, e12, e13, e23, e1i, e2i, e3i, e123i] = coefficients(motor).map(f64::from);
    Motor::new_unchecked(s, e12, e13, e23, e1i, e2i, e3i, e123i)
}

proptest! {
    #[test]
    fn total_motions_are_chains_of_matrices((parents, own) in poses(), root in motor()) {
        let hierarchy = Hierarchy::new(&parents).unwrap();
        let mut total = vec![Motor::default(); own.len()];
        hierarchy.forward(root, &own, &mut total).unwrap();
        for (own, total) in own.chunks(parents.len()).zip(total.chunks(parents.len())) {
            let mut expected: Vec<DAffine3> = Vec::new();
            for (parent, own) in parents.iter().zip(own) {
                let above = parent.map_or(affine(root), |parent| expected[parent]);
                expected.push(above * affine(*own));
            }
            for (total, expected) in total.iter().zip(expected) {
                prop_assert!(apart(*total, expected) < 1e-12);
            }
        }
        // A pose of a skeleton gives the same.
        let joints = parents.iter().enumerate().map(|(joint, parent)| Joint {
            name: joint.to_string(),
            parent: *parent,
            head: [0.0; 3],
            tail: [0.0, 1.0, 0.0],
        });
        let skeleton = Skeleton::new(joints.collect()).unwrap();
        prop_assert_eq!(&Hierarchy::from(&skeleton), &hierarchy);
        let pose = Pose { root, joints: own[..parents.len()].to_vec() };
        prop_assert_eq!(&pose.motions(&skeleton).unwrap(), &total[..parents.len()]);
    }

    #[test]
    fn lanes_give_what_single_frames_give((parents, own) in poses(), root in motor()) {
        let hierarchy = Hierarchy::new(&parents).unwrap();
        let mut total = own.clone();
        hierarchy.forward(root, &own, &mut total).unwrap();
        // Frame f is the pose rotated as a whole, so that the lanes differ.
        let turned: [Motor<f64>; 4] = std::array::from_fn(|frame| {
            Rotor::from_axis_angle([0.0, 1.0, 0.0], frame as f64).unwrap().into()
        });
        let blocks: Vec<_> = own.iter().map(|own| Motor::from_lanes(&[*own; 4])).collect();
        let roots = Motor::from_lanes(&turned.map(|turn| turn * root));
        let mut found = vec![Motor::<Lanes<f64, 4>>::default(); own.len()];
        hierarchy.forward(roots, &blocks, &mut found).unwrap();
        for (frame, turn) in turned.into_iter().enumerate() {
            let mut expected = own.clone();
            hierarchy.forward(turn * root, &own, &mut expected).unwrap();
            for (found, expected) in found.iter().zip(expected) {
                prop_assert_eq!(found.lane(frame), expected);
            }
        }
    }

    #[test]
    fn single_precision_follows_double_precision((parents, own) in poses(), root in motor()) {
        let hierarchy = Hierarchy::new(&parents).unwrap();
        let own: Vec<_> = own.into_iter().map(single).collect();
        let mut total = own.clone();
        hierarchy.forward(single(root), &own, &mut total).unwrap();
        let own: Vec<_> = own.into_iter().map(double).collect();
        let mut expected = own.clone();
        hierarchy.forward(double(single(root)), &own, &mut expected).unwrap();
        for (found, expected) in total.into_iter().zip(expected) {
            prop_assert!(apart(double(found), affine(expected)) < 1e-4);
        }
    }

    #[test]
    fn layers_are_blends_joint_by_joint((_, below) in poses(), shift in motor(), weights in prop::collection::vec(0.0..=1.0_f64, 40)) {
        let weights = &weights[..below.len()];
        let above: Vec<_> = below.iter().map(|m| -(shift * *m)).collect();
        let mut blended = below.clone();
        blend_layers(&below, &above, weights, &mut blended).unwrap();
        for (((below, above), weight), blended) in below.iter().zip(&above).zip(weights).zip(&blended) {
            let expected = Motor::blend(&[(1.0 - weight, *below), (*weight, *above)]).unwrap();
            prop_assert!(apart(*blended, affine(expected)) < 1e-13);
        }
        let lanes = |motors: &[Motor<f64>]| -> Vec<Motor<Lanes<f64, 4>>> {
            motors.iter().map(|m| Motor::from_lanes(&[*m, -*m, *m, *m])).collect()
        };
        let in_lanes: Vec<_> = weights.iter().map(|w| Lanes::from_array([*w, *w, 0.0, 1.0])).collect();
        let mut found = lanes(&below);
        blend_layers(&lanes(&below), &lanes(&above), &in_lanes, &mut found).unwrap();
        for (k, found) in found.into_iter().enumerate() {
            let [first, opposite, none, all] = found.to_lanes();
            prop_assert_eq!(first, blended[k]);
            prop_assert_eq!(opposite, -first);
            prop_assert!(apart(none, affine(below[k])) < 1e-14 && apart(all, affine(above[k])) < 1e-14);
        }
    }
}

#[test]
fn a_recording_moves_as_its_own_frames_say() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let motion = bvh::read(path).unwrap();
    let parents: Vec<_> = motion.joints().iter().map(|joint| joint.parent).collect();
    let hierarchy = Hierarchy::new(&parents).unwrap();
    for frame in [0, 1000, 2751] {
        let expected = motion.frames_of_joints(frame).unwrap();
        let own: Vec<_> = parents
            .iter()
            .zip(&expected)
            .map(|(parent, motor)| {
                parent
                    .map_or(Motor::default(), |parent| expected[parent])
                    .reverse()
                    * *motor
            })
            .collect();
        let mut total = own.clone();
        hierarchy
            .forward(Motor::default(), &own, &mut total)
            .unwrap();
        for (found, expected) in total.into_iter().zip(expected) {
            assert!(apart(found, affine(expected)) < 1e-12);
        }
    }
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    assert_eq!(
        Hierarchy::new(&[None, Some(1)]),
        Err(KinematicsError::ParentNotBefore {
            joint: 1,
            parent: 1
        })
    );
    let hierarchy = Hierarchy::new(&[None, Some(0)]).unwrap();
    let raised = Motor::from(Translator::from_displacement([0.0, 1.0, 0.0]));
    let own = [raised; 4];
    let mut total = [Motor::default(); 4];
    let root = Motor::default();
    assert_eq!(
        hierarchy.forward(root, &own[..3], &mut total[..3]),
        Err(KinematicsError::PoseMotors {
            joints: 2,
            found: 3
        })
    );
    assert_eq!(
        hierarchy.forward(root, &own, &mut total[..2]),
        Err(KinematicsError::ResultLength {
            expected: 4,
            found: 2
        })
    );
    for weight in [-0.1, 1.1, f64::NAN] {
        assert_eq!(
            blend_layers(&own, &own, &[0.5, weight], &mut total),
            Err(KinematicsError::LayerWeight { joint: 1 })
        );
    }
    assert_eq!(
        blend_layers(&own, &own[..2], &[0.5, 0.5], &mut total),
        Err(KinematicsError::ResultLength {
            expected: 4,
            found: 2
        })
    );
    assert_eq!(total, [Motor::default(); 4]);
    let none = Hierarchy::new(&[]).unwrap();
    assert_eq!(none.forward(root, &[], &mut []), Ok(()));
    assert_eq!(blend_layers::<f64>(&[], &[], &[], &mut []), Ok(()));
}
