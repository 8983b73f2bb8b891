//! The bound of resampled curves holds wherever it is tried.

use ga_anim::curve::{Curve, CurveError, Distance, Ends, Resampled};
use proptest::collection::vec;
use proptest::prelude::*;

/// The distance from a point to a segment.
fn to_segment<const N: usize>(p: [f64; N], a: [f64; N], b: [f64; N]) -> f64 {
    let dot = |u: [f64; N], v: [f64; N]| u.iter().zip(v).map(|(u, v)| u * v).sum::<f64>();
    let minus = |u: [f64; N], v: [f64; N]| std::array::from_fn(|k| u[k] - v[k]);
    let (d, e): ([f64; N], [f64; N]) = (minus(b, a), minus(p, a));
    let place = if dot(d, d) > 0.0 {
        (dot(e, d) / dot(d, d)).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let rest: [f64; N] = std::array::from_fn(|k| e[k] - place * d[k]);
    dot(rest, rest).sqrt()
}

/// The largest distance at many times in each chord.
fn sampled<const N: usize>(
    curve: &Curve<[f64; N]>,
    found: &Resampled<[f64; N]>,
    distance: Distance,
    samples: usize,
) -> f64 {
    let mut largest = 0.0_f64;
    for (times, ends) in found.times.windows(2).zip(found.values.windows(2)) {
        let mut parts: Vec<f64> = (1..samples).map(|i| i as f64 / samples as f64).collect();
        // Keys are where the second derivative has its extremes.
        let inner = curve
            .times()
            .iter()
            .filter(|&&t| times[0] < t && t < times[1]);
        parts.extend(inner.map(|t| (t - times[0]) / (times[1] - times[0])));
        for part in parts {
            let t = times[0] + part * (times[1] - times[0]);
            let p = curve.value(t);
            let apart = match distance {
                Distance::Geometric => to_segment(p, ends[0], ends[1]),
                Distance::EqualTime => {
                    let part = (t - times[0]) / (times[1] - times[0]);
                    let q: [f64; N] =
                        std::array::from_fn(|k| ends[0][k] + part * (ends[1][k] - ends[0][k]));
                    to_segment(p, q, q)
                }
            };
            largest = largest.max(apart);
        }
    }
    largest
}

/// Fails unless the vertices are on the curve, from end to end, and the bound holds at samples.
fn check<const N: usize>(curve: &Curve<[f64; N]>, tolerance: f64, distance: Distance) -> usize {
    let found = curve.resampled(tolerance, distance).unwrap();
    let count = found.times.len();
    assert_eq!(found.values.len(), count);
    assert_eq!(
        (found.times[0], found.times[count - 1]),
        (curve.start(), curve.end())
    );
    assert!(found.times.windows(2).all(|pair| pair[0] < pair[1]));
    for (&time, &value) in found.times.iter().zip(&found.values) {
        assert_eq!(value, curve.value(time));
    }
    assert!(found.max_deviation <= tolerance);
    let largest = found
        .values
        .iter()
        .flatten()
        .fold(0.0_f64, |m, x| m.max(x.abs()));
    // What the distances of this test may be wrong by.
    let rounding = 8.0 * largest * f64::EPSILON;
    let samples = (20_000 / count).clamp(20, 2000);
    let apart = sampled(curve, &found, distance, samples);
    assert!(
        apart <= found.max_deviation + rounding,
        "{apart:e} beyond {:e} with {count} vertices",
        found.max_deviation
    );
    count
}

/// Keys with repeated values, straight parts and gaps of very different sizes, far from the origin
/// or near.
fn keys() -> impl Strategy<Value = (Vec<f64>, Vec<[f64; 3]>)> {
    let place = prop_oneof![
        3 => prop::array::uniform3(-1.0..1.0_f64),
        1 => Just([0.5, -0.5, 0.25]),
        1 => (0..4_i32).prop_map(|i| [f64::from(i), 0.0, 0.0]),
    ];
    let offset = prop_oneof![Just(0.0), Just(1e6), Just(-3e9)];
    let size = prop_oneof![Just(1.0), Just(1e-5), Just(1e5)];
    (vec((-3.0..1.5_f64, place), 2..12), offset, size).prop_map(|(list, offset, size)| {
        let mut time = 0.0;
        let times = list.iter().map(|(gap, _)| {
            time += gap.exp();
            time
        });
        let values = list
            .iter()
            .map(|(_, place)| place.map(|x| offset + size * x));
        (times.collect(), values.collect())
    })
}

fn extent(values: &[[f64; 3]]) -> (f64, f64) {
    let largest = values.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    let size = (0..3).map(|k| {
        let column = values.iter().map(|v| v[k]);
        column.clone().fold(f64::MIN, f64::max) - column.fold(f64::MAX, f64::min)
    });
    (largest, size.fold(0.0, f64::max))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn the_bound_holds_for_random_curves(
        (times, values) in keys(),
        power in -5.0..0.5_f64,
        ends in 0..4,
        equal_time: bool,
    ) {
        let (largest, size) = extent(&values);
        let curve = match ends {
            0 => Curve::spline(&times, &values, Ends::Natural),
            1 => Curve::spline(&times, &values, Ends::NotAKnot),
            2 => Curve::catmull_rom(&times, &values),
            _ => Curve::linear(&times, &values),
        }
        .unwrap();
        let least = 16.0 * (largest.next_up() - largest);
        let tolerance = (10_f64.powf(power) * size).max(least).max(1e-300);
        let distance = if equal_time { Distance::EqualTime } else { Distance::Geometric };
        check(&curve, tolerance, distance);
    }

    /// A curve so far from the origin that few bits are left for its shape.
    #[test]
    fn the_least_tolerance_can_be_proven(
        values in vec(prop::array::uniform3(-1.0..1.0_f64), 3..8),
        power in 4..13,
    ) {
        let offset = 10_f64.powi(power);
        let times: Vec<f64> = (0..values.len()).map(|i| i as f64).collect();
        let values: Vec<_> = values.into_iter().map(|v| v.map(|x| offset + x)).collect();
        let (largest, _) = extent(&values);
        let least = 16.0 * (largest.next_up() - largest);
        let curve = Curve::spline(&times, &values, Ends::Natural).unwrap();
        for distance in [Distance::Geometric, Distance::EqualTime] {
            if power >= 7 {
                check(&curve, least, distance);
            }
            let below = least.next_down();
            let expected = CurveError::TooFine { tolerance: below, least };
            prop_assert_eq!(curve.resampled(below, distance), Err(expected));
        }
    }
}

#[test]
fn straight_lines_need_two_vertices() {
    let times = [0.0, 1.0, 3.0, 3.5, 9.0];
    let line = [0.0, 2.0, 3.0, 7.0, 8.0].map(|x| [x, 2.0 * x, 1.0 - x]);
    let straight = Curve::linear(&times, &line).unwrap();
    assert_eq!(check(&straight, 1e-9, Distance::Geometric), 2);
    assert!(check(&straight, 1e-9, Distance::EqualTime) > 4);
    let overshooting = Curve::catmull_rom(&times, &line).unwrap();
    // Four turning points, each with at most three vertices about it.
    assert!(check(&overshooting, 1e-9, Distance::Geometric) <= 14);
    // At constant speed times do not matter.
    let even = times.map(|t| [t, -t, 0.0]);
    let curve = Curve::spline(&times, &even, Ends::Natural).unwrap();
    assert_eq!(check(&curve, 1e-9, Distance::EqualTime), 2);
    // Still.
    let still = Curve::spline(&times, &[[3.0; 3]; 5], Ends::Natural).unwrap();
    assert_eq!(check(&still, 1e-9, Distance::EqualTime), 2);
    let zero = Curve::linear(&times, &[[0.0; 3]; 5]).unwrap();
    assert_eq!(check(&zero, 1e-300, Distance::Geometric), 2);
}

#[test]
fn cusps_and_turning_points() {
    // (t², t³) from −1 to 1.
    let slopes = [[-2.0, 3.0], [2.0, 3.0]];
    let cusp = Curve::hermite(&[-1.0, 1.0], &[[1.0, -1.0], [1.0, 1.0]], &slopes, &slopes).unwrap();
    for tolerance in [1.0, 1e-2, 1e-5, 1e-9] {
        check(&cusp, tolerance, Distance::Geometric);
        check(&cusp, tolerance.max(1e-7), Distance::EqualTime);
    }
    // There and back on one line, where the chord from end to end has no length.
    let back = Curve::spline(
        &[0.0, 1.0, 2.0],
        &[[0.0, 0.0], [4.0, 2.0], [0.0, 0.0]],
        Ends::Natural,
    );
    let back = back.unwrap();
    assert!(check(&back, 1e-6, Distance::Geometric) <= 5);
    assert_eq!(check(&back, 10.0, Distance::Geometric), 2);
    // Once around and beyond.
    let round = Curve::spline(
        &[0.0, 1.0, 2.0, 3.0, 4.0],
        &[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]],
        Ends::Periodic,
    )
    .unwrap();
    let found = round.resampled(1e-3, Distance::Geometric).unwrap();
    // The fewest chords of a circle, π √(1/2ε).
    let fewest = std::f64::consts::PI * (0.5_f64 / 1e-3).sqrt();
    assert!(found.times.len() as f64 - 1.0 <= 1.04 * fewest + 1.0);
}

