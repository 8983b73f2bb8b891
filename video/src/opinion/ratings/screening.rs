//! Raters who answer unlike all others.

use serde::Serialize;

use super::super::correlation::pearson;
use super::Ratings;
use super::mean_opinion::mean_and_variance;

/// How one rater's answers lie among all answers (ITU-R BT.500, screening of observers).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Screening {
    /// How many of the rater's ratings lie above the limit for the question, P.
    pub above: usize,
    /// How many lie below it, Q.
    pub below: usize,
    /// How many ratings the rater gave, N.
    pub ratings: usize,
    /// The correlation of the rater's ratings with the mean of the other raters' ratings; `None`
    /// where there are fewer than two questions or where either does not vary.
    pub correlation: Option<f64>,
    /// Whether the rater should be left out: `(P + Q) / N > 0.05` and `|P − Q| / (P + Q) < 0.3`.
    /// Who answers always too high, or always too low, is kept.
    #[serde(rename = "rejected")]
    pub is_rejected: bool,
}

/// Ratings with a kurtosis in this range are taken as normal.
const NORMAL_KURTOSIS: std::ops::RangeInclusive<f64> = 2.0..=4.0;

impl Ratings {
    /// The screening of each rater by the rule of ITU-R BT.500: a rating lies outside of the limits
    /// for its question where it is 2 standard deviations from the mean, if the ratings of the
    /// question are normal by their kurtosis (between 2 and 4), and √20 standard deviations
    /// otherwise.
    #[must_use]
    pub fn screening(&self) -> Vec<Screening> {
        let limits: Vec<Option<[f64; 2]>> = (0..self.questions.len())
            .map(|question| limits(&self.of_question(question, None)))
            .collect();
        (0..self.raters.len())
            .map(|rater| self.screened(rater, &limits))
            .collect()
    }

    fn screened(&self, rater: usize, limits: &[Option<[f64; 2]>]) -> Screening {
        let (mut above, mut below, mut ratings) = (0, 0, 0);
        for (rating, limits) in self.raters[rater].ratings.iter().zip(limits) {
            let Some(rating) = rating else { continue };
            ratings += 1;
            if let Some([low, high]) = limits {
                above += usize::from(rating >= high);
                below += usize::from(rating <= low);
            }
        }
        let outside = (above + below) as f64;
        Screening {
            above,
            below,
            ratings,
            correlation: self.correlation_with_others(rater),
            is_rejected: outside > 0.05 * ratings as f64
                && above.abs_diff(below) as f64 / outside < 0.3,
        }
    }

    fn correlation_with_others(&self, rater: usize) -> Option<f64> {
        let pairs = self.raters[rater].ratings.iter().enumerate();
        let pairs = pairs.filter_map(|(question, rating)| {
            let others = self.raters.iter().enumerate().filter(|(k, _)| *k != rater);
            let others: Vec<f64> = others.filter_map(|(_, r)| r.ratings[question]).collect();
            Some(((*rating)?, mean_and_variance(&others)?.0))
        });
        let (own, others): (Vec<f64>, Vec<f64>) = pairs.unzip();
        pearson(&own, &others)
    }
}

/// The limits of a question's ratings; `None` where the ratings do not vary.
fn limits(ratings: &[f64]) -> Option<[f64; 2]> {
    let (mean, variance) = mean_and_variance(ratings)?;
    let deviation = variance?.sqrt();
    let count = ratings.len() as f64;
    let moment = |power| ratings.iter().map(|r| (r - mean).powi(power)).sum::<f64>() / count;
    let kurtosis = moment(4) / moment(2).powi(2);
    let factor = if NORMAL_KURTOSIS.contains(&kurtosis) {
        2.0
    } else {
        20.0_f64.sqrt()
    };
    (deviation > 0.0).then_some([mean - factor * deviation, mean + factor * deviation])
}
