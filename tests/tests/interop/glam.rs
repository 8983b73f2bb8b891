//! glam's and mint's transforms and quaternion products against the action of motors.

use ga_runtime::cga3::{Dilator, Direction, Motor, Point, Rotor, Similarity, Translator};
use ga_runtime::geometry::{Affine, NotConformal};
use ga_runtime::interop::NotRigid;
use ga_runtime::vga3;
use glam_034::{
    Affine3, Affine3A, DAffine3, DMat3, DMat4, DQuat, DVec3, Mat3, Mat3A, Mat4, Quat, Vec3, Vec3A,
};
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
        // Normalising leaves an error of one or two ε in the rotor's length, which counts twice;
        // the products round as well.
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
        prop_assert!(Affine3::from(motor).transform_point3(p).abs_diff_eq(truth, tolerance));
        prop_assert!(Vec3A::from(motor.transform(Point::from(Vec3A::from(p)))).abs_diff_eq(truth.into(), tolerance));
        for found in [
            Motor::try_from(Affine3A::from(motor)), Motor::try_from(Affine3::from(motor)), Motor::try_from(Mat4::from(motor)),
        ] {
            let image = Vec3::from(found.unwrap().transform(Point::from(p)));
            prop_assert!(image.abs_diff_eq(truth, 2.0 * tolerance));
        }
        prop_assert!(Mat4::from(motor).transform_point3(p).abs_diff_eq(truth, tolerance));
    }

    #[test]
    fn motors_survive_a_round_trip(q in rotation(), t in vector()) {
        let motor = Motor::try_from((q, t)).unwrap();
        let (turn, shift) = <(DQuat, DVec3)>::from(motor);
        prop_assert!(turn.abs_diff_eq(q, 1e-15) && shift.abs_diff_eq(t, 2e-14));
        // A matrix does not distinguish q from −q.
        for found in [Motor::try_from(DAffine3::from(motor)), Motor::try_from(DMat4::from(motor))] {
            let (turn, shift) = <(DQuat, DVec3)>::from(found.unwrap());
            prop_assert!(turn.dot(q).abs() > 1.0 - 1e-15 && shift.abs_diff_eq(t, 2e-14));
        }
    }

    #[test]
    fn rotation_matrices_agree_with_quaternions(q in rotation(), v in vector()) {
        let rotor = Rotor::try_from(q).unwrap();
        prop_assert!((DMat3::from(rotor) * v).abs_diff_eq(q * v, 8.0 * f64::EPSILON * v.length()));
        let found = DQuat::from(Rotor::try_from(DMat3::from_quat(q)).unwrap());
        prop_assert!(found.dot(q).abs() > 1.0 - 1e-15);
        let (q, v) = (q.as_quat(), v.as_vec3());
        let rotor = Rotor::try_from(q).unwrap();
        let tolerance = 8.0 * f32::EPSILON * v.length();
        prop_assert!((Mat3::from(rotor) * v).abs_diff_eq(q * v, tolerance));
        prop_assert!((Mat3A::from(rotor) * v).abs_diff_eq(q * v, tolerance));
        for found in [Rotor::try_from(Mat3::from_quat(q)), Rotor::try_from(Mat3A::from_quat(q))] {
            prop_assert!(Quat::from(found.unwrap()).dot(q).abs() > 1.0 - 4.0 * f32::EPSILON);
        }
    }

    #[test]
    fn similarities_act_as_matrices_do(q in rotation(), t in vector(), exponent in -3.0..3.0_f64, p in vector()) {
        let factor = 10.0_f64.powf(exponent);
        let turn = Rotor::try_from(q).unwrap();
        let similarity = Translator::from(t) * turn * Dilator::from_factor(factor).unwrap();
        let truth = DAffine3::from_scale_rotation_translation(DVec3::splat(factor), q, t);
        let image = truth.transform_point3(p);
        let tolerance = 32.0 * f64::EPSILON * (factor * p.length() + t.length());
        prop_assert!(DAffine3::from(similarity).transform_point3(p).abs_diff_eq(image, tolerance));
        prop_assert!(DMat4::from(similarity).transform_point3(p).abs_diff_eq(image, tolerance));
        for found in [Similarity::try_from(truth), Similarity::try_from(DMat4::from(truth))] {
            let found = DAffine3::from(found.unwrap()).transform_point3(p);
            prop_assert!(found.abs_diff_eq(image, tolerance));
        }
    }

    #[test]
    fn affine_maps_survive_a_round_trip(columns in [vector(), vector(), vector()], t in vector(), p in vector()) {
        let [a, b, c] = columns;
        let glam = DAffine3::from_cols(a, b, c, t);
        let map = Affine::from(glam);
        prop_assert_eq!(DAffine3::from(map), glam);
        prop_assert_eq!(Affine::try_from(DMat4::from(glam)), Ok(map));
        prop_assert_eq!(DMat4::from(map), DMat4::from(glam));
        let image = DVec3::from(map.transform(Point::from(p)));
        prop_assert!(image.abs_diff_eq(glam.transform_point3(p), 1e-12));
        let single = Affine3::from_cols(a.as_vec3(), b.as_vec3(), c.as_vec3(), t.as_vec3());
        prop_assert_eq!(Affine3::from(Affine::from(single)), single);
        prop_assert_eq!(Affine3A::from(Affine::from(single)), Affine3A::from(single));

        let rows = mint_05::RowMatrix4::from(map);
        let columns = mint_05::ColumnMatrix4::from(map);
        prop_assert_eq!([columns.y.x, columns.y.y, columns.y.z, columns.y.w], [b.x, b.y, b.z, 0.0]);
        prop_assert_eq!([columns.w.x, columns.w.y, columns.w.z, columns.w.w], [t.x, t.y, t.z, 1.0]);
        prop_assert_eq!([rows.x.x, rows.x.y, rows.x.z, rows.x.w], [a.x, b.x, c.x, t.x]);
        prop_assert_eq!(Affine::try_from(rows), Ok(map));
        prop_assert_eq!(Affine::try_from(mint_05::ColumnMatrix4::from(map)), Ok(map));
    }

    #[test]
    fn motors_go_through_mint(q in rotation(), t in vector()) {
        let motor = Motor::try_from((q, t)).unwrap();
        for found in [
            Motor::try_from(mint_05::RowMatrix4::from(motor)), Motor::try_from(mint_05::ColumnMatrix4::from(motor)),
        ] {
            let (turn, shift) = <(DQuat, DVec3)>::from(found.unwrap());
            prop_assert!(turn.dot(q).abs() > 1.0 - 1e-15 && shift.abs_diff_eq(t, 2e-14));
        }
    }

    #[test]
    fn vectors_survive_a_round_trip(v in vector()) {
        prop_assert_eq!(DVec3::from(Point::from(v)), v);
        prop_assert_eq!(DVec3::from(Direction::from(v)), v);
        prop_assert_eq!(DVec3::from(vga3::Vector::from(v)), v);
        prop_assert_eq!(DVec3::from(Translator::from(v)), v);
        let mint = mint_05::Point3 { x: v.x, y: v.y, z: v.z };
        prop_assert_eq!(mint_05::Point3::from(Point::from(mint)), mint);
        let mint = mint_05::Vector3 { x: v.x, y: v.y, z: v.z };
        prop_assert_eq!(mint_05::Vector3::from(Direction::from(mint)), mint);
        prop_assert_eq!(mint_05::Vector3::from(vga3::Vector::from(mint)), mint);
    }

    #[test]
    fn rotors_rotate_directions_as_quaternions_do(q in rotation(), size in 0.1..10.0_f64, v in vector()) {
        let rotor = Rotor::try_from(q * size).unwrap();
        let turned = DVec3::from(rotor.transform(Direction::from(v)));
        prop_assert!(turned.abs_diff_eq(q * v, 2e-14));
        let mint = mint_05::Quaternion { v: mint_05::Vector3 { x: q.x, y: q.y, z: q.z }, s: q.w };
        let back = mint_05::Quaternion::from(Rotor::try_from(mint).unwrap());
        prop_assert!(DQuat::from_xyzw(back.v.x, back.v.y, back.v.z, back.s).abs_diff_eq(q, 1e-15));
    }
}

#[test]
fn maps_that_are_not_rigid_are_refused() {
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

#[test]
fn maps_that_are_not_conformal_are_refused() {
    let matrices = [
        (
            DMat4::from_scale(DVec3::new(1.0, 1.0, 1.01)),
            NotConformal::Shears,
        ),
        (DMat4::from_scale(DVec3::splat(-1.0)), NotConformal::Mirrors),
        (
            DMat4::from_translation(DVec3::X).transpose(),
            NotConformal::Projective,
        ),
        (
            DMat4::from_translation(DVec3::new(f64::NAN, 0.0, 0.0)),
            NotConformal::NotFinite,
        ),
        (DMat4::from_scale(DVec3::ZERO), NotConformal::Singular),
    ];
    for (matrix, reason) in matrices {
        assert_eq!(Similarity::try_from(matrix), Err(reason), "{matrix}");
    }
    assert!(Rotor::try_from(Mat3::from_diagonal(Vec3::new(1.0, 1.0, -1.0))).is_err());
}
