//! Similarities against plain Euclidean coordinates: `x' = s R x + t`.

use ga_runtime::cga3::{
    Bivector, Dilator, EvenVersor, Motor, Point, Rotor, Similarity, Translator,
};
use ga_runtime::testing::assert_close;
use nullcone_tests::plain::{dot, largest, largest_difference, rotated, unit, vector};
use proptest::prelude::*;

fn factor() -> impl Strategy<Value = f64> + Clone {
    (-3.0..3.0).prop_map(f64::exp)
}

fn similarity(t: [f64; 3], axis: [f64; 3], angle: f64, factor: f64) -> Similarity<f64> {
    let rotor = Rotor::from_axis_angle(axis, angle).expect("an axis");
    Similarity::from_parts(t, rotor, factor).expect("finite and positive")
}

fn coefficients(s: Similarity<f64>) -> [f64; 12] {
    [
        s.scalar(),
        s.e12(),
        s.e13(),
        s.e23(),
        s.e1i(),
        s.e2i(),
        s.e3i(),
        s.e123i(),
        s.eoi(),
        s.e12oi(),
        s.e13oi(),
        s.e23oi(),
    ]
}

/// The largest difference, relative to the largest coefficient.
fn deviation(found: Similarity<f64>, expected: Similarity<f64>) -> f64 {
    let (a, b) = (coefficients(found), coefficients(expected));
    largest_difference(a, b) / largest(b)
}

proptest! {
    #[test]
    fn points_are_scaled_rotated_and_translated(
        t in vector(5.0), n in unit(), angle in -6.0..6.0, s in factor(), x in vector(5.0)
    ) {
        let similarity = similarity(t, n, angle, s);
        let turned = rotated(n, angle, x);
        let expected = [0, 1, 2].map(|k| s * turned[k] + t[k]);
        assert_close!(similarity.transform_point(Point::from(x)).coordinates(), expected, 1e-13, 100.0);
        // The parts come back, the rotor up to its sign.
        assert_close!(similarity.factor(), s, 1e-14);
        assert_close!(similarity.displacement(), t, 1e-13, 5.0);
        let motor: Motor<f64> = Translator::from_displacement(t) * Rotor::from_axis_angle(n, angle).expect("an axis");
        assert_close!(similarity.motor(), motor, 1e-13, 5.0);
        let composed = similarity.motor() * Dilator::from_factor(similarity.factor()).expect("positive");
        prop_assert!(deviation(composed, similarity) < 1e-13);
    }

    #[test]
    fn one_point_stays(t in vector(5.0), n in unit(), angle in -6.0..6.0, s in factor()) {
        prop_assume!((s - 1.0).abs() > 1e-2);
        let similarity = similarity(t, n, angle, s);
        let fixed = similarity.fixed_point().expect("a factor off 1");
        let size = 100.0 * (1.0 + dot(fixed.coordinates(), fixed.coordinates()));
        assert_close!(similarity.transform_point(fixed).coordinates(), fixed.coordinates(), 1e-13, size);
    }

    #[test]
    fn scalings_about_a_point(c in vector(5.0), s in factor(), x in vector(5.0)) {
        let scaling = Dilator::from_factor(s).expect("positive").about(Point::from(c));
        let expected = [0, 1, 2].map(|k| c[k] + s * (x[k] - c[k]));
        assert_close!(scaling.transform_point(Point::from(x)).coordinates(), expected, 1e-13, 100.0);
        let direct = Translator::from_displacement(c)
            * (Dilator::from_factor(s).expect("positive") * Translator::from_displacement(c.map(|x| -x)));
        prop_assert!(deviation(direct, scaling) < 1e-13);
    }

    #[test]
    fn exponential_and_logarithm_undo_each_other(
        t in vector(5.0), n in unit(), angle in 0.0..6.2, s in factor()
    ) {
        let similarity = similarity(t, n, angle, s);
        let log = similarity.log();
        prop_assert!(deviation(log.exp().expect("in range"), similarity) < 1e-13);
        // The coefficients of the generator are half the angle and half the logarithm of the
        // factor.
        assert_close!(log.eoi, s.ln() / 2.0, 1e-13, 1.0);
        assert_close!(dot([log.e23, -log.e13, log.e12], n), -angle / 2.0, 1e-12);
        let root = similarity.sqrt().expect("in range");
        prop_assert!(deviation(root * root, similarity) < 1e-13);
        assert_close!(root.factor(), s.sqrt(), 1e-13);
    }

    #[test]
    fn factors_close_to_one(t in vector(5.0), n in unit(), angle in 0.1..6.0, exponent in 3_i32..18) {
        let s = 1.0 + 10_f64.powi(-exponent);
        let near = similarity(t, n, angle, s);
        let motor = Translator::from_displacement(t) * Rotor::from_axis_angle(n, angle).expect("an axis");
        let (found, expected) = (near.log(), motor.log());
        let difference = Bivector::from(found) - Bivector::from(expected);
        // The generator changes by the change of the factor times the translation.
        let bound = 100.0 * (s - 1.0) / (6.3 - angle) + 1e-12;
        prop_assert!(difference.e1i.abs().max(difference.e2i.abs()).max(difference.e3i.abs()) < bound);
        prop_assert!(deviation(found.exp().expect("in range"), near) < 1e-13);
        prop_assert!(((found.eoi + found.eoi).exp() / s - 1.0).abs() < 1e-15);
        let whole = Similarity::from(motor);
        prop_assert!(deviation(whole.log().exp().expect("in range"), whole) < 1e-13);
    }

    /// About a fixed point, the interpolation is a spiral: the angle grows linearly, the distance
    /// geometrically.
    #[test]
    fn the_way_between_is_a_spiral(
        c in vector(3.0), n in unit(), angle in -3.0..3.0, s in factor(), x in vector(3.0), time in 0.0..1.0
    ) {
        let about = |angle: f64, s: f64| {
            let there = Translator::from_displacement(c);
            there * (similarity([0.0; 3], n, angle, s) * there.inverse())
        };
        let start = about(0.4, 2.0);
        let end = about(0.4 + angle, 2.0 * s);
        for end in [end, -end] {
            let between = start.interpolate(end, time).expect("in range");
            let from_centre = [0, 1, 2].map(|k| x[k] - c[k]);
            let turned = rotated(n, 0.4 + time * angle, from_centre);
            let ratio = 2.0 * s.powf(time);
            let expected = [0, 1, 2].map(|k| c[k] + ratio * turned[k]);
            assert_close!(between.transform_point(Point::from(x)).coordinates(), expected, 1e-12, 100.0);
        }
        prop_assert!(deviation(start.interpolate(end, 0.0).expect("in range"), start) < 1e-15);
    }
}

