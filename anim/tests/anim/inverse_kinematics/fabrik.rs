use ga_anim::inverse_kinematics::{Fabrik, FabrikOptions, reach_with_chain};
use ga_anim::kinematics::KinematicsError;
use ga_anim::pose::Pose;
use ga_anim::skeleton::{JointLimits, Limit};
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use super::{chain, points, vectors};

/// One iteration as the paper writes it, on plain arrays.
fn plain(joints: &mut [[f64; 3]], lengths: &[f64], target: [f64; 3]) {
    let root = joints[0];
    let last = lengths.len();
    joints[last] = target;
    let place = |from: [f64; 3], to: [f64; 3], length: f64| -> [f64; 3] {
        let distance = (0..3)
            .map(|k| (to[k] - from[k]).powi(2))
            .sum::<f64>()
            .sqrt();
        let part = length / distance;
        std::array::from_fn(|k| (1.0 - part) * from[k] + part * to[k])
    };
    for k in (0..last).rev() {
        joints[k] = place(joints[k + 1], joints[k], lengths[k]);
    }
    joints[0] = root;
    for k in 0..last {
        joints[k + 1] = place(joints[k], joints[k + 1], lengths[k]);
    }
}

fn options() -> FabrikOptions {
    FabrikOptions {
        tolerance: 1e-9,
        iterations: 2000,
    }
}

proptest! {
    #[test]
    fn an_iteration_is_that_of_the_paper(
        joints in prop::collection::vec(points(1.0), 3..9), target in points(2.0),
        lengths in prop::collection::vec(0.2..1.0_f64, 8),
    ) {
        let lengths = &lengths[..joints.len() - 1];
        let mut expected: Vec<_> = joints.iter().map(|joint| joint.coordinates()).collect();
        plain(&mut expected, lengths, target.coordinates());
        let mut found = joints;
        Fabrik::new(lengths.to_vec()).unwrap().iterate(&mut found, target);
        for (found, expected) in found.into_iter().zip(expected) {
            prop_assert!(found.distance(Point::from(expected)) < 1e-11);
        }
    }

    #[test]
    fn a_free_chain_reaches_what_it_can(
        directions in prop::collection::vec(vectors(), 3..8), target in vectors(), part in 0.05..1.3_f64,
    ) {
        let mut joints = vec![Point::new(0.3, -0.2, 0.1)];
        for direction in &directions {
            let end = Vector::from(joints[joints.len() - 1]) + *direction;
            joints.push(Point::from(end));
        }
        let lengths: Vec<_> = directions.iter().map(|direction| direction.length()).collect();
        let total: f64 = lengths.iter().sum();
        let longest = lengths.iter().copied().fold(0.0, f64::max);
        let fabrik = Fabrik::new(lengths.clone()).unwrap();
        let target = Point::from(Vector::from(joints[0]) + target.normalized().unwrap() * (part * total));
        let (root, mut found) = (joints[0], joints);
        let report = fabrik.solve(&mut found, target, &options()).unwrap();
        prop_assert_eq!(found[0], root);
        for (ends, length) in found.windows(2).zip(&lengths) {
            prop_assert!((ends[0].distance(ends[1]) - length).abs() < 1e-13);
        }
        let last = found[found.len() - 1];
        prop_assert!((last.distance(target) - report.distance).abs() < 1e-14);
        if part >= 1.0 {
            prop_assert!((report.distance - (part - 1.0) * total).abs() < 1e-12);
        } else if part < 0.95 && part * total > 1.05 * (2.0 * longest - total) {
            // Near the border of what can be reached, where the chain is straight or folded, each
            // iteration gains little.
            let is_easy = 0.3 < part && part < 0.8 && 2.0 * longest < total;
            let bound = if is_easy { 1e-9 } else { 1e-3 * total };
            prop_assert!(report.distance <= bound, "{report:?}");
        }
    }

    #[test]
    fn limits_hold_and_the_report_is_true(
        truth in prop::collection::vec((vectors(), -1.0..1.0_f64), 4), start in prop::collection::vec(vectors(), 5),
    ) {
        let skeleton = chain(&[
            [0.0; 3], [0.0, 1.0, 0.0], [0.0, 1.8, 0.0], [0.2, 2.5, 0.0], [0.2, 3.0, 0.1],
        ]);
        let hinge = Limit::Hinge { axis: [1.0, 0.0, 0.2], range: [-0.2, 1.9] };
        let cone = Limit::SwingTwist { axis: [0.0, 1.0, 0.0], swing: 0.8, twist: [-0.3, 0.3] };
        let kinds = vec![Limit::Free, hinge, cone, hinge, Limit::Fixed];
        let limits = JointLimits::new(&skeleton, kinds).unwrap();
        let pose_of = |rotors: Vec<Rotor<f64>>| Pose::from_rotors(&skeleton, Motor::default(), &rotors).unwrap();
        // A target that an admissible pose reaches.
        let mut rotors: Vec<_> = truth.iter().enumerate()
            .map(|(joint, (axis, angle))| limits.clamp(joint, Rotor::from_axis_angle((*axis).into(), *angle).unwrap()))
            .collect();
        rotors.push(Rotor::default());
        let target = Point::from(pose_of(rotors).bones(&skeleton).unwrap()[4][0]);
        let start = start.iter().map(|v| Rotor::from_rotation_vector((*v).into()).unwrap());
        let mut pose = pose_of(start.collect());
        let report = reach_with_chain(&skeleton, Some(&limits), &mut pose, &[0, 1, 2, 3, 4], target, &options()).unwrap();
        let end = Point::from(pose.bones(&skeleton).unwrap()[4][0]);
        prop_assert!((end.distance(target) - report.distance).abs() < 1e-12);
        for joint in 0..4 {
            prop_assert!(limits.excess(joint, pose.joints[joint].rotor()) < 1e-7);
            let head = skeleton.joints()[joint].head;
            prop_assert!(pose.joints[joint].transform(Point::from(head)).distance(head.into()) < 1e-12);
        }
        // The free joint alone brings the end to the right side.
        prop_assert!(report.distance < 1.0, "{report:?}");
    }
}

