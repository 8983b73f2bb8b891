//! Normalisation and geometry in cga3 for numbers of every magnitude.

use ga_runtime::cga3::{
    Circle, Dilator, DualQuaternion, FlatPoint, Line, Motor, MotorGenerator, Plane, Point, Rotor,
    RoundVector, Sphere,
};
use nullcone_tests::plain::motor_coefficients;

/// The dual quaternion `size (1 + 2 e12 + 2 e13 + 4 e23 + 25 shift e123i)`, whose length is 5 size.
/// With `M ~M = size² (25 + 50 shift e123i)` the nearest motor is `(1 + 2 e12 + 2 e13 + 4 e23)(1 −
/// shift e123i)/5 + 5 shift e123i`.
fn sum(size: f64, shift: f64) -> DualQuaternion<f64> {
    let [one, two, four] = [1.0, 2.0, 4.0].map(|x| x * size);
    DualQuaternion::new(one, two, two, four, 0.0, 0.0, 0.0, 25.0 * size * shift)
}

/// `e12 e123i = −e3i`, `e13 e123i = e2i` and `e23 e123i = −e1i`.
fn nearest(shift: f64) -> [f64; 8] {
    let [a, b, c, d] = [0.8, -0.4, 0.4, 4.8].map(|x| x * shift);
    [0.2, 0.4, 0.4, 0.8, a, b, c, d]
}

fn check(motor: Motor<f64>, expected: [f64; 8], what: &str) {
    for (found, expected) in motor_coefficients(motor).into_iter().zip(expected) {
        let deviation = (found - expected).abs();
        assert!(
            deviation <= 1e-15 * expected.abs(),
            "{what}: {found} for {expected}"
        );
    }
}

#[test]
fn length_and_study_condition_are_repaired_at_every_size() {
    for exponent in -300..=300 {
        let size = 10_f64.powi(exponent);
        let motor = sum(size, 1.0).normalize().expect("finite and not zero");
        check(motor, nearest(1.0), &format!("1e{exponent}"));
    }
}

#[test]
fn rotation_and_translation_may_differ_in_size() {
    for (turn, shift) in [
        (-200, 150),
        (-150, -150),
        (150, -150),
        (0, 300),
        (140, 160),
        (300, -300),
    ] {
        let (size, shift) = (10_f64.powi(turn), 10_f64.powi(shift));
        let motor = sum(size, shift).normalize().expect("finite and not zero");
        check(motor, nearest(shift), &format!("{size:e}, {shift:e}"));
    }
}

#[test]
fn single_precision_at_every_size() {
    for exponent in -36..=36 {
        let size = 10_f64.powi(exponent) as f32;
        let [one, two, four, shift] = [1.0, 2.0, 4.0, 25.0].map(|x| x * size);
        let sum = DualQuaternion::new(one, two, two, four, 0.0, 0.0, 0.0, shift);
        let motor = sum.normalize().expect("finite and not zero");
        let found = [motor.scalar(), motor.e23(), motor.e1i(), motor.e123i()];
        for (found, expected) in found.into_iter().zip([0.2, 0.8, 0.8, 4.8]) {
            assert!(
                (found / expected - 1.0_f32).abs() <= 6e-7,
                "1e{exponent}: {found}"
            );
        }
    }
}

#[test]
fn quaternions_of_the_smallest_and_largest_numbers_rotate() {
    for size in [f64::from_bits(1), f64::MIN_POSITIVE, f64::MAX] {
        let rotor = Rotor::from_quaternion([0.0, -size, 0.0], 0.0).expect("not zero");
        assert_eq!(rotor.to_quaternion(), ([0.0, -1.0, 0.0], 0.0));
    }
}

#[test]
fn dual_quaternions_without_a_nearest_motor_give_none() {
    let with = |scalar, e123i| DualQuaternion::new(scalar, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, e123i);
    let none = [
        with(0.0, 0.0),
        with(0.0, 1.0),
        with(f64::NAN, 0.0),
        with(f64::INFINITY, 0.0),
        with(1.0, f64::NAN),
        with(1.0, f64::INFINITY),
    ];
    assert_eq!(none.map(DualQuaternion::normalize), [None; 6]);
    let too_far = DualQuaternion::new(1e-200, 0.0, 0.0, 0.0, 1e200, 0.0, 0.0, 0.0);
    assert_eq!(
        too_far.normalize(),
        None,
        "the translation is beyond the range"
    );
}

