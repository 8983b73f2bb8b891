//! Logistic fits against SciPy, and against the curves from which scores were made.

use ga_video::opinion::correlation::pearson;
use ga_video::opinion::logistic::{Curve, Fit, Logistic4, Logistic5};
use ga_video::opinion::{OpinionError, Scores};
use proptest::prelude::*;

fn check<C: Curve>(scores: &Scores, truth: &serde_json::Value) {
    let fit = C::fit(scores).unwrap();
    let sum = truth["sse"].as_f64().unwrap();
    assert!(
        fit.sum_of_squares <= (1.0 + 1e-6) * sum,
        "{} > {sum}",
        fit.sum_of_squares
    );
    let predicted: Vec<f64> = scores
        .objective()
        .iter()
        .map(|x| fit.curve.at(*x))
        .collect();
    let pairs = predicted.iter().zip(scores.subjective());
    let again: f64 = pairs.map(|(p, y)| (p - y).powi(2)).sum();
    assert!((fit.sum_of_squares - again).abs() < 1e-12 * sum);
    let correlation = pearson(&predicted, scores.subjective()).unwrap();
    assert!(correlation > truth["plcc"].as_f64().unwrap() - 1e-6);
}

#[test]
fn no_fit_is_worse_than_that_of_scipy() {
    for (scores, truth) in super::oracle().into_iter().flatten() {
        check::<Logistic4>(&scores, &truth["logistic4"]);
        check::<Logistic5>(&scores, &truth["logistic5"]);
    }
}

/// Scores of a measure between 20 and 50, with the opinions of a curve and errors.
fn scores(curve: impl Curve, values: &[(f64, f64)]) -> Option<Scores> {
    let opinions = values.iter().map(|(x, error)| curve.at(*x) + error);
    Scores::new(values.iter().map(|(x, _)| *x).collect(), opinions.collect()).ok()
}

fn values(error: f64) -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((20.0..50.0_f64, -1.0..1.0_f64), 8..60)
        .prop_map(move |values| values.into_iter().map(|(x, e)| (x, error * e)).collect())
}