#[test]
fn a_straight_chain_leaves_its_line() {
    let fabrik = Fabrik::new(vec![1.0; 4]).unwrap();
    let mut joints: Vec<_> = (0..5).map(|x| Point::new(f64::from(x), 0.0, 0.0)).collect();
    for target in [2.5, -1.0, 0.01] {
        let target = Point::new(target, 0.0, 0.0);
        let report = fabrik.solve(&mut joints, target, &options()).unwrap();
        assert!(report.distance <= 1e-9, "{report:?}");
        joints = (0..5).map(|x| Point::new(f64::from(x), 0.0, 0.0)).collect();
    }
    // A finger that bends to one side alone.
    let skeleton = chain(&[[0.0; 3], [1.0, 0.0, 0.0], [1.8, 0.0, 0.0], [2.4, 0.0, 0.0]]);
    for axis in [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.3, 1.0]] {
        let hinge = Limit::Hinge {
            axis,
            range: [0.0, 1.6],
        };
        let cone = Limit::SwingTwist {
            axis: [1.0, 0.0, 0.0],
            swing: 1.6,
            twist: [-0.5, 0.5],
        };
        let limits = JointLimits::new(&skeleton, vec![cone, hinge, hinge, Limit::Fixed]).unwrap();
        let mut pose = Pose::rest(4);
        let target = Point::new(1.6, 0.0, 0.0);
        let report = reach_with_chain(
            &skeleton,
            Some(&limits),
            &mut pose,
            &[0, 1, 2, 3],
            target,
            &options(),
        )
        .unwrap();
        assert!(report.distance <= 1e-6, "{axis:?}: {report:?}");
    }
}

#[test]
fn faults_of_chains() {
    let at = |x: f64| Point::new(x, 0.0, 0.0);
    assert_eq!(
        Fabrik::new(vec![]),
        Err(KinematicsError::Chain {
            bones: 0,
            points: 1
        })
    );
    let length = KinematicsError::Length {
        bone: 1,
        length: -1.0,
    };
    assert_eq!(Fabrik::new(vec![1.0, -1.0]), Err(length));
    let fabrik = Fabrik::new(vec![1.0, 1.0]).unwrap();
    let mut joints = [at(0.0), at(1.0), at(2.0)];
    let chain_error = KinematicsError::Chain {
        bones: 2,
        points: 2,
    };
    assert_eq!(
        fabrik.solve(&mut joints[..2], at(1.0), &options()),
        Err(chain_error)
    );
    assert!(matches!(
        fabrik.solve(&mut joints, at(f64::NAN), &options()),
        Err(KinematicsError::NotFinite {
            what: "the target",
            ..
        })
    ));
    for tolerance in [f64::NAN, -1.0] {
        let wrong = FabrikOptions {
            tolerance,
            ..options()
        };
        let found = fabrik.solve(&mut joints, at(1.0), &wrong);
        assert!(matches!(found, Err(KinematicsError::Tolerance(_))));
    }
    // Coincident joints and a target at the root are solved as well.
    let mut joints = [at(0.0); 3];
    let report = fabrik.solve(&mut joints, at(0.0), &options()).unwrap();
    assert!(report.distance <= 1e-9);
    assert!((joints[1].distance(joints[2]) - 1.0).abs() < 1e-14);

    let skeleton = chain(&[[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0]]);
    let reach = |chain: &[usize]| {
        let mut pose = Pose::rest(3);
        reach_with_chain(&skeleton, None, &mut pose, chain, at(0.5), &options()).unwrap_err()
    };
    assert_eq!(
        reach(&[0, 1, 2]),
        KinematicsError::ZeroLengthBone { joint: "a".into() }
    );
    assert_eq!(
        reach(&[2]),
        KinematicsError::Chain {
            bones: 0,
            points: 1
        }
    );
    assert_eq!(
        reach(&[0, 3]),
        KinematicsError::NoJoint {
            index: 3,
            joints: 3
        }
    );
}
