use ga_anim::bvh;
use ga_anim::inverse_kinematics::{Marker, PoseFit, PoseFitOptions, Target};
use ga_anim::kinematics::KinematicsError;
use ga_anim::pose::Pose;
use ga_anim::skeleton::{Joint, JointLimits, Limit, Skeleton};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;
use proptest::prelude::*;
use rayon::prelude::*;

use super::{chain, vectors};

/// A marker at the head of every joint, and one at the tail of each that has no joint below.
fn markers(skeleton: &Skeleton) -> Vec<Marker> {
    let joints = skeleton.joints();
    let heads = joints.iter().enumerate().map(|(joint, rest)| Marker {
        joint,
        at_rest: rest.head,
    });
    let ends = (0..joints.len()).filter(|&joint| skeleton.children(joint).next().is_none());
    let tails = ends.map(|joint| Marker {
        joint,
        at_rest: joints[joint].tail,
    });
    heads.chain(tails).collect()
}

fn places(skeleton: &Skeleton, pose: &Pose, markers: &[Marker]) -> Vec<Point<f64>> {
    let motions = pose.motions(skeleton).unwrap();
    let place = |marker: &Marker| motions[marker.joint].transform(Point::from(marker.at_rest));
    markers.iter().map(place).collect()
}

fn seen(places: &[Point<f64>]) -> Vec<Target> {
    let target = |&position: &Point<f64>| Target {
        position,
        weight: 1.0,
    };
    places.iter().map(target).collect()
}

fn mean_error(a: &[Point<f64>], b: &[Point<f64>]) -> f64 {
    let total: f64 = a.iter().zip(b).map(|(a, b)| a.distance(*b)).sum();
    total / a.len() as f64
}

#[test]
fn the_poses_of_a_recording_come_back_from_the_places_of_its_joints() {
    const METRES: f64 = 0.056_444;
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let motion = bvh::read(path).unwrap();
    let skeleton = motion.skeleton().unwrap();
    let all = markers(&skeleton);
    // With the End Sites and without them.
    for markers in [&all[..], &all[..skeleton.len()]] {
        let mut fit = PoseFit::new(&skeleton, None, markers.to_vec()).unwrap();
        for sample in 0..50 {
            let frame = sample * (motion.frame_count() - 1) / 49;
            let truth = places(&skeleton, &motion.pose(frame).unwrap(), markers);
            let mut pose = Pose::rest(skeleton.len());
            let options = PoseFitOptions::default();
            let report = fit.solve(&seen(&truth), &mut pose, &options).unwrap();
            let error = METRES * mean_error(&places(&skeleton, &pose, markers), &truth);
            assert!(error <= 1e-6, "frame {frame}: {error} m, {report:?}");
            assert!(report.converged && report.iterations < 30, "{report:?}");
        }
    }
}

/// Every frame, from the rest pose. Some take a few more steps than those above.
#[test]
fn every_pose_of_a_recording_comes_back() {
    const METRES: f64 = 0.056_444;
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let motion = bvh::read(path).unwrap();
    let skeleton = motion.skeleton().unwrap();
    let all = markers(&skeleton);
    for markers in [&all[..], &all[..skeleton.len()]] {
        let new = || PoseFit::new(&skeleton, None, markers.to_vec()).unwrap();
        let frames = (0..motion.frame_count()).into_par_iter();
        let fitted = frames.map_init(new, |fit, frame| {
            let truth = places(&skeleton, &motion.pose(frame).unwrap(), markers);
            let mut pose = Pose::rest(skeleton.len());
            let options = PoseFitOptions::default();
            let report = fit.solve(&seen(&truth), &mut pose, &options).unwrap();
            let error = METRES * mean_error(&places(&skeleton, &pose, markers), &truth);
            (frame, error, report)
        });
        let fitted: Vec<_> = fitted.collect();
        for (frame, error, report) in fitted {
            assert!(
                error <= 1e-6 && report.converged,
                "frame {frame}: {error} m, {report:?}"
            );
        }
    }
}