/// A curve that rises everywhere.
fn curve() -> impl Strategy<Value = Logistic5> {
    (
        0.5..4.0_f64,
        0.1..2.0_f64,
        25.0..45.0_f64,
        0.0..0.1_f64,
        0.0..3.0_f64,
    )
        .prop_map(|(a, b, c, d, e)| Logistic5 {
            parameters: [a, b, c, d, e],
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn the_curve_of_exact_scores_is_found(curve in curve(), values in values(0.0)) {
        let Some(scores) = scores(curve, &values) else { return Ok(()) };
        let fit = Logistic5::fit(&scores).unwrap();
        prop_assert!(fit.sum_of_squares < 1e-9, "{:?} {:?}", fit, scores);
    }

    #[test]
    fn no_other_curve_is_better(
        curve in curve(),
        values in values(0.5),
        changes in prop::collection::vec(-0.2..0.2_f64, 5),
    ) {
        let Some(scores) = scores(curve, &values) else { return Ok(()) };
        let sum = |parameters: [f64; 5]| -> f64 {
            let curve = Logistic5 { parameters };
            let pairs = scores.objective().iter().zip(scores.subjective());
            pairs.map(|(x, y)| (curve.at(*x) - y).powi(2)).sum()
        };
        let fit = Logistic5::fit(&scores).unwrap();
        prop_assert!(fit.sum_of_squares <= sum(curve.parameters) * (1.0 + 1e-9));
        for parameters in [curve.parameters, fit.curve.parameters] {
            let mut changed = parameters;
            changed.iter_mut().zip(&changes).for_each(|(p, c)| *p *= 1.0 + c);
            if turns(Logistic5 { parameters: changed }, scores.objective()) == 0 {
                prop_assert!(fit.sum_of_squares <= sum(changed) * (1.0 + 1e-9));
            }
        }
    }

    /// Opinions of any order.
    #[test]
    fn no_curve_bends_back(
        values in prop::collection::vec((20.0..50.0_f64, 1.0..5.0_f64), 6..30),
    ) {
        let (x, y): (Vec<f64>, Vec<f64>) = values.into_iter().unzip();
        let Ok(scores) = Scores::new(x, y) else { return Ok(()) };
        let four = Logistic4::fit(&scores).unwrap();
        let five = Logistic5::fit(&scores).unwrap();
        prop_assert_eq!(turns(five.curve, scores.objective()), 0);
        prop_assert!(!four.is_held_monotone);
        // The curve with four parameters is one of those with five.
        prop_assert!(five.sum_of_squares <= four.sum_of_squares * (1.0 + 1e-6) + 1e-12);
    }

    /// The unit of the measure, and its direction, do not matter.
    #[test]
    fn the_unit_does_not_matter(
        curve in curve(),
        values in values(0.3),
        scale in prop_oneof![-1e6..-1e-6_f64, 1e-6..1e6_f64],
    ) {
        let Some(scores) = scores(curve, &values) else { return Ok(()) };
        let scaled = scores.objective().iter().map(|x| scale * x).collect();
        let scaled = Scores::new(scaled, scores.subjective().to_vec()).unwrap();
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-6 * a.max(b) + 1e-12;
        let sums = |s: &Scores| -> [f64; 2] {
            [
                Logistic4::fit(s).unwrap().sum_of_squares,
                Logistic5::fit(s).unwrap().sum_of_squares,
            ]
        };
        let (before, after) = (sums(&scores), sums(&scaled));
        prop_assert!(same(before[0], after[0]) && same(before[1], after[1]), "{before:?} {after:?}");
        // The straight line is one more freedom.
        prop_assert!(before[1] <= before[0] * (1.0 + 1e-6) + 1e-12);
    }

    #[test]
    fn a_fit_nearby_is_the_same_fit(curve in curve(), values in values(0.2)) {
        let Some(scores) = scores(curve, &values) else { return Ok(()) };
        let fit: Fit<Logistic4> = Logistic4::fit(&scores).unwrap();
        let again = Logistic4::fit_near(&scores, &fit).unwrap();
        prop_assert!(again.sum_of_squares <= fit.sum_of_squares * (1.0 + 1e-9));
    }
}

/// How often a curve turns from rising to falling or back, between the least and the greatest
/// score, by more than rounding.
fn turns(curve: impl Curve, scores: &[f64]) -> usize {
    let least = scores.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = scores.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let place = |k: u32| least + (greatest - least) * f64::from(k) / 2000.0;
    let heights: Vec<f64> = (0..=2000).map(|k| curve.at(place(k))).collect();
    let range = heights.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let steps = heights.windows(2).map(|pair| pair[1] - pair[0]);
    let signs: Vec<bool> = steps
        .filter(|step| step.abs() > 1e-9 * range)
        .map(|s| s > 0.0)
        .collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// The sum of the errors is that of the best monotone curve: on a parabola, whose best curve with
/// five parameters bends back, no sampled monotone one is better.
#[test]
fn a_parabola_has_no_curve_that_bends_back() {
    let x: Vec<f64> = (0..21).map(|k| f64::from(k) / 10.0 - 1.0).collect();
    let y = x.iter().map(|x| 3.0 + x - 2.0 * x * x).collect();
    let scores = Scores::new(x, y).unwrap();
    let fit = Logistic5::fit(&scores).unwrap();
    assert!(fit.is_held_monotone && turns(fit.curve, scores.objective()) == 0);
    let mut best = f64::INFINITY;
    for place in -20..=20 {
        for steepness in -6..=12 {
            for part in 0..=40 {
                // Mixtures of a logistic function and a straight line that rise together.
                let place = f64::from(place) / 10.0;
                let steepness = (f64::from(steepness) / 2.0).exp();
                let part = f64::from(part) / 40.0;
                let curve = Logistic5 {
                    parameters: [1.0 - part, steepness, place, part, 0.0],
                };
                let heights: Vec<f64> = scores.objective().iter().map(|x| curve.at(*x)).collect();
                // What scaling and shifting leaves of the opinions: by the correlation.
                let found = pearson(&heights, scores.subjective()).unwrap_or(0.0);
                let mean = scores.subjective().iter().sum::<f64>() / scores.len() as f64;
                let spread = scores
                    .subjective()
                    .iter()
                    .map(|y| (y - mean).powi(2))
                    .sum::<f64>();
                best = best.min((1.0 - found * found) * spread);
            }
        }
    }
    assert!(
        fit.sum_of_squares <= best * (1.0 + 1e-9),
        "{} > {best}",
        fit.sum_of_squares
    );
    // Data that rise are not held.
    let x: Vec<f64> = (0..21).map(f64::from).collect();
    let y = x
        .iter()
        .map(|x| 1.0 + 4.0 / (1.0 + (10.0 - x).exp()))
        .collect();
    let rising = Logistic5::fit(&Scores::new(x, y).unwrap()).unwrap();
    assert!(!rising.is_held_monotone && rising.sum_of_squares < 1e-9);
}

/// A sine of opinions: SROCC is 0.65 by SciPy, and no curve makes more of it than a monotone
/// regression does.
#[test]
fn opinions_that_fall_at_both_ends_are_not_predicted() {
    let Some(path) = nullcone_shared_data::shared("cases/video/fit-non-monotone/nonmono.csv")
    else {
        return;
    };
    let table = ga_files::table::Table::with_names(&std::fs::read(path).unwrap()).unwrap();
    let scores = Scores::of_column(&table, "objective").unwrap();
    let fit = Logistic5::fit(&scores).unwrap();
    assert!(fit.is_held_monotone && turns(fit.curve, scores.objective()) == 0);
    let found = ga_video::opinion::performance::of(&scores, &fit);
    assert!((found.spearman - 0.65).abs() < 5e-3, "{found:?}");
    assert_eq!(
        found.unfitted_linear_correlation,
        pearson(scores.objective(), scores.subjective()).unwrap()
    );
    // The least sum of all rising functions, by pooling adjacent violators.
    let mut blocks: Vec<(f64, f64)> = Vec::new();
    for y in scores.subjective() {
        let mut block = (*y, 1.0);
        while let Some(last) = blocks.pop_if(|last| last.0 >= block.0) {
            let count = last.1 + block.1;
            block = ((last.0 * last.1 + block.0 * block.1) / count, count);
        }
        blocks.push(block);
    }
    let pooled = blocks
        .iter()
        .flat_map(|(mean, count)| vec![*mean; *count as usize]);
    let least: f64 = pooled
        .zip(scores.subjective())
        .map(|(m, y)| (m - y).powi(2))
        .sum();
    assert!(
        fit.sum_of_squares >= least,
        "{} < {least}",
        fit.sum_of_squares
    );
    assert!(
        fit.sum_of_squares < 1.2 * least,
        "{} {least}",
        fit.sum_of_squares
    );
}

#[test]
fn steps_and_lines_are_fitted() {
    // A step between 4 and 5.
    let x: Vec<f64> = (0..10).map(f64::from).collect();
    let step = x.iter().map(|x| if *x > 4.5 { 5.0 } else { 1.0 }).collect();
    let scores = Scores::new(x.clone(), step).unwrap();
    assert!(Logistic4::fit(&scores).unwrap().sum_of_squares < 1e-12);
    // A straight line, which only the curve with five parameters contains.
    let line = x.iter().map(|x| 3.0 - 0.25 * x).collect();
    let scores = Scores::new(x, line).unwrap();
    let fit = Logistic5::fit(&scores).unwrap();
    assert!(fit.sum_of_squares < 1e-20, "{fit:?}");
    assert!(fit.curve.parameters.iter().all(|p| p.is_finite()));
}

#[test]
fn fewer_scores_than_parameters_are_refused() {
    let scores = Scores::new(vec![1.0, 2.0, 3.0, 4.0], vec![1.0, 3.0, 2.0, 4.0]).unwrap();
    assert!(Logistic4::fit(&scores).is_ok());
    let error = OpinionError::TooFew {
        what: "scores",
        found: 4,
        least: 5,
    };
    assert_eq!(Logistic5::fit(&scores), Err(error));
}

#[test]
fn wrong_scores_are_named() {
    let nan = Scores::new(vec![1.0, 2.0], vec![1.0, f64::NAN]).unwrap_err();
    assert_eq!(
        nan.to_string(),
        "row 1, column subjective: NaN is not a finite number"
    );
    let equal = Scores::new(vec![2.0, 2.0], vec![1.0, 3.0]);
    assert!(matches!(equal, Err(OpinionError::Constant { column }) if column == "objective"));
    let lengths = Scores::new(vec![2.0], vec![1.0, 3.0]);
    assert_eq!(
        lengths,
        Err(OpinionError::Lengths {
            first: 1,
            second: 2
        })
    );
    let scores = Scores::new(vec![1.0, 2.0], vec![1.0, 3.0]).unwrap();
    let deviation = scores.with_deviations(vec![0.5, -1.0]);
    assert_eq!(
        deviation,
        Err(OpinionError::Deviation {
            row: 1,
            value: -1.0
        })
    );
}
