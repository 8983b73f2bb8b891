//! Splines, their calculus and their resampling, against scipy.

use ga_anim::curve::{ArcLength, Curve, Distance, EndKind, Ends, SplineSystem, resample_channels};
use nullcone_shared_data::shared;
use serde_json::Value;

fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .unwrap()
        .iter()
        .map(|x| x.as_f64().unwrap())
        .collect()
}

/// The rows of a table.
fn table(value: &Value) -> Vec<Vec<f64>> {
    value.as_array().unwrap().iter().map(numbers).collect()
}

fn column(table: &[Vec<f64>], channel: usize) -> Vec<f64> {
    table.iter().map(|row| row[channel]).collect()
}

/// Fails unless each number is within 1e-13 × the largest expected one.
#[track_caller]
fn assert_all_near(found: &[Vec<f64>], expected: &[Vec<f64>], what: &str) {
    assert_near(found, expected, 0.0, what);
}

/// The same, or of `least` if that is larger.
#[track_caller]
fn assert_near(found: &[Vec<f64>], expected: &[Vec<f64>], least: f64, what: &str) {
    let largest = expected.iter().flatten().fold(least, |m, x| m.max(x.abs()));
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        let error = (found - expected).abs();
        assert!(
            error <= 1e-13 * largest,
            "{what}: {found} instead of {expected}, {error:e}"
        );
    }
}

#[test]
fn every_spline_of_scipy() {
    let Some(path) = shared("oracle/anim/splines.json") else {
        return;
    };
    let text = std::fs::read(path).unwrap();
    let all: Value = serde_json::from_slice(&text).unwrap();
    let cases = all["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 50);
    for case in cases {
        let (times, values) = (numbers(&case["t"]), table(&case["y"]));
        let kind = match case["bc"].as_str().unwrap() {
            "natural" => EndKind::Natural,
            "clamped" | "clamped_given" => EndKind::Slopes,
            "not-a-knot" => EndKind::NotAKnot,
            "periodic" => EndKind::Periodic,
            other => panic!("{other}"),
        };
        let system = SplineSystem::new(&times, kind).unwrap();
        let curves: Vec<Curve<f64>> = (0..values[0].len())
            .map(|channel| {
                let values = column(&values, channel);
                match case.get("end_slopes") {
                    Some(slopes) => {
                        let slopes = column(&table(slopes), channel);
                        system.fit_with_slopes(&values, [slopes[0], slopes[1]])
                    }
                    None => system.fit(&values),
                }
                .unwrap()
            })
            .collect();
        let query = numbers(&case["query"]);
        let each = |f: &dyn Fn(&Curve<f64>, f64) -> f64| -> Vec<Vec<f64>> {
            let row = |&time: &f64| curves.iter().map(|curve| f(curve, time)).collect();
            query.iter().map(row).collect()
        };
        let what = format!("{} of {} keys", case["bc"], times.len());
        assert_all_near(&each(&|c, t| c.value(t)), &table(&case["value"]), &what);
        assert_all_near(&each(&|c, t| c.derivative(t)), &table(&case["d1"]), &what);
        assert_all_near(
            &each(&|c, t| c.second_derivative(t)),
            &table(&case["d2"]),
            &what,
        );
        let integrals = curves
            .iter()
            .map(|c| c.integral(times[0], times[times.len() - 1]).unwrap());
        assert_all_near(&[integrals.collect()], &[numbers(&case["integral"])], &what);
        let values = table(&case["value"]);
        let largest = values.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        for power in 0..4 {
            let expected: Vec<Vec<f64>> = case["coeff"]
                .as_array()
                .unwrap()
                .iter()
                .map(|piece| table(piece).iter().map(|c| c[3 - power]).collect())
                .collect();
            let found: Vec<Vec<f64>> = (0..expected.len())
                .map(|piece| {
                    curves
                        .iter()
                        .map(|curve| curve.pieces()[piece][power])
                        .collect()
                })
                .collect();
            // The cubic coefficient of a parabola is 0 but for rounding.
            assert_near(&found, &expected, largest, &what);
        }
    }
}

fn row3(row: &[f64]) -> [f64; 3] {
    [row[0], row[1], row[2]]
}

#[test]
fn chords_near_the_fewest_and_arc_lengths_of_scipy() {
    let Some(path) = shared("oracle/anim/resample.json") else {
        return;
    };
    let text = std::fs::read(path).unwrap();
    let all: Value = serde_json::from_slice(&text).unwrap();
    for case in all["cases"].as_array().unwrap() {
        let (times, values) = (numbers(&case["t"]), table(&case["y"]));
        let keys: Vec<[f64; 3]> = values.iter().map(|row| row3(row)).collect();
        let curve = Curve::spline(&times, &keys, Ends::Natural).unwrap();
        let query = numbers(&case["query"]);
        let dense: Vec<Vec<f64>> = query.iter().map(|&t| curve.value(t).to_vec()).collect();
        assert_all_near(&dense, &table(&case["dense"]), "dense");

        // The oracle's lengths are sums of the trapezoidal rule and less exact.
        let length = ArcLength::new(&curve).unwrap();
        let total = case["total_length"].as_f64().unwrap();
        assert!(
            (length.total() - total).abs() < 1e-6 * total,
            "{} {total}",
            length.total()
        );
        for (&time, expected) in query.iter().zip(numbers(&case["arc_length"])) {
            assert!((length.at(time) - expected).abs() < 1e-4 * total);
            assert!((length.time_at(length.at(time)) - time).abs() < 1e-9);
        }

        for (tolerance, asymptotic) in case["segments_asymptotic"].as_object().unwrap() {
            let (tolerance, asymptotic) = (
                tolerance.parse::<f64>().unwrap(),
                asymptotic.as_f64().unwrap(),
            );
            let resampled = curve.resampled(tolerance, Distance::Geometric).unwrap();
            let chords = resampled.times.len() - 1;
            println!("{tolerance}: {chords} chords, asymptotic {asymptotic:.1}");
            assert!(
                chords as f64 <= (1.04 * asymptotic).ceil() + 1.0,
                "{chords} {asymptotic}"
            );
            assert!(resampled.max_deviation <= tolerance);

            // Channels apart give the same.
            let system = SplineSystem::new(&times, EndKind::Natural).unwrap();
            let channels: Vec<_> = (0..3)
                .map(|k| system.fit(&column(&values, k)).unwrap())
                .collect();
            let apart =
                resample_channels(&channels, tolerance, Distance::Geometric, usize::MAX).unwrap();
            assert_eq!(apart.times, resampled.times);
            assert_eq!(apart.values[1], resampled.values[1].to_vec());
        }
    }
}
