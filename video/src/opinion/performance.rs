//! What a measure of quality is worth: how well it predicts the opinion of people.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use statrs::distribution::{ContinuousCDF, FisherSnedecor, Normal};

use super::correlation::{kendall, pearson, spearman};
use super::logistic::{Curve, Fit};
use super::{OpinionError, Scores};
use ga_numerics::order_statistics::Sorted;

/// How well a measure predicts opinion scores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Performance<V = f64> {
    /// Pearson's correlation of the measure with the opinion scores, without a curve.
    pub unfitted_linear_correlation: V,
    /// Spearman's rank correlation of the measure with the opinion scores, without a curve.
    pub spearman: V,
    /// Kendall's rank correlation τ_b of the measure with the opinion scores, without a curve.
    pub kendall: V,
    /// Pearson's correlation of the predicted with the true opinion scores. The prediction is the
    /// fitted curve at the measure's score.
    pub linear_correlation: V,
    /// The root of the mean squared error of the prediction, in the unit of the opinion scores:
    /// divided by the number of scores.
    pub root_mean_square_error: V,
    /// The part of the scores whose prediction is an outlier: off by more than two standard
    /// deviations of the opinion score, where these are known, else of all errors.
    pub outlier_ratio: V,
}

/// How many of the numbers of a [`Performance`] are those of the measure itself, without a curve:
/// the first ones.
pub const UNFITTED: usize = 3;

/// A number and an interval in which the true one lies with a stated confidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The number.
    pub value: f64,
    /// The lower end of the interval.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// How intervals are found by drawing scores again.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bootstrap {
    /// The confidence of an interval, between 0 and 1.
    pub confidence: f64,
    /// How many times as many scores are drawn as there are.
    pub draws: usize,
    /// The seed of the random numbers.
    pub seed: u64,
}

impl Default for Bootstrap {
    /// 1000 draws, 95 %, seed 1.
    fn default() -> Self {
        Self {
            draws: 1000,
            confidence: 0.95,
            seed: 1,
        }
    }
}

/// Whether one measure predicts opinion scores better than another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// The first measure's linear correlation minus the second's, with its interval by bootstrap:
    /// where 0 lies outside, the difference is significant.
    pub linear_correlation: Interval,
    /// The same for Spearman's rank correlation.
    pub spearman: Interval,
    /// The probability of a difference of the linear correlations at least as great where there is
    /// none: the test of X. Meng, R. Rosenthal, D. B. Rubin, "Comparing correlated correlation
    /// coefficients", 1992, which takes into account that both measures belong to the same scores.
    pub correlation_p_value: f64,
    /// The probability of a ratio of the variances of the errors at least as far from 1 where they
    /// are equal: the F test, which takes both errors as normal and independent (ITU-T P.1401).
    pub error_p_value: f64,
}

/// How well the measure behind a fitted curve predicts the opinion scores.
///
/// ```
/// use ga_video::opinion::logistic::{Curve, Logistic4};
/// use ga_video::opinion::{OpinionError, Scores, performance};
///
/// let decibels: Vec<f64> = (0..20).map(|k| 25.0 + f64::from(k)).collect();
/// let opinions = decibels.iter().map(|x| 1.0 + 4.0 / (1.0 + f64::exp(0.4 * (33.0 - x))));
/// let scores = Scores::new(decibels.clone(), opinions.collect())?;
/// let fit = Logistic4::fit(&scores)?;
/// let found = performance::of(&scores, &fit);
/// assert!(found.spearman == 1.0 && found.linear_correlation > 0.999_999);
/// assert!((fit.curve.parameters[2] - 33.0).abs() < 1e-4);
/// # Ok::<(), OpinionError>(())
/// ```
#[must_use]
pub fn of<C: Curve>(scores: &Scores, fit: &Fit<C>) -> Performance {
    let predicted = predictions(scores, fit);
    let errors = errors(scores, &predicted);
    let mean_square = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
    // A curve of constant height predicts nothing.
    let predicts = pearson(&predicted, scores.subjective()).unwrap_or(0.0);
    let unfitted = |of: fn(&[f64], &[f64]) -> Option<f64>| {
        of(scores.objective(), scores.subjective()).unwrap_or(0.0)
    };
    Performance {
        unfitted_linear_correlation: unfitted(pearson),
        spearman: unfitted(spearman),
        kendall: unfitted(kendall),
        linear_correlation: predicts,
        root_mean_square_error: mean_square.sqrt(),
        outlier_ratio: outliers(scores, &errors) as f64 / errors.len() as f64,
    }
}

