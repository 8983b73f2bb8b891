//! Catmull–Rom, Hermite, Bézier, linear and step curves; integrals and lengths.

use ga_anim::curve::{ArcLength, BezierCurve, BezierKey, Curve, Outside};
use proptest::prelude::*;

#[test]
fn hermite_pieces_have_the_values_and_slopes_of_their_keys() {
    let times = [0.0, 0.5, 2.0];
    let (values, before, after) = ([1.0, -2.0, 4.0], [9.0, 3.0, -1.0], [0.5, -6.0, 9.0]);
    let curve = Curve::hermite(&times, &values, &before, &after).unwrap();
    for key in 0..3 {
        assert_eq!(curve.value(times[key]), values[key]);
    }
    assert_eq!([0.0, 0.5].map(|t| curve.derivative(t)), [0.5, -6.0]);
    let left = curve.derivative(0.5_f64.next_down());
    assert!((left - 3.0).abs() < 1e-12 && (curve.derivative(2.0) + 1.0).abs() < 1e-12);
    // The weights of glTF 2.0, appendix C.5, at a third of the second piece.
    let (s, h) = (1.0 / 3.0, 1.5);
    let (s2, s3) = (s * s, s * s * s);
    let expected = (2.0 * s3 - 3.0 * s2 + 1.0) * -2.0
        + h * (s3 - 2.0 * s2 + s) * -6.0
        + (3.0 * s2 - 2.0 * s3) * 4.0
        + -(h * (s3 - s2));
    assert!((curve.value(1.0) - expected).abs() < 1e-14);
}

/// The recursion of Barry and Goldman, without slopes.
fn barry_goldman(t: [f64; 4], p: [f64; 4], at: f64) -> f64 {
    let mix = |t0: f64, t1: f64, a: f64, b: f64| ((t1 - at) * a + (at - t0) * b) / (t1 - t0);
    let a: Vec<f64> = (0..3)
        .map(|i| mix(t[i], t[i + 1], p[i], p[i + 1]))
        .collect();
    let b: Vec<f64> = (0..2)
        .map(|i| mix(t[i], t[i + 2], a[i], a[i + 1]))
        .collect();
    mix(t[1], t[2], b[0], b[1])
}

proptest! {
    #[test]
    fn catmull_rom_is_the_recursion_of_barry_and_goldman(
        gaps in prop::array::uniform3(0.05..3.0_f64),
        values in prop::array::uniform4(-10.0..10.0_f64),
        part in 0.0..1.0_f64,
    ) {
        let times = [0.0, gaps[0], gaps[0] + gaps[1], gaps[0] + gaps[1] + gaps[2]];
        let curve = Curve::catmull_rom(&times, &values).unwrap();
        let at = times[1] + part * gaps[1];
        let expected = barry_goldman(times, values, at);
        prop_assert!((curve.value(at) - expected).abs() < 1e-10, "{} {expected}", curve.value(at));
    }

    #[test]
    fn handles_at_thirds_give_a_cubic_in_time(
        values in prop::array::uniform4(-10.0..10.0_f64),
        h in 0.01..100.0_f64,
        part in 0.0..1.0_f64,
    ) {
        let [a, b, c, d] = values;
        let curve = Curve::bezier(&[1.0, 1.0 + h], &[a, d], &[0.0, c], &[b, 0.0]).unwrap();
        let (t1, t2) = (1.0 + h / 3.0, 1.0 + 2.0 * h / 3.0);
        let keys = [
            BezierKey { time: 1.0, value: a, before: (0.0, 0.0), after: (t1, b) },
            BezierKey { time: 1.0 + h, value: d, before: (t2, c), after: (0.0, 0.0) },
        ];
        let keyed = BezierCurve::new(&keys).unwrap();
        let t = 1.0 + part * h;
        // By de Casteljau.
        let u = (t - 1.0) / h;
        let mut points = values;
        for count in (1..4).rev() {
            for k in 0..count {
                points[k] += (points[k + 1] - points[k]) * u;
            }
        }
        prop_assert!((curve.value(t) - points[0]).abs() < 1e-11);
        prop_assert!((keyed.value(t) - points[0]).abs() < 1e-11);
    }

    #[test]
    fn the_parameter_of_a_bezier_key_is_found(
        handles in prop::array::uniform2(0.0..=1.0_f64),
        u in 0.0..=1.0_f64,
    ) {
        // The value is the parameter itself where the handles' values are at thirds.
        let keys = [
            BezierKey { time: 0.0, value: 0.0, before: (0.0, 0.0), after: (handles[0], 1.0 / 3.0) },
            BezierKey { time: 1.0, value: 1.0, before: (handles[1], 2.0 / 3.0), after: (1.0, 0.0) },
        ];
        let curve = BezierCurve::new(&keys).unwrap();
        let v = 1.0 - u;
        let time = 3.0 * v * v * u * handles[0] + 3.0 * v * u * u * handles[1] + u * u * u;
        let found = curve.value(time);
        // Where time stands still many parameters are nearly right: compare times.
        let w = 1.0 - found;
        let back = 3.0 * w * w * found * handles[0] + 3.0 * w * found * found * handles[1] + found.powi(3);
        prop_assert!((back - time).abs() < 1e-14, "{found} {u}");
    }

    #[test]
    fn an_integral_is_the_sum_of_its_parts(
        values in prop::collection::vec(-5.0..5.0_f64, 4),
        cuts in prop::array::uniform3(-7.0..12.0_f64),
        repeat: bool,
    ) {
        let outside = if repeat { Outside::Repeat } else { Outside::Hold };
        let curve = Curve::catmull_rom(&[0.0, 1.0, 2.5, 4.0], &values).unwrap().with_outside(outside);
        let [a, b, c] = cuts;
        let part = |from, to| curve.integral(from, to).unwrap();
        prop_assert!((part(a, b) + part(b, c) - part(a, c)).abs() < 1e-11);
        // By Simpson's rule in steps so short that no key matters.
        let steps = 20_000;
        let h = (b - a) / f64::from(steps);
        let simpson: f64 = (0..steps)
            .map(|i| {
                let t = a + h * f64::from(i);
                h / 6.0 * (curve.value(t) + 4.0 * curve.value(t + 0.5 * h) + curve.value(t + h))
            })
            .sum();
        prop_assert!((part(a, b) - simpson).abs() < 2e-2, "{} {simpson}", part(a, b));
    }
}

