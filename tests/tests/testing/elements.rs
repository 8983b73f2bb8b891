//! Declared elements in `assert_close!`, and random members over floating point.

use ga_runtime::Element;
use ga_runtime::cga3::{
    Circle, Dilator, Direction, DualPlane, DualQuaternion, Even, EvenVersor, FlatPoint, Line,
    Motor, MotorGenerator, Multivector, Odd, OddVersor, Plane, Point, PointPair, Pseudoscalar,
    Quaternion, Rotor, RoundVector, Similarity, SimilarityGenerator, Sphere, Translator,
    Transversor,
};
use ga_runtime::testing::{
    algebra_of, assert_close, check_close, for_all, member, sample, strategy, to_dense,
};

#[test]
fn elements_are_compared_in_all_blades() {
    let motor = Motor::new_unchecked(0.6, 0.8, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0);
    let nudged = Motor::new_unchecked(0.6, 0.8, 0.0, 0.0, 1.0, 2.0 + 1e-13, 3.0, 4.0);
    assert_close!(motor, nudged);
    assert!(check_close(&motor, &nudged, Some(1e-14), None).is_err());
    // Types with different blades, derived ones included, and dense multivectors.
    assert_close!(motor, Multivector::from(motor));
    let dense = to_dense(&algebra_of(Motor::<f64>::METRIC), &motor);
    assert_close!(motor, dense);
    let point = Point::new(1.0, 2.0, 2.0);
    assert_close!(point, RoundVector::new(1.0, 2.0, 2.0, 1.0, 4.5));
    assert!(
        check_close(
            &point,
            &RoundVector::new(1.0, 2.0, 2.0, 1.0, 4.6),
            None,
            None
        )
        .is_err()
    );
    // Several elements at once, and in single precision.
    assert_close!([motor, motor], vec![nudged, motor]);
    assert_close!(Point::new(0.1_f32, 0.2, 0.3), Point::new(0.1, 0.2, 0.3));
    assert_close!(Point::new(0.1_f32, 0.2, 0.3), Point::new(0.1_f64, 0.2, 0.3));
}

#[test]
fn messages_name_the_blade() {
    let plane = |offset| DualPlane::new(0.0, 1.0, 0.0, offset);
    let difference = check_close(&[plane(1.0)], &[plane(1.5)], None, None);
    let message = difference.expect_err("another plane").to_string();
    assert_eq!(
        message,
        "[0].the coefficient of blade 0b10000 is 1.0 on the left, 1.5 on the right, \
         a relative deviation of 3.3e-1 where 1.0e-12 is allowed"
    );
    let nowhere = plane(f64::NAN);
    assert!(check_close(&nowhere, &nowhere, None, None).is_err());
}

/// Checks that the members of a type are finite, are read back as constructed, and are unit versors
/// where the type says so.
fn check_members<T: Element<Scalar = f64> + PartialEq + std::fmt::Debug>() {
    let algebra = algebra_of::<f64>(T::METRIC);
    for_all(member::<T>(strategy::float(0.9)), |element| {
        let dense = to_dense(&algebra, &element);
        assert!(dense.coefficients().iter().all(|x| x.is_finite()));
        let again: T = element.map(|x| x);
        assert_eq!(again, element);
        let others = (0..algebra.size()).filter(|blade| !T::BLADES.contains(blade));
        for blade in others {
            assert_eq!(element.coefficient(blade), 0.0, "blade {blade:#b}");
        }
        if T::IS_UNIT_VERSOR {
            let size = dense.coefficients().iter().map(|x| x * x).sum::<f64>();
            assert_close!(
                dense.geometric(&dense.reverse()),
                algebra.one(),
                1e-14,
                size.max(1.0)
            );
        }
    });
}

#[test]
fn every_type_has_random_members() {
    macro_rules! check {
        ($($type:ident),* $(,)?) => { $(check_members::<$type<f64>>();)* };
    }
    check!(
        Point,
        RoundVector,
        DualPlane,
        PointPair,
        FlatPoint,
        Direction,
        MotorGenerator,
        Circle,
        Line,
        Sphere,
        Plane,
        Pseudoscalar,
        Rotor,
        Translator,
        Motor,
        Dilator,
        Similarity,
        SimilarityGenerator,
        Transversor,
        EvenVersor,
        OddVersor,
        Quaternion,
        DualQuaternion,
        Even,
        Odd,
        Multivector,
    );
}

/// Random motors rotate by all angles, with both signs of the scalar, about all axes, and translate
/// in all directions.
#[test]
fn random_motors_go_everywhere() {
    let mut seen = std::collections::BTreeSet::new();
    // The rarest eighth is that of one in a few hundred.
    for motor in sample(&member::<Motor<f64>>(strategy::float(0.9)), 5000, 1) {
        let (axis, angle) = motor.rotor().to_axis_angle();
        let shift = motor.translator().displacement();
        seen.insert(format!(
            "angle {}",
            (angle / std::f64::consts::FRAC_PI_4).floor()
        ));
        for k in 0..3 {
            seen.insert(format!("axis {k} {}", axis[k] > 0.0));
            seen.insert(format!("shift {k} {}", shift[k] > 0.0));
        }
    }
    for eighth in 0..8 {
        assert!(seen.contains(&format!("angle {eighth}")), "{seen:?}");
    }
    for what in ["axis", "shift"] {
        for k in 0..3 {
            for is_positive in [true, false] {
                assert!(
                    seen.contains(&format!("{what} {k} {is_positive}")),
                    "{seen:?}"
                );
            }
        }
    }
}