/// The same with intervals: scores are drawn again from all scores, with repetition, the curve is
/// fitted to each draw, and the interval leaves out equal parts of the results at both ends (B.
/// Efron, "Bootstrap methods", 1979). The result is the same for any number of threads.
///
/// # Errors
///
/// [`OpinionError::Confidence`]; [`OpinionError::TooFew`] where there are fewer scores than
/// parameters of the curve, or no draws.
pub fn with_intervals<C: Curve>(
    scores: &Scores,
    fit: &Fit<C>,
    bootstrap: &Bootstrap,
) -> Result<Performance<Interval>, OpinionError> {
    let drawn = bootstrap.draw(scores.len(), |rows| {
        let drawn = scores.drawn(rows)?;
        Some(of(&drawn, &C::fit_near(&drawn, fit).ok()?))
    })?;
    let interval = |pick: fn(&Performance) -> f64| {
        bootstrap.interval(pick(&of(scores, fit)), drawn.iter().map(pick).collect())
    };
    Ok(Performance {
        unfitted_linear_correlation: interval(|p| p.unfitted_linear_correlation),
        spearman: interval(|p| p.spearman),
        kendall: interval(|p| p.kendall),
        linear_correlation: interval(|p| p.linear_correlation),
        root_mean_square_error: interval(|p| p.root_mean_square_error),
        outlier_ratio: interval(|p| p.outlier_ratio),
    })
}

/// Whether the first of two measures of the same pictures or videos predicts their opinion scores
/// better than the second.
///
/// # Errors
///
/// As [`with_intervals`]; [`OpinionError::Lengths`] where there are different numbers of scores,
/// [`OpinionError::TooFew`] for fewer than 4.
pub fn difference<C: Curve>(
    [first, second]: [&Scores; 2],
    [first_fit, second_fit]: [&Fit<C>; 2],
    bootstrap: &Bootstrap,
) -> Result<Difference, OpinionError> {
    super::scores::same_length(first.objective(), second.objective())?;
    let count = first.len();
    if count < 4 {
        return Err(OpinionError::TooFew {
            what: "scores",
            found: count,
            least: 4,
        });
    }
    let correlations = |scores: &Scores, fit: &Fit<C>| {
        let found = of(scores, fit);
        [found.linear_correlation, found.spearman]
    };
    let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let drawn = bootstrap.draw(count, |rows| {
        let one = |scores: &Scores, fit| {
            let drawn = scores.drawn(rows)?;
            Some(correlations(&drawn, &C::fit_near(&drawn, fit).ok()?))
        };
        Some(minus(one(first, first_fit)?, one(second, second_fit)?))
    })?;
    let value = minus(
        correlations(first, first_fit),
        correlations(second, second_fit),
    );
    let interval = |k: usize| bootstrap.interval(value[k], drawn.iter().map(|d| d[k]).collect());
    let predicted = [
        predictions(first, first_fit),
        predictions(second, second_fit),
    ];
    let variance = |predicted: &[f64]| {
        let squares = errors(first, predicted).into_iter().map(|e| e * e);
        squares.sum::<f64>() / (count - 1) as f64
    };
    Ok(Difference {
        linear_correlation: interval(0),
        spearman: interval(1),
        correlation_p_value: correlation_p_value(first.subjective(), &predicted),
        error_p_value: error_p_value(variance(&predicted[0]), variance(&predicted[1]), count),
    })
}

impl<V: Copy> Performance<V> {
    /// The numbers with the abbreviations by which they are known, in the order of the fields.
    #[must_use]
    pub fn named(&self) -> [(&'static str, V); 6] {
        [
            ("unfitted PLCC", self.unfitted_linear_correlation),
            ("SROCC", self.spearman),
            ("KROCC", self.kendall),
            ("PLCC", self.linear_correlation),
            ("RMSE", self.root_mean_square_error),
            ("outlier ratio", self.outlier_ratio),
        ]
    }
}

impl Serialize for Performance<Interval> {
    /// Keys such as `plcc` and `plcc_interval`.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, found) in self.named() {
            found.serialize_as(&name.to_lowercase().replace(' ', "_"), &mut map)?;
        }
        map.end()
    }
}

impl Serialize for Difference {
    /// `plcc_difference` and `srocc_difference` with their intervals, and both probabilities.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        self.linear_correlation
            .serialize_as("plcc_difference", &mut map)?;
        self.spearman.serialize_as("srocc_difference", &mut map)?;
        map.serialize_entry("correlation_p_value", &self.correlation_p_value)?;
        map.serialize_entry("error_p_value", &self.error_p_value)?;
        map.end()
    }
}

impl Interval {
    /// The number under a key, and the ends under another one.
    fn serialize_as<M: SerializeMap>(&self, key: &str, map: &mut M) -> Result<(), M::Error> {
        map.serialize_entry(key, &self.value)?;
        map.serialize_entry(&format!("{key}_interval"), &[self.low, self.high])
    }
}

