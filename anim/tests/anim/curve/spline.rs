//! Laws of cubic splines.

use ga_anim::curve::{Curve, EndKind, Ends, SplineSystem};
use ga_runtime::vga3::Vector;
use proptest::collection::vec;
use proptest::prelude::*;

/// Times with gaps of very different sizes, and values.
fn keys(least: usize) -> impl Strategy<Value = (Vec<f64>, Vec<f64>)> {
    vec((-5.0..3.0_f64, -10.0..10.0_f64), least..40).prop_map(|list| {
        let mut time = -3.0;
        let times = list.iter().map(|(gap, _)| {
            time += gap.exp();
            time
        });
        (
            times.collect(),
            list.iter().map(|(_, value)| *value).collect(),
        )
    })
}

fn cubic([a, b, c, d]: [f64; 4], t: f64) -> [f64; 3] {
    [
        ((d * t + c) * t + b) * t + a,
        (3.0 * d * t + 2.0 * c) * t + b,
        6.0 * d * t + 2.0 * c,
    ]
}

proptest! {
    /// The largest of what both sides of each key say, in units of what is compared.
    #[test]
    fn two_derivatives_are_continuous((times, mut values) in keys(3), kind in 0..4) {
        let ends = match kind {
            0 => Ends::Natural,
            1 => Ends::Slopes([1.5, -2.0]),
            2 => Ends::NotAKnot,
            _ => {
                let last = values.len() - 1;
                values[last] = values[0];
                Ends::Periodic
            }
        };
        let curve = Curve::spline(&times, &values, ends).unwrap();
        let pieces = curve.pieces();
        // The condition of the rows grows with the ratio of the greatest to the least interval.
        let intervals = times.windows(2).map(|pair| pair[1] - pair[0]);
        let (least, greatest) = intervals.fold((f64::INFINITY, 0.0_f64), |(a, b), h| (a.min(h), b.max(h)));
        let bound = 1e-11_f64.max(1e-13 * greatest / least);
        // Rounding errors of one second derivative reach the others.
        let bent = pieces.iter().zip(&times).zip(&times[1..]).fold(0.0_f64, |m, ((piece, from), to)| {
            m.max(piece[2].abs()).max((piece[2] + 3.0 * piece[3] * (to - from)).abs())
        });
        let at_end = |i: usize| {
            let h = times[i + 1] - times[i];
            let scale = pieces[i].iter().zip([1.0, h, h * h, h * h * h])
                .fold(bent * h * h, |m, (c, power)| m.max((c * power).abs()));
            let [y, d, dd] = cubic(pieces[i], h);
            ([y, d * h, dd * h * h], h, scale)
        };
        for i in 0..pieces.len() {
            let (found, h, scale) = at_end(i);
            let next = match pieces.get(i + 1) {
                Some(&[a, b, c, _]) => Some([a, b * h, 2.0 * c * h * h]),
                None if ends == Ends::Periodic => {
                    let [a, b, c, _] = pieces[0];
                    Some([a, b * h, 2.0 * c * h * h])
                }
                None => {
                    prop_assert!((found[0] - values[i + 1]).abs() <= 1e-12 * scale);
                    None
                }
            };
            for (found, next) in found.into_iter().zip(next.into_iter().flatten()) {
                prop_assert!((found - next).abs() <= bound * scale.max(next.abs()), "{found} {next}");
            }
            prop_assert_eq!(pieces[i][0], values[i]);
        }
        let (start, end) = (times[0], times[times.len() - 1]);
        match ends {
            Ends::Natural => {
                prop_assert_eq!(curve.second_derivative(start), 0.0);
                prop_assert!(at_end(pieces.len() - 1).0[2].abs() <= 1e-11 * at_end(pieces.len() - 1).2);
            }
            Ends::Slopes(slopes) => {
                for (time, slope) in [start, end].into_iter().zip(slopes) {
                    let (_, h, scale) = at_end(if time == start { 0 } else { pieces.len() - 1 });
                    prop_assert!((curve.derivative(time) - slope).abs() * h < 1e-11 * scale.max(h));
                }
            }
            Ends::NotAKnot => {
                let [_, _, _, d] = pieces[0];
                let far = pieces[1][3];
                let sizes: f64 = pieces[..2].iter().zip(&times).zip(&times[1..])
                    .map(|((piece, from), to)| (piece[2] / (to - from)).abs()).sum();
                prop_assert!((d - far).abs() <= 1e-10 * (sizes + d.abs()));
            }
            Ends::Periodic => {}
        }
    }

    #[test]
    fn a_cubic_polynomial_is_its_own_spline(
        (times, _) in keys(4),
        c in prop::array::uniform4(-2.0..2.0_f64),
    ) {
        let values: Vec<f64> = times.iter().map(|&t| cubic(c, t)[0]).collect();
        let (start, end) = (times[0], times[times.len() - 1]);
        let slopes = [start, end].map(|t| cubic(c, t)[1]);
        let largest = times.iter().fold(1.0_f64, |m, t| m.max(t.abs()));
        let scale = 10.0 * largest.powi(3);
        for ends in [Ends::NotAKnot, Ends::Slopes(slopes)] {
            let curve = Curve::spline(&times, &values, ends).unwrap();
            for step in 0..=50 {
                let t = start + (end - start) * f64::from(step) / 50.0;
                prop_assert!((curve.value(t) - cubic(c, t)[0]).abs() < 1e-9 * scale);
            }
        }
    }

    #[test]
    fn channels_that_share_a_system_are_splines_of_their_own((times, values) in keys(2)) {
        let triple: Vec<[f64; 3]> = values.iter().map(|&v| [v, 1.0 - v, v * v]).collect();
        for kind in [EndKind::Natural, EndKind::Slopes, EndKind::NotAKnot] {
            let system = SplineSystem::new(&times, kind).unwrap();
            let together = system.fit(&triple).unwrap();
            let vectors: Vec<Vector<f64>> = triple.iter().copied().map(Vector::from).collect();
            let vectors = system.fit(&vectors).unwrap();
            for channel in 0..3 {
                let alone: Vec<f64> = triple.iter().map(|v| v[channel]).collect();
                let alone = system.fit(&alone).unwrap();
                for (piece, both) in alone.pieces().iter().zip(together.pieces()) {
                    for power in 0..4 {
                        prop_assert_eq!(piece[power], both[power][channel]);
                    }
                }
                let t = 0.5 * (times[0] + times[1]);
                prop_assert_eq!(alone.value(t), vectors.value(t)[channel]);
            }
        }
    }

    #[test]
    fn a_cursor_finds_what_bisection_finds(
        (times, values) in keys(1),
        queries in vec(-10.0..200.0_f64, 50),
        repeat: bool,
    ) {
        use ga_anim::curve::Outside;
        let outside = if repeat { Outside::Repeat } else { Outside::Hold };
        let curve = Curve::catmull_rom(&times, &values).unwrap().with_outside(outside);
        let mut queries: Vec<f64> = queries.into_iter().chain(times.iter().copied()).collect();
        queries.extend([f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
        for order in 0..3 {
            match order {
                1 => queries.sort_by(f64::total_cmp),
                2 => queries.reverse(),
                _ => {}
            }
            let mut cursor = curve.cursor();
            for &t in &queries {
                prop_assert_eq!(cursor.value(t), curve.value(t));
                prop_assert_eq!(cursor.derivative(t), curve.derivative(t));
                prop_assert_eq!(cursor.second_derivative(t), curve.second_derivative(t));
                prop_assert!(curve.value(t).is_finite());
            }
            let mut sampled = vec![0.0; queries.len()];
            curve.sample_into(&queries, &mut sampled).unwrap();
            prop_assert_eq!(sampled[3], curve.value(queries[3]));
        }
        for (&t, &value) in times.iter().zip(&values) {
            if !repeat {
                prop_assert_eq!(curve.value(t), value);
            }
        }
    }
}

/// The example of de Boor, "A Practical Guide to Splines", in closed form: the natural spline
/// through (0, 0), (1, 1), (2, 0) has the pieces (3t − t³)/2 and their mirror image.
#[test]
fn the_natural_spline_of_a_tent() {
    let curve = Curve::spline(&[0.0, 1.0, 2.0], &[0.0, 1.0, 0.0], Ends::Natural).unwrap();
    assert_eq!(curve.pieces()[0], [0.0, 1.5, 0.0, -0.5]);
    assert_eq!(curve.pieces()[1], [1.0, 0.0, -1.5, 0.5]);
}

#[test]
fn splines_of_two_keys() {
    let spline = |ends, values: [f64; 2]| Curve::spline(&[1.0, 3.0], &values, ends).unwrap();
    for ends in [Ends::Natural, Ends::NotAKnot] {
        assert_eq!(spline(ends, [1.0, 5.0]).pieces(), [[1.0, 2.0, 0.0, 0.0]]);
    }
    let given = spline(Ends::Slopes([1.0, -1.0]), [0.0, 2.0]);
    assert_eq!(
        (
            given.derivative(1.0),
            given.derivative(3.0),
            given.value(3.0)
        ),
        (1.0, -1.0, 2.0)
    );
    assert_eq!(spline(Ends::Periodic, [4.0, 4.0]).value(7.5), 4.0);
}