#[test]
fn factors_of_every_size() {
    for exponent in (-300..=300).step_by(20) {
        let s = 10_f64.powi(exponent);
        let similarity = similarity([0.0; 3], [0.0, 0.0, 1.0], 1.0, s);
        assert!((similarity.factor() / s - 1.0).abs() < 1e-14);
        let log = similarity.log();
        assert!(
            (log.eoi - s.ln() / 2.0).abs() <= 1e-15 * (1.0 + s.ln().abs()),
            "1e{exponent}: {}",
            log.eoi
        );
        assert!((log.e12 + 0.5).abs() < 1e-13);
        // e to the power of 700 has an error of 700 ε.
        assert!(deviation(log.exp().expect("in range"), similarity) < 2e-13);
    }
}

#[test]
fn the_negative_of_a_similarity_adds_a_full_rotation() {
    let growth = Dilator::from_factor(4.0)
        .expect("positive")
        .about(Point::new(1.0, 2.0, 3.0));
    let turn = similarity([1.0, 2.0, 3.0], [0.0, 0.6, 0.8], 1.0, 3.0);
    for versor in [-Similarity::default(), -growth, -turn] {
        let log = versor.log();
        let angle = (log.e12 * log.e12 + log.e13 * log.e13 + log.e23 * log.e23).sqrt();
        assert!(angle > 2.0);
        assert!(deviation(log.exp().expect("in range"), versor) < 1e-14);
    }
}

#[test]
fn numbers_that_are_not_a_similarity_are_refused() {
    let rotor = Rotor::default();
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Similarity::from_parts([0.0; 3], rotor, factor), None);
    }
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(Similarity::from_parts([0.0, bad, 0.0], rotor, 2.0), None);
        assert_eq!(Similarity::<f64>::default().powf(bad), None);
    }
    let shift = Similarity::from_parts([1.0, 0.0, 0.0], rotor, 1.0).expect("positive");
    assert_eq!(shift.fixed_point(), None);
    assert_eq!(shift.displacement(), [1.0, 0.0, 0.0]);
    assert_eq!(
        (shift.log() * 1e3).exp().expect("in range").displacement(),
        [1e3, 0.0, 0.0]
    );
    let growth = Dilator::from_factor(10.0)
        .expect("positive")
        .about(Point::<f64>::default());
    assert_eq!(growth.powf(1e4), None);
}

#[test]
fn similarities_are_even_versors() {
    let similarity = similarity([1.0, 2.0, 3.0], [0.6, 0.0, 0.8], 2.0, 0.3);
    let point = Point::new(0.3, -0.2, 4.0);
    let image = EvenVersor::from(similarity)
        .transform_point(point)
        .expect("a point");
    assert_close!(image, similarity.transform_point(point), 1e-14);
}

#[test]
fn dilators_take_points_to_points() {
    let double = Dilator::from_factor(2.0_f64).expect("positive");
    assert_close!(
        double.transform_point(Point::new(1.0, -2.0, 3.0)),
        Point::new(2.0, -4.0, 6.0),
        1e-14
    );
    assert_close!(double.log(), 2.0_f64.ln() / 2.0, 1e-15);
    assert_close!(double.powf(3.0).expect("in range").factor(), 8.0, 1e-14);
    assert_eq!(double.powf(f64::NAN), None);
    assert_eq!(double.powf(1e5), None);
    let slightly = Dilator::from_factor(1.0 + 1e-12_f64).expect("positive");
    assert!((slightly.log() / (0.5e-12 * (1.0 + 8.890_058_2e-5)) - 1.0).abs() < 1e-9);
}