#[test]
fn steps_alone_find_the_next_frame_and_keep_what_places_do_not_show() {
    let skeleton = chain(&[[0.0; 3], [0.0, 1.0, 0.0], [0.0, 1.8, 0.0], [0.0, 2.5, 0.0]]);
    let rotor = |v: [f64; 3]| Rotor::from_rotation_vector(v).unwrap();
    let bent = [
        rotor([0.3, 0.5, -0.2]),
        rotor([0.8, 0.0, 0.1]),
        rotor([0.6, 0.2, 0.3]),
        rotor([0.1, 0.9, 0.2]),
    ];
    let truth = Pose::from_rotors(
        &skeleton,
        Motor::from(Translator::from_displacement([3.0, 1.0, -2.0])),
        &bent,
    );
    let truth = truth.unwrap();
    let markers = markers(&skeleton);
    let targets = seen(&places(&skeleton, &truth, &markers));
    let mut fit = PoseFit::new(&skeleton, None, markers).unwrap();
    // A start that differs from the truth by little, and in the twist of the last bone.
    let start = Pose {
        root: Motor::default(),
        joints: truth.joints.clone(),
    };
    let mut start = start;
    let twist = Rotor::from_axis_angle([0.0, 1.0, 0.0], 0.4).unwrap();
    let head = Point::from(skeleton.joints()[2].head);
    start.joints[2] *= Motor::about(head, twist);
    start.joints[1] *= Motor::about(Point::new(0.0, 1.0, 0.0), rotor([0.05, 0.0, -0.03]));
    for align_first in [false, true] {
        let mut pose = start.clone();
        let options = PoseFitOptions {
            align_first,
            ..PoseFitOptions::default()
        };
        let report = fit.solve(&targets, &mut pose, &options).unwrap();
        assert!(report.greatest_error < 1e-9, "{report:?}");
        // The last joint has nothing below: it does not rotate at all.
        assert_eq!(pose.joints[3].rotor(), start.joints[3].rotor());
        // The last bone's twist against its parent is that of the start, up to squares.
        let own = |pose: &Pose| pose.joints[2].rotor();
        let swing = own(&pose) * own(&start).reverse();
        let bone = own(&start).transform(Point::new(0.0, 1.0, 0.0));
        let ([x, y, z], _) = swing.to_quaternion();
        let along = Vector::new(x, y, z).dot(bone.into());
        assert!(along.abs() < 1e-3, "twist {along}");
    }
}

