//! nalgebra's transforms against the action of versors.

use ga_runtime::cga3::{Direction, Motor, Point, Rotor, Similarity, Translator};
use ga_runtime::geometry::{Affine, NotConformal};
use ga_runtime::interop::NotRigid;
use ga_runtime::vga3;
use nalgebra_035::{
    Affine3, Isometry3, IsometryMatrix3, Matrix3, Matrix4, Point3, Quaternion, Rotation3,
    Similarity3, Translation3, UnitQuaternion, Vector3,
};
use proptest::prelude::*;

fn vector() -> impl Strategy<Value = Vector3<f64>> {
    [-10.0..10.0_f64, -10.0..10.0, -10.0..10.0].prop_map(Vector3::from)
}

fn rotation() -> impl Strategy<Value = UnitQuaternion<f64>> {
    (vector(), -6.0..6.0_f64)
        .prop_filter("an axis", |(axis, _)| axis.norm() > 1e-3)
        .prop_map(|(axis, angle)| UnitQuaternion::new(axis.normalize() * angle))
}

fn isometry() -> impl Strategy<Value = Isometry3<f64>> {
    (rotation(), vector()).prop_map(|(q, t)| Isometry3::from_parts(t.into(), q))
}

/// A few rounding errors relative to the point and the displacement.
fn tolerance(isometry: &Isometry3<f64>, p: &Vector3<f64>) -> f64 {
    8.0 * f64::EPSILON * (isometry.translation.vector.norm() + p.norm())
}

fn moved(motor: Motor<f64>, p: Point3<f64>) -> Point3<f64> {
    motor.transform(Point::from(p)).into()
}

fn scaled(similarity: Similarity<f64>, p: Point3<f64>) -> Point3<f64> {
    let image = similarity.transform(Point::from(p));
    image.centre().expect("images of points are finite").into()
}

proptest! {
    #[test]
    fn motors_move_points_as_nalgebra_does(isometry in isometry(), p in vector()) {
        let tolerance = tolerance(&isometry, &p);
        let (motor, p) = (Motor::from(isometry), Point3::from(p));
        let truth = isometry * p;
        prop_assert!((moved(motor, p) - truth).norm() < tolerance);
        prop_assert!((Isometry3::from(motor) * p - truth).norm() < tolerance);
        prop_assert!((IsometryMatrix3::from(motor) * p - truth).norm() < tolerance);
        prop_assert!((Matrix4::from(motor).transform_point(&p) - truth).norm() < tolerance);
        prop_assert!((Affine3::from(Affine::from(motor)) * p - truth).norm() < tolerance);
        for found in [
            Motor::try_from(IsometryMatrix3::from_parts(isometry.translation, isometry.rotation.into())).unwrap(),
            Motor::try_from(isometry.to_homogeneous()).unwrap(),
        ] {
            prop_assert!((moved(found, p) - truth).norm() < tolerance);
        }
    }

    #[test]
    fn unit_quaternions_survive_a_round_trip_exactly(q in rotation(), v in vector()) {
        let rotor = Rotor::from(q);
        prop_assert_eq!(UnitQuaternion::from(rotor), q);
        prop_assert_eq!(UnitQuaternion::from(-rotor).into_inner(), -q.into_inner());
        let turned = Vector3::from(rotor.transform(Direction::from(v)));
        prop_assert!((turned - q * v).norm() < 8.0 * f64::EPSILON * v.norm());
        let matrix = q.to_rotation_matrix();
        prop_assert!((Rotation3::from(rotor).into_inner() - matrix.matrix()).norm() < 8.0 * f64::EPSILON);
        prop_assert!((Matrix3::from(rotor) * v - q * v).norm() < 8.0 * f64::EPSILON * v.norm());
        for found in [Rotor::try_from(matrix).unwrap(), Rotor::try_from(*matrix.matrix()).unwrap()] {
            // A matrix does not distinguish q from −q.
            let found = UnitQuaternion::from(found);
            prop_assert!(found.coords.dot(&q.coords).abs() > 1.0 - 1e-15);
        }
    }

    #[test]
    fn vectors_survive_a_round_trip_exactly(v in vector()) {
        prop_assert_eq!(Point3::from(Point::from(Point3::from(v))), Point3::from(v));
        prop_assert_eq!(Vector3::from(Direction::from(v)), v);
        prop_assert_eq!(Vector3::from(vga3::Vector::from(v)), v);
        let shift = Translation3::from(v);
        prop_assert_eq!(Translation3::from(Translator::from(shift)), shift);
        prop_assert_eq!(Point::from(Point3::new(1_i64, 2, 3)), Point::new(1, 2, 3));
    }

    #[test]
    fn similarities_act_as_those_of_nalgebra(isometry in isometry(), exponent in -6.0..6.0_f64, p in vector()) {
        let factor = 10.0_f64.powf(exponent);
        let truth = Similarity3::from_isometry(isometry, factor);
        let similarity = Similarity::try_from(truth).unwrap();
        let p = Point3::from(p);
        let image = truth * p;
        let size = factor * p.coords.norm() + isometry.translation.vector.norm();
        // The weight of the image, 1/factor, is a difference of squares as large as the factor.
        let tolerance = 32.0 * f64::EPSILON * size * (1.0 + factor * factor);
        prop_assert!((scaled(similarity, p) - image).norm() <= tolerance);

        // Reading the coefficients loses no digits.
        let tolerance = 32.0 * f64::EPSILON * size;
        let back = Similarity3::try_from(similarity).unwrap();
        prop_assert!((back * p - image).norm() <= tolerance, "{} {}", back * p, image);
        prop_assert!((back.scaling() / factor - 1.0).abs() < 16.0 * f64::EPSILON);
        prop_assert!((Matrix4::from(similarity).transform_point(&p) - image).norm() <= tolerance);
        let found = Similarity::try_from(truth.to_homogeneous()).unwrap();
        prop_assert!((Matrix4::from(found).transform_point(&p) - image).norm() <= 4.0 * tolerance);
    }

    #[test]
    fn affine_maps_survive_a_round_trip_exactly(rows in [vector(), vector(), vector()], t in vector(), p in vector()) {
        let linear = rows.map(|row| [row.x, row.y, row.z]);
        let map = Affine::new(linear, [t.x, t.y, t.z]);
        let matrix = Matrix4::from(map);
        prop_assert_eq!(Affine::try_from(matrix), Ok(map));
        prop_assert_eq!(Affine::try_from(Affine3::from(map)), Ok(map));
        let p = Point3::from(p);
        let truth = matrix.transform_point(&p);
        let image = Point3::from(map.transform(Point::from(p)));
        prop_assert!((image - truth).norm() < 1e-12);
    }
}

