use ga_anim::inverse_kinematics::{Aim, aim_joint};
use ga_anim::kinematics::KinematicsError;
use ga_anim::pose::Pose;
use ga_anim::skeleton::{JointLimits, Limit};
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use super::{chain, points, vectors};

fn rotated(rotor: Rotor<f64>, vector: Vector<f64>) -> Vector<f64> {
    rotor.transform(Point::from(vector)).into()
}

/// Whether a vector lies in the half plane of two others: on the side of the second from the first.
fn in_half_plane(vector: Vector<f64>, edge: Vector<f64>, side: Vector<f64>) -> bool {
    let normal = edge.cross(side).normalized().unwrap();
    vector.dot(normal).abs() < 1e-12 && vector.reject(edge).unwrap().dot(side) > 0.0
}

proptest! {
    #[test]
    fn the_axis_points_to_the_target_and_the_other_up(
        axis in vectors(), up in vectors(), towards in vectors(), upwards in vectors(),
    ) {
        prop_assume!(axis.cross(up).length() > 1e-2 && towards.cross(upwards).length() > 1e-2);
        let aim = Aim::new(axis.into(), up.into()).unwrap();
        let rotor = aim.rotor(towards.into(), upwards.into()).unwrap();
        let direction = rotated(rotor, axis).normalized().unwrap();
        prop_assert!(direction.distance(towards.normalized().unwrap()) < 1e-14);
        prop_assert!(in_half_plane(rotated(rotor, up), towards, upwards));
        // The opposite target and the opposite up, where shortest rotations are not determined.
        let back = aim.rotor((-axis).into(), (-up).into()).unwrap();
        prop_assert!(rotated(back, axis).distance(-axis) < 1e-13);
        prop_assert!(in_half_plane(rotated(back, up), -axis, -up));
    }

    #[test]
    fn a_joint_of_a_pose_looks_at_a_target(
        angles in prop::collection::vec(vectors(), 3), target in points(5.0),
    ) {
        let skeleton = chain(&[[0.0; 3], [0.0, 1.0, 0.1], [0.0, 1.6, 0.2]]);
        let rotors: Vec<_> = angles.iter().map(|v| Rotor::from_rotation_vector((*v).into()).unwrap()).collect();
        let before = Pose::from_rotors(&skeleton, Motor::default(), &rotors).unwrap();
        let aim = Aim::new([0.0, 0.2, 1.0], [0.0, 1.0, 0.0]).unwrap();
        let mut pose = before.clone();
        let missed = aim_joint(&skeleton, None, &mut pose, 2, &aim, target, [0.0, 1.0, 0.0]);
        let head = Point::from(before.bones(&skeleton).unwrap()[2][0]);
        prop_assume!(head.vector_to(target).cross(Vector::new(0.0, 1.0, 0.0)).length() > 1e-2);
        prop_assert!(missed.unwrap() < 1e-13);
        let motion = pose.motions(&skeleton).unwrap()[2];
        prop_assert!(motion.transform(Point::new(0.0, 1.6, 0.2)).distance(head) < 1e-13);
        let eyes = rotated(motion.rotor(), Vector::new(0.0, 0.2, 1.0));
        prop_assert!(eyes.angle(head.vector_to(target)).unwrap() < 1e-13);
        prop_assert_eq!(&pose.joints[..2], &before.joints[..2]);

        // A head that rotates by 0.7 rad at most misses by the rest.
        let cone = Limit::SwingTwist { axis: [0.0, 1.0, 0.0], swing: 0.7, twist: [-0.7, 0.7] };
        let limits = JointLimits::new(&skeleton, vec![Limit::Free, Limit::Free, cone]).unwrap();
        let missed = aim_joint(&skeleton, Some(&limits), &mut pose, 2, &aim, target, [0.0, 1.0, 0.0]).unwrap();
        prop_assert!(limits.excess(2, pose.joints[2].rotor()) < 1e-9);
        let motion = pose.motions(&skeleton).unwrap()[2];
        let eyes = rotated(motion.rotor(), Vector::new(0.0, 0.2, 1.0));
        prop_assert!((eyes.angle(head.vector_to(target)).unwrap() - missed).abs() < 1e-12);
    }
}

#[test]
fn what_is_not_determined_is_an_error() {
    let (z, y) = ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]);
    assert!(matches!(
        Aim::new([0.0; 3], y),
        Err(KinematicsError::Axis { what: "axis", .. })
    ));
    assert!(matches!(
        Aim::new(z, [0.0, 0.0, -2.0]),
        Err(KinematicsError::Parallel { .. })
    ));
    let aim = Aim::new(z, y).unwrap();
    assert!(matches!(
        aim.rotor(y, [0.0, 3.0, 0.0]),
        Err(KinematicsError::Parallel { .. })
    ));
    assert!(matches!(
        aim.rotor([f64::NAN; 3], y),
        Err(KinematicsError::Axis { .. })
    ));
    let skeleton = chain(&[[0.0; 3], [0.0, 1.0, 0.0]]);
    let mut pose = Pose::rest(2);
    let mut look = |joint, target| aim_joint(&skeleton, None, &mut pose, joint, &aim, target, y);
    let joint = Point::new(0.0, 1.0, 0.0);
    assert!(matches!(look(1, joint), Err(KinematicsError::Axis { .. })));
    assert!(matches!(
        look(2, joint),
        Err(KinematicsError::NoJoint {
            index: 2,
            joints: 2
        })
    ));
}