/// A body with two arms, hinges and a cone.
fn body() -> (Skeleton, JointLimits) {
    let joint = |name: &str, parent, head, tail| Joint {
        name: name.into(),
        parent,
        head,
        tail,
    };
    let skeleton = Skeleton::new(vec![
        joint("hip", None, [0.0, 1.0, 0.0], [0.0, 1.2, 0.0]),
        joint("spine", Some(0), [0.0, 1.2, 0.0], [0.0, 1.6, 0.0]),
        joint("left arm", Some(1), [0.2, 1.6, 0.0], [0.5, 1.6, 0.0]),
        joint("left forearm", Some(2), [0.5, 1.6, 0.0], [0.8, 1.6, 0.0]),
        joint("right arm", Some(1), [-0.2, 1.6, 0.0], [-0.5, 1.6, 0.0]),
        joint("right forearm", Some(4), [-0.5, 1.6, 0.0], [-0.8, 1.6, 0.0]),
    ]);
    let skeleton = skeleton.unwrap();
    let hinge = |sign: f64| Limit::Hinge {
        axis: [0.0, sign, 0.0],
        range: [0.0, 2.5],
    };
    let cone = Limit::SwingTwist {
        axis: [0.0, 1.0, 0.0],
        swing: 0.6,
        twist: [-0.8, 0.8],
    };
    let kinds = vec![
        Limit::Free,
        cone,
        Limit::Free,
        hinge(-1.0),
        Limit::Free,
        hinge(1.0),
    ];
    let limits = JointLimits::new(&skeleton, kinds).unwrap();
    (skeleton, limits)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn any_pose_comes_back(
        angles in prop::collection::vec(vectors(), 6), root in prop::array::uniform3(-5.0..5.0_f64), whole in vectors(),
    ) {
        let (skeleton, _) = body();
        let rotors: Vec<_> = angles.iter()
            .map(|v| Rotor::from_rotation_vector((*v * 1.5).into()).unwrap()).collect();
        let around = Rotor::from_rotation_vector((whole * 3.0).into()).unwrap();
        let motion = Translator::from_displacement(root) * around;
        let truth = Pose::from_rotors(&skeleton, motion, &rotors).unwrap();
        let markers = markers(&skeleton);
        let truth = places(&skeleton, &truth, &markers);
        let mut fit = PoseFit::new(&skeleton, None, markers).unwrap();
        let mut pose = Pose::rest(6);
        let report = fit.solve(&seen(&truth), &mut pose, &PoseFitOptions::default()).unwrap();
        prop_assert!(report.greatest_error < 1e-8, "{report:?}");
        // Without the closed form at the start it is found as well, or a lesser pose is reported.
        let mut stepped = Pose::rest(6);
        let options = PoseFitOptions { align_first: false, ..PoseFitOptions::default() };
        let report = fit.solve(&seen(&truth), &mut stepped, &options).unwrap();
        let found = places(&skeleton, &stepped, fit.markers());
        let greatest = found.iter().zip(&truth).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        prop_assert!((greatest - report.greatest_error).abs() < 1e-12);
    }

    #[test]
    fn limits_hold_and_without_them_no_neighbour_is_better(
        angles in prop::collection::vec(vectors(), 6), noise in prop::collection::vec(vectors(), 8),
        weights in prop::collection::vec(0.1..2.0_f64, 8), nudges in prop::collection::vec((vectors(), 0..6_usize), 30),
    ) {
        let (skeleton, limits) = body();
        let rotors: Vec<_> = angles.iter().enumerate()
            .map(|(k, v)| limits.clamp(k, Rotor::from_rotation_vector((*v).into()).unwrap())).collect();
        let truth = Pose::from_rotors(&skeleton, Motor::default(), &rotors).unwrap();
        let markers = markers(&skeleton);
        let targets: Vec<_> = places(&skeleton, &truth, &markers).into_iter().zip(&noise).zip(&weights)
            .map(|((place, noise), &weight)| Target { position: Point::from(Vector::from(place) + *noise * 0.02), weight })
            .collect();
        let free = JointLimits::free(6);
        let cost = |pose: &Pose| -> f64 {
            let found = places(&skeleton, pose, &markers);
            found.iter().zip(&targets).map(|(a, b)| b.weight * a.distance_squared(b.position)).sum()
        };
        let total: f64 = weights.iter().sum();
        // From rest the search may end in another least pose than from the truth.
        for (start, align_first, limits) in [
            (Pose::rest(6), true, &limits),
            (truth.clone(), false, &limits),
            (Pose::rest(6), true, &free),
        ] {
            let mut fit = PoseFit::new(&skeleton, Some(limits), markers.clone()).unwrap();
            let mut pose = start.clone();
            let options = PoseFitOptions { align_first, ..PoseFitOptions::default() };
            let report = fit.solve(&targets, &mut pose, &options).unwrap();
            let least = cost(&pose);
            prop_assert!(least <= cost(&start) + 1e-12);
            prop_assert!((least / total - report.root_mean_square_error.powi(2)).abs() < 1e-12);
            for (joint, own) in pose.joints.iter().enumerate() {
                prop_assert!(limits.excess(joint, own.rotor()) < 1e-7);
            }
            // Small rotations of single joints do not help by more than the rounding of the search.
            for &(nudge, joint) in nudges.iter().filter(|_| *limits == free) {
                let mut other = pose.clone();
                let head = Point::from(skeleton.joints()[joint].head);
                let rotor = Rotor::from_rotation_vector((nudge * 1e-3).into()).unwrap();
                let rotor = limits.clamp(joint, rotor * other.joints[joint].rotor());
                let place = other.joints[joint].transform(head);
                other.joints[joint] = Translator::from_displacement(place.coordinates()) * rotor
                    * Translator::from_displacement(head.coordinates().map(|x| -x));
                let gain = least - cost(&other);
                prop_assert!(gain <= 1e-3 * least + 1e-9, "joint {joint}: {gain} of {least}");
            }
        }
    }
}