#[test]
fn equal_times_need_the_fewest_chords_too() {
    // t³/6 has c″ = t: from 0 to 1 the fewest chords are ∫ √(t/8ε) dt = √(1/8ε) · 2/3.
    let cube = Curve::hermite(&[0.0, 1.0], &[0.0, 1.0 / 6.0], &[0.0, 0.5], &[0.0, 0.5]).unwrap();
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let found = cube.resampled(tolerance, Distance::EqualTime).unwrap();
        let fewest = (0.125 / tolerance).sqrt() * 2.0 / 3.0;
        let chords = (found.times.len() - 1) as f64;
        assert!(chords <= (1.04 * fewest).ceil() + 1.0, "{chords} {fewest}");
        assert!(chords >= 0.99 * fewest);
    }
}

#[test]
fn what_cannot_be_resampled_is_said() {
    let times = [0.0, 1.0, 2.0];
    let curve = Curve::linear(&times, &[0.0, 1.0, 0.0]).unwrap();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = curve.resampled(bad, Distance::Geometric).unwrap_err();
        assert!(matches!(error, CurveError::Tolerance(_)), "{error}");
    }
    let step = Curve::step(&times, &[0.0, 1.0, 1.0]).unwrap();
    let error = step.resampled(0.1, Distance::EqualTime).unwrap_err();
    assert_eq!(error, CurveError::Jump { key: 1 });
    let error = curve
        .resampled_within(1e-3, Distance::EqualTime, 2)
        .unwrap_err();
    assert_eq!(
        error,
        CurveError::TooMany {
            tolerance: 1e-3,
            most: 2
        }
    );
    // Between neighbouring times near 1e16 lie 2 seconds.
    let late = [1e16, 1e16 + 4.0, 1e16 + 8.0];
    let late = Curve::spline(&late, &[0.0, 1.0, 0.0], Ends::Natural).unwrap();
    let error = late.resampled(1e-3, Distance::EqualTime).unwrap_err();
    assert!(matches!(error, CurveError::TimeTooCoarse { .. }), "{error}");
}

#[test]
fn huge_and_tiny_coordinates() {
    let times = [0.0, 1.0, 2.0, 3.0];
    for size in [1e-300, 1e-20, 1e150, 1e300] {
        let values =
            [[0.0, 1.0], [1.0, 0.5], [0.5, -1.0], [-0.25, 0.0]].map(|v| v.map(|x| x * size));
        let curve = Curve::spline(&times, &values, Ends::NotAKnot).unwrap();
        let found = curve.resampled(1e-4 * size, Distance::Geometric).unwrap();
        let plain = values.map(|v| v.map(|x| x / size));
        let plain = Curve::spline(&times, &plain, Ends::NotAKnot).unwrap();
        let expected = plain
            .resampled(1e-4, Distance::Geometric)
            .unwrap()
            .times
            .len();
        assert!(found.times.len().abs_diff(expected) <= 1);
    }
}
