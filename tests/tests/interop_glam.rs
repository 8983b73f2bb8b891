//! glam and mint against the action of motors: glam's own transforms and quaternion products are the truth.

use ga_runtime::cga3::{Direction, Motor, Point, Rotor, Translator};
use ga_runtime::interop::NotRigid;
use glam_034::{Affine3A, DAffine3, DMat4, DQuat, DVec3, Mat4, Quat, Vec3};
use proptest::prelude::*;

fn vector() -> impl Strategy<Value = DVec3> {
    [-10.0..10.0_f64, -10.0..10.0, -10.0..10.0].prop_map(DVec3::from)
}

fn rotation() -> impl Strategy<Value = DQuat> {
    (vector(), -6.0..6.0_f64)
        .prop_filter("an axis", |(axis, _)| axis.length() > 1e-3)
        .prop_map(|(axis, angle)| DQuat::from_axis_angle(axis.normalize(), angle))
}

proptest! {
    #[test]
    fn motors_move_points_as_glam_does(q in rotation(), t in vector(), p in vector()) {
        let motor = Motor::try_from((q, t)).unwrap();
        let moved = DVec3::from(motor.transform(Point::from(p)));
        let truth = q * p + t;
        // Normalising leaves an epsilon or two in the rotor's length, which counts twice; the products round as well.
        let tolerance = 8.0 * f64::EPSILON * (p.length() + t.length());
        prop_assert!(moved.abs_diff_eq(truth, tolerance), "{moved} {truth}");
        prop_assert!(DAffine3::from(motor).transform_point3(p).abs_diff_eq(truth, tolerance));
        prop_assert!(DMat4::from(motor).transform_point3(p).abs_diff_eq(truth, tolerance));
    }

    #[test]
    fn single_precision_moves_points_as_glam_does(q in rotation(), t in vector(), p in vector()) {
        let (q, t, p) = (q.as_quat(), t.as_vec3(), p.as_vec3());
        let motor = Motor::try_from((q, t)).unwrap();
        let truth = q * p + t;
        let tolerance = 8.0 * f32::EPSILON * (p.length() + t.length());
        prop_assert!(Vec3::from(motor.transform(Point::from(p))).abs_diff_eq(truth, tolerance));
        prop_assert!(Affine3A::from(motor).transform_point3(p).abs_diff_eq(truth, tolerance));
        prop_assert!(Mat4::from(motor).transform_point3(p).abs_diff_eq(truth, tolerance));
    }

    #[test]
    fn motors_come_back(q in rotation(), t in vector()) {
        let motor = Motor::try_from((q, t)).unwrap();
        let (turn, shift) = <(DQuat, DVec3)>::from(motor);
        prop_assert!(turn.abs_diff_eq(q, 1e-15) && shift.abs_diff_eq(t, 2e-14));
        // A matrix does not tell q from −q.
        for found in [Motor::try_from(DAffine3::from(motor)), Motor::try_from(DMat4::from(motor))] {
            let (turn, shift) = <(DQuat, DVec3)>::from(found.unwrap());
            prop_assert!(turn.dot(q).abs() > 1.0 - 1e-15 && shift.abs_diff_eq(t, 2e-14));
        }
    }

    #[test]
    fn vectors_come_back(v in vector()) {
        prop_assert_eq!(DVec3::from(Point::from(v)), v);
        prop_assert_eq!(DVec3::from(Direction::from(v)), v);
        prop_assert_eq!(DVec3::from(Translator::from(v)), v);
        let mint = mint_05::Point3 { x: v.x, y: v.y, z: v.z };
        prop_assert_eq!(mint_05::Point3::from(Point::from(mint)), mint);
        let mint = mint_05::Vector3 { x: v.x, y: v.y, z: v.z };
        prop_assert_eq!(mint_05::Vector3::from(Direction::from(mint)), mint);
    }

    #[test]
    fn rotors_turn_directions_as_quaternions_do(q in rotation(), size in 0.1..10.0_f64, v in vector()) {
        let rotor = Rotor::try_from(q * size).unwrap();
        let turned = DVec3::from(rotor.transform(Direction::from(v)));
        prop_assert!(turned.abs_diff_eq(q * v, 2e-14));
        let mint = mint_05::Quaternion { v: mint_05::Vector3 { x: q.x, y: q.y, z: q.z }, s: q.w };
        let back = mint_05::Quaternion::from(Rotor::try_from(mint).unwrap());
        prop_assert!(DQuat::from_xyzw(back.v.x, back.v.y, back.v.z, back.s).abs_diff_eq(q, 1e-15));
    }
}

#[test]
fn what_is_not_rigid_is_refused() {
    assert_eq!(
        Rotor::try_from(Quat::from_xyzw(0.0, 0.0, 0.0, 0.0)),
        Err(NotRigid::Quaternion)
    );
    assert_eq!(
        Rotor::try_from(DQuat::from_xyzw(f64::NAN, 0.0, 0.0, 1.0)),
        Err(NotRigid::Quaternion)
    );
    assert_eq!(
        Motor::try_from((DQuat::IDENTITY, DVec3::new(0.0, f64::INFINITY, 0.0))),
        Err(NotRigid::Displacement)
    );
    let matrices = [
        DMat4::from_scale(DVec3::splat(1.01)),
        DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0)),
        DMat4::from_translation(DVec3::X).transpose(),
        DMat4::from_translation(DVec3::new(f64::NAN, 0.0, 0.0)),
        DMat4::ZERO,
    ];
    for matrix in matrices {
        assert_eq!(Motor::try_from(matrix), Err(NotRigid::Matrix), "{matrix}");
    }
}
