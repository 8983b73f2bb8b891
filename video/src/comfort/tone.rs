//! How the codes of one view follow from those of the other.

use ga_numerics::order_statistics::median;
use serde::{Deserialize, Serialize};

/// The code of the left view that stands for one of the right view, in one channel: a straight
/// line, left = factor · right + offset, in codes of 255.
///
/// ```
/// use ga_video::comfort::Tone;
///
/// let tone = Tone { factor: 0.5, offset_codes: 20.0 };
/// assert_eq!(tone.apply(100.0), 70.0);
/// assert_eq!(Tone::default().apply(100.0), 100.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tone {
    /// By what codes are multiplied.
    pub factor: f64,
    /// What is added, in codes of 255.
    pub offset_codes: f64,
}

impl Default for Tone {
    /// All codes stay as they are.
    fn default() -> Self {
        Self {
            factor: 1.0,
            offset_codes: 0.0,
        }
    }
}

/// Errors are not taken to be smaller than this, in codes: the means of surroundings are rounded.
const LEAST_ERROR: f64 = 0.25;

/// A line rises neither less nor more.
const FACTORS: std::ops::RangeInclusive<f64> = 0.25..=4.0;

impl Tone {
    /// The code in the left view of one in the right view.
    #[must_use]
    pub fn apply(&self, code: f64) -> f64 {
        self.factor * code + self.offset_codes
    }

    /// The line through two places, given by its codes there.
    pub(super) fn through(places: [f64; 2], codes: [f64; 2]) -> Self {
        let factor = (codes[1] - codes[0]) / (places[1] - places[0]);
        Self {
            factor,
            offset_codes: codes[0] - factor * places[0],
        }
    }

    /// The line that fits pairs of codes, left and right, with the least sum of absolute errors:
    /// one of those that leave codes as they are, add an offset, multiply by a factor, and do both.
    ///
    /// One that has more parameters must explain clearly more: twice what the information
    /// criterion of Schwarz asks for each of them, for errors of the distribution of Laplace, whose
    /// scale is the mean of their absolute values.
    pub(super) fn between(pairs: &[[f64; 2]]) -> Self {
        if pairs.is_empty() {
            return Self::default();
        }
        let median_of = |number: fn([f64; 2]) -> f64| {
            let mut numbers: Vec<f64> = pairs.iter().map(|pair| number(*pair)).collect();
            median(&mut numbers).unwrap_or(f64::NAN)
        };
        let offset = Self {
            offset_codes: median_of(|[left, right]| left - right),
            ..Self::default()
        };
        let factor = Self {
            factor: median_of(|[left, right]| above_black(left) / above_black(right)),
            ..Self::default()
        };
        let simple = [(Self::default(), 0.0), (offset, 1.0), (factor, 1.0)];
        let start = match offset.error(pairs) < factor.error(pairs) {
            true => offset,
            false => factor,
        };
        let lines = simple.into_iter().chain([(start.refined(pairs), 2.0)]);
        let count = pairs.len() as f64;
        let badness = |(tone, parameters): &(Self, f64)| {
            2.0 * count * tone.error(pairs).max(LEAST_ERROR).ln() + 2.0 * parameters * count.ln()
        };
        lines
            .filter(|(tone, _)| FACTORS.contains(&tone.factor) && tone.offset_codes.is_finite())
            .min_by(|a, b| badness(a).total_cmp(&badness(b)))
            .map_or(Self::default(), |(tone, _)| tone)
    }

    /// The mean absolute error.
    fn error(&self, pairs: &[[f64; 2]]) -> f64 {
        let errors = pairs.iter().map(|pair| self.error_of(*pair));
        errors.sum::<f64>() / pairs.len() as f64
    }

    fn error_of(&self, [left, right]: [f64; 2]) -> f64 {
        (left - self.apply(right)).abs()
    }

    /// The line with the least sum of absolute errors, by least squares with weights that are the
    /// reciprocals of the errors of the line before.
    fn refined(mut self, pairs: &[[f64; 2]]) -> Self {
        const STEPS: usize = 12;
        for _ in 0..STEPS {
            let mut sums = [0.0; 5];
            for &[left, right] in pairs {
                let weight = 1.0 / self.error_of([left, right]).max(LEAST_ERROR);
                let terms = [1.0, right, left, right * right, right * left];
                for (sum, term) in sums.iter_mut().zip(terms) {
                    *sum += weight * term;
                }
            }
            let [count, x, y, xx, xy] = sums;
            let spread = count * xx - x * x;
            if spread <= 1e-9 * count * count {
                // All codes are equal.
                return self;
            }
            self.factor = (count * xy - x * y) / spread;
            self.offset_codes = (y - self.factor * x) / count;
        }
        self
    }
}

/// A code that has a ratio to others: half a code is added for black.
pub(super) fn above_black(code: f64) -> f64 {
    code.max(0.0) + 0.5
}

#[cfg(test)]
mod tests {
    use super::Tone;

    /// Codes of the right view from 40 to 199, with errors that a few outliers exceed by far.
    fn pairs(left: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        let pair = |index: usize| {
            let right = (40 + index) as f64;
            let error = match index.is_multiple_of(17) {
                true => 60.0,
                false => [0.3, -0.2, 0.1, -0.3, 0.0][index % 5],
            };
            [left(right) + error, right]
        };
        (0..160).map(pair).collect()
    }

    #[test]
    fn the_simplest_line_that_explains_the_codes_is_taken() {
        for (factor, offset) in [
            (1.0, 0.0),
            (1.0, 17.0),
            (0.8, 0.0),
            (1.2, -12.0),
            (0.9, 25.0),
        ] {
            let found = Tone::between(&pairs(|code| factor * code + offset));
            for code in [40.0, 199.0] {
                let error = found.apply(code) - (factor * code + offset);
                assert!(error.abs() < 0.5, "{factor} {offset}: {found:?}");
            }
            assert_eq!(found.factor == 1.0, factor == 1.0, "{found:?}");
            assert_eq!(found.offset_codes == 0.0, offset == 0.0, "{found:?}");
        }
    }

    #[test]
    fn codes_that_are_all_equal_have_no_slope() {
        let found = Tone::between(&[[50.0, 40.0]; 30]);
        assert!((found.apply(40.0) - 50.0).abs() < 1e-9, "{found:?}");
        assert_eq!(Tone::between(&[]), Tone::default());
    }
}