#[test]
fn steps_and_lines() {
    let times = [0.0, 1.0, 3.0];
    let step = Curve::step(&times, &[5.0, 6.0, 7.0]).unwrap();
    let at = [-1.0, 0.0, 0.99, 1.0, 2.9, 3.0, 4.0];
    assert_eq!(
        at.map(|t| step.value(t)),
        [5.0, 5.0, 5.0, 6.0, 6.0, 7.0, 7.0]
    );
    let line = Curve::linear(&times, &[5.0, 6.0, 2.0]).unwrap();
    assert_eq!([0.25, 2.0, 9.0].map(|t| line.value(t)), [5.25, 4.0, 2.0]);
    assert_eq!(
        [0.5, 1.0, 3.0, 4.0].map(|t| line.derivative(t)),
        [1.0, -2.0, -2.0, 0.0]
    );
    let one = Curve::linear(&[2.0], &[[1.0, 2.0]]).unwrap();
    assert_eq!(
        [one.value(-1.0), one.value(2.0), one.value(9.0)],
        [[1.0, 2.0]; 3]
    );
    assert_eq!(one.integral(0.0, 2.0), Some([2.0, 4.0]));
    assert_eq!(line.integral(f64::NAN, 1.0), None);
}

#[test]
fn lengths_in_closed_form() {
    // (t, t²) from 0 to 2: the length is ½ t √(1 + 4t²) + ¼ asinh 2t.
    let parabola = Curve::hermite(
        &[0.0, 2.0],
        &[[0.0, 0.0], [2.0, 4.0]],
        &[[1.0, 0.0], [1.0, 4.0]],
        &[[1.0, 0.0], [1.0, 4.0]],
    )
    .unwrap();
    let length = ArcLength::new(&parabola).unwrap();
    let exact = |t: f64| 0.5 * t * (1.0 + 4.0 * t * t).sqrt() + 0.25 * (2.0 * t).asinh();
    for t in [0.0, 0.3, 1.0, 1.9, 2.0] {
        assert!((length.at(t) - exact(t)).abs() < 1e-13, "{t}");
        assert!((length.time_at(exact(t)) - t).abs() < 1e-12, "{t}");
    }
    // (t², t³) from −1 to 1 has a cusp at 0: the length is 2 (13 √13 − 8)/27.
    let cusp = Curve::hermite(
        &[-1.0, 1.0],
        &[[1.0, -1.0], [1.0, 1.0]],
        &[[-2.0, 3.0], [2.0, 3.0]],
        &[[-2.0, 3.0], [2.0, 3.0]],
    )
    .unwrap();
    let exact = 2.0 * (13.0 * 13_f64.sqrt() - 8.0) / 27.0;
    assert!((ArcLength::new(&cusp).unwrap().total() - exact).abs() < 1e-12);
    // A number that rises by 4 and falls by 3.
    let there_and_back = Curve::linear(&[0.0, 1.0, 2.0], &[0.0, 4.0, 1.0]).unwrap();
    let length = ArcLength::new(&there_and_back).unwrap();
    assert!((length.total() - 7.0).abs() < 1e-13);
    assert_eq!(
        [length.at(-1.0), length.time_at(-1.0), length.time_at(9.0)],
        [0.0, 0.0, 2.0]
    );
}