#[test]
fn factors_of_dilators_survive_a_round_trip_at_every_size() {
    for exponent in -300..=300 {
        let factor = 10_f64.powi(exponent);
        let found = Dilator::from_factor(factor).expect("positive").factor();
        assert!(
            (found / factor - 1.0).abs() <= 1e-15,
            "1e{exponent}: {found}"
        );
    }
}

#[test]
fn planes_and_lines_measure_at_every_size() {
    let origin = Point::<f64>::default();
    for size in [1e-300, 1e-200, 1.0, 1e200, 1e300] {
        let plane = Plane::from_point_normal(origin, [0.0, -size, 0.0]);
        let distance = plane.signed_distance(Point::new(0.0, 1e200, 0.0));
        assert_eq!(distance, Some(-1e200), "normal of length {size:e}");
        let line = Line::from_point_direction(Point::new(0.0, 3.0, 0.0), [size, 0.0, 0.0]);
        let place = line.foot(Point::new(5.0, 7.0, 4.0)).expect("a direction");
        assert!((place.distance(Point::new(5.0, 3.0, 0.0))) < 1e-14);
    }
}

#[test]
fn rotations_by_large_angles_advance_far() {
    // The generator G = φ e12 + h e3i: exp G = (cos φ + sin φ e12)(1 + h e3i), as both commute and
    // (h e3i)² = 0.
    for (angle, shift) in [
        (1e200_f64, 1e200),
        (1e160, -3e-200),
        (2.0, 1e300),
        (1e-200, 1e200),
        (0.3, 1e250),
    ] {
        let motor = MotorGenerator::new(angle, 0.0, 0.0, 0.0, 0.0, shift).exp();
        let (sine, cosine) = angle.sin_cos();
        let expected = [
            cosine,
            sine,
            0.0,
            0.0,
            0.0,
            0.0,
            shift * cosine,
            shift * sine,
        ];
        for (found, expected) in motor_coefficients(motor).into_iter().zip(expected) {
            let deviation = (found - expected).abs();
            assert!(
                deviation <= 1e-15 * expected.abs(),
                "{angle:e}: {found} for {expected}"
            );
        }
    }
}

fn is_finite(point: Point<f64>) -> bool {
    point.coordinates().into_iter().all(f64::is_finite)
}

#[test]
fn values_read_back_are_finite_or_none() {
    let sizes = [
        0.0,
        1e-320,
        1e-300,
        -1e-160,
        1.0,
        1e160,
        -1e200,
        1e300,
        f64::MAX,
    ];
    let place = |seed: usize| {
        let at = |k: usize| sizes[(seed / [1, 9, 81][k] + k * seed) % 9];
        Point::new(at(0), at(1), at(2))
    };
    for seed in 0..2187 {
        let [p, q, r, s] = [1, 2, 5, 7].map(|k| place(seed * k + k));
        let line = Line::through(p, q);
        let points = [
            line.support(),
            line.foot(r),
            Circle::through(p, q, r).centre(),
            Sphere::through(p, q, r, s).centre(),
            RoundVector::new(p.e1(), p.e2(), p.e3(), q.e1(), q.e2()).centre(),
            FlatPoint::new(p.e1(), p.e2(), p.e3(), q.e1()).to_point(),
            line.normalized().map(|line| line.moment().into()),
            Circle::from_centre_normal_radius(p, q.coordinates(), r.e1()).and_then(Circle::centre),
        ];
        assert!(points.into_iter().flatten().all(is_finite), "{p} {q} {r}");
        let numbers = [
            Plane::through(p, q, r).signed_distance(s),
            Plane::from_point_normal(p, q.coordinates()).signed_distance(r),
            Circle::through(p, q, r).radius_squared(),
            Sphere::through(p, q, r, s).radius_squared(),
            Sphere::from_centre_radius(p, q.e1()).radius_squared(),
        ];
        assert!(
            numbers.into_iter().flatten().all(f64::is_finite),
            "{p} {q} {r} {s}"
        );
    }
}