#[test]
fn unseen_markers_and_a_fixed_root_are_respected() {
    let (skeleton, _) = body();
    let markers = markers(&skeleton);
    let mut fit = PoseFit::new(&skeleton, None, markers.clone()).unwrap();
    let mut targets = seen(&places(&skeleton, &Pose::rest(6), &markers));
    for target in &mut targets {
        target.weight = 0.0;
        target.position = Point::new(f64::NAN, 0.0, 0.0);
    }
    // Only the left hand, which is to go up.
    let hand = Point::new(0.5, 1.9, 0.1);
    targets[6] = Target {
        position: hand,
        weight: 2.0,
    };
    let options = PoseFitOptions {
        root_motion: false,
        align_first: false,
        ..PoseFitOptions::default()
    };
    let mut pose = Pose::rest(6);
    let report = fit.solve(&targets, &mut pose, &options).unwrap();
    assert!(report.greatest_error < 1e-9, "{report:?}");
    assert_eq!(pose.root, Motor::default());
    assert_eq!(pose.joints[4], Motor::default());
    let hip = pose.bones(&skeleton).unwrap()[0][0];
    assert_eq!(hip, [0.0, 1.0, 0.0]);
}

#[test]
fn faults_are_named() {
    let (skeleton, _) = body();
    let none = PoseFit::new(&skeleton, None, vec![]).unwrap_err();
    assert_eq!(none, KinematicsError::NoMarkers);
    let marker = |joint, x| Marker {
        joint,
        at_rest: [x, 0.0, 0.0],
    };
    let beyond = PoseFit::new(&skeleton, None, vec![marker(6, 0.0)]).unwrap_err();
    assert_eq!(
        beyond,
        KinematicsError::NoJoint {
            index: 6,
            joints: 6
        }
    );
    let nowhere = PoseFit::new(&skeleton, None, vec![marker(0, f64::NAN)]).unwrap_err();
    assert!(matches!(
        nowhere,
        KinematicsError::NotFinite {
            what: "a marker",
            ..
        }
    ));
    let few = JointLimits::free(5);
    let limits = PoseFit::new(&skeleton, Some(&few), vec![marker(0, 0.0)]).unwrap_err();
    assert_eq!(
        limits,
        KinematicsError::Limits {
            expected: 6,
            found: 5
        }
    );

    let mut fit = PoseFit::new(&skeleton, None, vec![marker(0, 0.0), marker(1, 1.0)]).unwrap();
    let target = |x, weight| Target {
        position: Point::new(x, 0.0, 0.0),
        weight,
    };
    let mut solve = |targets: &[Target], joints| {
        let mut pose = Pose::rest(joints);
        let error = fit
            .solve(targets, &mut pose, &PoseFitOptions::default())
            .unwrap_err();
        assert_eq!(pose, Pose::rest(joints));
        error
    };
    assert_eq!(
        solve(&[], 6),
        KinematicsError::Targets {
            expected: 2,
            found: 0
        }
    );
    let both = [target(0.0, 1.0), target(1.0, 1.0)];
    assert!(matches!(solve(&both, 5), KinematicsError::Skeleton(_)));
    let nan = [target(0.0, 1.0), target(f64::NAN, 1.0)];
    assert!(matches!(solve(&nan, 6), KinematicsError::NotFinite { .. }));
    let weight = |weight| [target(0.0, 1.0), target(0.0, weight)];
    assert_eq!(
        solve(&weight(-1.0), 6),
        KinematicsError::Weight {
            index: 1,
            weight: -1.0
        }
    );
    assert!(matches!(
        solve(&weight(f64::NAN), 6),
        KinematicsError::Weight { index: 1, .. }
    ));
    let unseen = [target(0.0, 0.0), target(0.0, 0.0)];
    assert!(matches!(
        solve(&unseen, 6),
        KinematicsError::Weight { index: 0, .. }
    ));
}
