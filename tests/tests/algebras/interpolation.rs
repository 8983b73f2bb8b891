//! Powers and interpolation of motions and similarities of cga2, against complex numbers.

use std::f64::consts::PI;

use ga_runtime::cga2::{Motor, Point, Rotor, Similarity, Translator};
use nullcone_tests::plain::near_all;
use proptest::prelude::*;

use super::plane::{Vector, length, minus, plus, rotated, times, vector};

/// `z ↦ s exp(iθ) (z − c) + c`.
fn spiral(c: Vector, angle: f64, factor: f64, x: Vector) -> Vector {
    plus(c, times(rotated(minus(x, c), angle), factor))
}

fn about(c: Vector, angle: f64) -> Motor<f64> {
    Motor::about(Point::from(c), Rotor::from_angle(angle).expect("an angle"))
}

/// The similarity about a fixed point.
fn similarity(c: Vector, angle: f64, factor: f64) -> Similarity<f64> {
    let origin = spiral(c, angle, factor, [0.0; 2]);
    let rotor = Rotor::from_angle(angle).expect("an angle");
    Similarity::from_parts(origin, rotor, factor).expect("a positive factor")
}

proptest! {
    #[test]
    fn motions_are_interpolated_about_one_point(
        a in vector(3.0), first in -3.0..3.0_f64, c in vector(3.0), angle in -3.1..3.1_f64, t in -0.5..1.5_f64, x in vector(3.0),
    ) {
        let (start, between) = (about(a, first), about(c, angle));
        for end in [start * between, -(start * between)] {
            let found = start.interpolate(end, t).transform(Point::from(x)).coordinates();
            let expected = spiral(a, first, 1.0, spiral(c, angle * t, 1.0, x));
            near_all(found, expected, 1e-12);
            let rotor = start.rotor().interpolate(end.rotor(), t);
            let turned = rotor.transform(Point::from(x)).coordinates();
            near_all(turned, rotated(x, first + angle * t), 1e-13);
        }
        let power = between.powf(t).unwrap().transform(Point::from(x)).coordinates();
        near_all(power, spiral(c, angle * t, 1.0, x), 1e-12);
    }

    #[test]
    fn similarities_are_interpolated_along_spirals(
        a in vector(3.0), first in -3.0..3.0_f64, c in vector(3.0), angle in -3.1..3.1_f64, factor in 0.1..9.0_f64, t in -0.5..1.5_f64, x in vector(3.0),
    ) {
        let (start, between) = (similarity(a, first, 0.7), similarity(c, angle, factor));
        near_all([between.factor()], [factor], 1e-13 * factor);
        for end in [start * between, -(start * between)] {
            let found = start.interpolate(end, t).unwrap().transform_point(Point::from(x));
            let expected = spiral(a, first, 0.7, spiral(c, angle * t, factor.powf(t), x));
            near_all(found.coordinates(), expected, 1e-10);
        }
        near_all(between.transform_point(Point::from(x)).coordinates(), spiral(c, angle, factor, x), 1e-12);
        near_all(between.displacement(), spiral(c, angle, factor, [0.0; 2]), 1e-12);
        let rotor = between.rotor();
        near_all(rotor.transform(Point::from(x)).coordinates(), rotated(x, angle), 1e-12);
    }

    /// Without or nearly without rotation and scaling the fixed point is far away, and the path
    /// nearly straight.
    #[test]
    fn translations_are_interpolated_along_straight_lines(d in vector(3.0), t in -0.5..1.5_f64, exponent in -20.0..-8.0_f64) {
        let small = 10_f64.powf(exponent);
        for (angle, factor) in [(0.0, 1.0), (small, 1.0), (0.0, 1.0 + small), (-small, 1.0 - small)] {
            let rotor = Rotor::from_angle(angle).unwrap();
            let end = Similarity::from_parts(d, rotor, factor).unwrap();
            let found = Similarity::default().interpolate(end, t).unwrap();
            near_all(found.displacement(), times(d, t), 1e-7);
            let motor = Translator::from_displacement(d) * rotor;
            let found = Motor::default().interpolate(motor, t).translator();
            near_all(found.displacement(), times(d, t), 1e-7);
        }
    }
}

#[test]
fn ends_without_a_power() {
    let shift = Motor::from(Translator::from_displacement([1.0, 0.0]));
    assert_eq!((-shift).powf(0.5), None);
    let back = Similarity::from(-shift);
    assert_eq!(back.powf(0.5), None);
    // −1 is a full turn about any point.
    let turn = (-Similarity::<f64>::default()).powf(0.5).unwrap();
    near_all(
        turn.transform_point(Point::new(1.0, 2.0)).coordinates(),
        [-1.0, -2.0],
        1e-15,
    );
    assert_eq!(Similarity::<f64>::default().powf(f64::NAN), None);
    assert_eq!(
        Similarity::from_parts([0.0; 2], Rotor::default(), -1.0),
        None
    );
    assert_eq!(
        Similarity::from_parts([f64::INFINITY, 0.0], Rotor::default(), 1.0),
        None
    );
    // Half a turn: the shorter of two equal ways is still a rotation about the same point.
    let half_turn = about([1.0, 0.0], PI);
    let middle = Motor::default()
        .interpolate(half_turn, 0.5)
        .transform(Point::new(1.0, 1.0));
    near_all(
        [length(minus(middle.coordinates(), [1.0, 0.0]))],
        [1.0],
        1e-15,
    );
    near_all([(middle.y()).abs()], [0.0], 1e-15);
}

#[test]
fn motions_beyond_the_range_are_interpolated_by_nan() {
    let far = |x: f64| Motor::from(Translator::from_displacement([x, 0.0]));
    // The motion between the two is beyond the range, each of them is not.
    let half_turn = Rotor::from_angle(PI).unwrap();
    let end = far(1.7e308) * half_turn;
    assert!(end.e1i().is_finite() && end.e2i().is_finite());
    let found = far(-1.7e308).interpolate(end, 0.5);
    assert!(found.e1i().is_nan() && found.e2i().is_nan());
    assert!(far(f64::NAN).interpolate(far(1.0), 0.5).e1i().is_nan());
    let middle = far(-1e300).interpolate(far(3e300), 0.5).translator();
    assert!((middle.displacement()[0] / 1e300 - 1.0).abs() < 1e-15);
}