#[test]
fn single_precision_works_too() {
    let isometry = Isometry3::new(
        Vector3::new(1.0_f32, -2.0, 3.0),
        Vector3::new(0.3, 0.2, -1.0),
    );
    let p = Point3::new(0.5, 0.25, -4.0);
    let image = Point3::from(Motor::from(isometry).transform(Point::from(p)));
    assert!((image - isometry * p).norm() < 4e-6);
}

#[test]
fn maps_that_are_not_rigid_are_refused() {
    let refused = [
        (Matrix4::new_scaling(2.0), NotConformal::Scales),
        (Matrix4::new_scaling(-1.0), NotConformal::Mirrors),
        (Matrix4::zeros(), NotConformal::Projective),
        (
            Matrix4::new_nonuniform_scaling(&Vector3::new(1.0, 1.0, 0.0)),
            NotConformal::Singular,
        ),
        (
            Matrix4::new_nonuniform_scaling(&Vector3::new(1.0, 1.0, 1.1)),
            NotConformal::Shears,
        ),
        (
            Matrix4::new_perspective(1.0, 1.0, 0.1, 9.0),
            NotConformal::Projective,
        ),
        (
            Matrix4::new_translation(&Vector3::new(f64::NAN, 0.0, 0.0)),
            NotConformal::NotFinite,
        ),
        (
            Matrix4::new_translation(&Vector3::new(0.0, f64::INFINITY, 0.0)),
            NotConformal::NotFinite,
        ),
    ];
    for (matrix, reason) in refused {
        assert_eq!(Motor::try_from(matrix), Err(reason), "{matrix}");
    }
    assert!(Similarity::try_from(Matrix4::new_scaling(2.0_f64)).is_ok());
    for (matrix, reason) in refused.into_iter().skip(1) {
        assert_eq!(Similarity::try_from(matrix), Err(reason), "{matrix}");
    }
    let mirror = Similarity3::from_scaling(-2.0);
    assert_eq!(Similarity::try_from(mirror), Err(NotConformal::Mirrors));
    let infinite = Similarity3::from_scaling(f64::INFINITY);
    assert_eq!(Similarity::try_from(infinite), Err(NotConformal::NotFinite));
    assert_eq!(
        Rotor::try_from(Rotation3::from_matrix_unchecked(Matrix3::identity() * 1.1)),
        Err(NotRigid::Matrix)
    );
    let far = IsometryMatrix3::from_parts(
        Translation3::new(f64::INFINITY, 0.0, 0.0),
        Rotation3::identity(),
    );
    assert_eq!(Motor::try_from(far), Err(NotRigid::Displacement));
}

/// The numbers of a `UnitQuaternion` are not checked, so NaN stays NaN.
#[test]
fn numbers_of_unit_quaternions_are_kept() {
    let broken = UnitQuaternion::new_unchecked(Quaternion::new(f64::NAN, 1.0, 2.0, 3.0));
    let rotor = Rotor::from(broken);
    assert!(rotor.scalar().is_nan());
    assert_eq!((rotor.e23(), rotor.e13(), rotor.e12()), (-1.0, 2.0, -3.0));
}

/// Far from factor 1 the versor's action loses digits by cancellation; its matrix does not.
#[test]
fn extreme_factors_are_read_back() {
    for factor in [1e-150_f64, 1e-12, 1e12, 1e150] {
        let isometry = Isometry3::new(Vector3::new(1.0, -2.0, 3.0), Vector3::new(0.3, 0.2, -1.0));
        let similarity =
            Similarity::try_from(Similarity3::from_isometry(isometry, factor)).unwrap();
        let back = Similarity3::try_from(similarity).unwrap();
        assert!((back.scaling() / factor - 1.0).abs() < 1e-14, "{factor}");
        let shift = back.isometry.translation.vector - Vector3::new(1.0, -2.0, 3.0);
        assert!(shift.norm() < 1e-14, "{factor}: {shift}");
    }
}