impl Bootstrap {
    /// What is found for each draw of as many rows as there are. A draw for which nothing is found,
    /// since all its rows are equal, is drawn again.
    fn draw<T: Send>(
        &self,
        count: usize,
        found: impl Fn(&[usize]) -> Option<T> + Sync,
    ) -> Result<Vec<T>, OpinionError> {
        if !(self.confidence > 0.0 && self.confidence < 1.0) {
            return Err(OpinionError::Confidence(self.confidence));
        }
        if self.draws == 0 {
            return Err(OpinionError::TooFew {
                what: "draws",
                found: 0,
                least: 1,
            });
        }
        let draws = (0..self.draws as u64).into_par_iter();
        Ok(draws
            .filter_map(|stream| {
                let mut random = ChaCha8Rng::seed_from_u64(self.seed);
                random.set_stream(stream);
                (0..REPETITIONS).find_map(|_| {
                    // The high half of the product is uniform up to 2⁻⁶⁴ times the count.
                    let row = |random: &mut ChaCha8Rng| {
                        (u128::from(random.next_u64()) * count as u128) >> 64
                    };
                    let rows: Vec<usize> = (0..count).map(|_| row(&mut random) as usize).collect();
                    found(&rows)
                })
            })
            .collect())
    }

    fn interval(&self, value: f64, mut drawn: Vec<f64>) -> Interval {
        let sorted = Sorted::new(&mut drawn);
        let tail = 0.5 * (1.0 - self.confidence);
        let end = |share| sorted.map_or(value, |drawn| drawn.quantile(share));
        Interval {
            value,
            low: end(tail),
            high: end(1.0 - tail),
        }
    }
}

/// How often a draw is repeated for which nothing is found.
const REPETITIONS: usize = 100;

fn predictions<C: Curve>(scores: &Scores, fit: &Fit<C>) -> Vec<f64> {
    scores
        .objective()
        .iter()
        .map(|x| fit.curve.at(*x))
        .collect()
}

fn errors(scores: &Scores, predicted: &[f64]) -> Vec<f64> {
    let pairs = predicted.iter().zip(scores.subjective());
    pairs.map(|(p, y)| p - y).collect()
}

fn outliers(scores: &Scores, errors: &[f64]) -> usize {
    if let Some(deviations) = scores.deviations() {
        let pairs = errors.iter().zip(deviations);
        return pairs.filter(|(e, d)| e.abs() > 2.0 * **d).count();
    }
    let count = errors.len() as f64;
    let mean = errors.iter().sum::<f64>() / count;
    let squares: f64 = errors.iter().map(|e| (e - mean).powi(2)).sum();
    let limit = 2.0 * (squares / (count - 1.0)).sqrt();
    errors.iter().filter(|e| e.abs() > limit).count()
}

/// The two-sided test of Meng, Rosenthal and Rubin for two predictions of the same numbers.
fn correlation_p_value(truth: &[f64], [first, second]: &[Vec<f64>; 2]) -> f64 {
    let correlation = |a: &[f64], b: &[f64]| pearson(a, b).unwrap_or(0.0);
    let (a, b) = (correlation(first, truth), correlation(second, truth));
    let between = correlation(first, second);
    let mean_square = 0.5 * (a * a + b * b);
    if a == b || between >= 1.0 {
        return 1.0;
    }
    let factor = ((1.0 - between) / (2.0 * (1.0 - mean_square))).min(1.0);
    let spread = (1.0 - factor * mean_square) / (1.0 - mean_square);
    let degrees = truth.len() as f64 - 3.0;
    let z = (a.atanh() - b.atanh()) * (degrees / (2.0 * (1.0 - between) * spread)).sqrt();
    if z.is_nan() {
        // Both predictions are exact.
        return 1.0;
    }
    2.0 * Normal::standard().cdf(-z.abs())
}

/// The two-sided F test for the variances of as many errors each.
fn error_p_value(first: f64, second: f64, count: usize) -> f64 {
    if first == second {
        return 1.0;
    }
    let degrees = (count - 1) as f64;
    let ratio = first.min(second) / first.max(second);
    let distribution = FisherSnedecor::new(degrees, degrees);
    distribution.map_or(1.0, |d| (2.0 * d.cdf(ratio)).min(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both tails together have what the confidence leaves.
    #[test]
    fn an_interval_leaves_out_equal_parts_at_both_ends() {
        let bootstrap = Bootstrap {
            confidence: 0.9,
            ..Bootstrap::default()
        };
        let drawn = (0..=100).rev().map(f64::from).collect();
        let found = bootstrap.interval(40.0, drawn);
        assert!((found.low - 5.0).abs() < 1e-9 && (found.high - 95.0).abs() < 1e-9);
        assert_eq!(found.value, 40.0);
        assert_eq!(bootstrap.interval(40.0, Vec::new()).low, 40.0);
    }

    /// With two degrees of freedom each, the distribution function of F is x / (1 + x).
    #[test]
    fn the_test_of_the_errors_has_two_sides() {
        for variances in [[1.0, 3.0], [3.0, 1.0]] {
            let p = error_p_value(variances[0], variances[1], 3);
            assert!((p - 0.5).abs() < 1e-9, "{p}");
        }
        assert_eq!(error_p_value(2.0, 2.0, 3), 1.0);
    }
}
