//! Whether raters agree.

use serde::Serialize;

use super::super::correlation::ranks;
use super::Ratings;

/// How far raters agree.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Agreement {
    /// Krippendorff's α for the differences of ratings (level interval).
    #[serde(rename = "krippendorff_alpha_interval")]
    pub alpha_interval: Option<f64>,
    /// Krippendorff's α for the order of ratings (level ordinal).
    #[serde(rename = "krippendorff_alpha_ordinal")]
    pub alpha_ordinal: Option<f64>,
    /// Kendall's coefficient of concordance W with his correction for ties, over the raters who
    /// answered all questions: 1 where all put the questions in the same order, about 0 for random
    /// orders. `None` for fewer than two such raters or questions, or where all ratings of each
    /// rater are equal.
    #[serde(rename = "kendall_w")]
    pub concordance: Option<f64>,
}

/// What counts in Krippendorff's α.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// The square of the difference of two ratings.
    Interval,
    /// The square of how many ratings lie between two of them.
    Ordinal,
}

impl Ratings {
    /// How far the raters agree about the questions.
    #[must_use]
    pub fn agreement(&self) -> Agreement {
        Agreement {
            alpha_interval: self.alpha(Level::Interval),
            alpha_ordinal: self.alpha(Level::Ordinal),
            concordance: self.concordance(),
        }
    }

    /// Krippendorff's α, `1 − D_o / D_e`, where `D_o` is the mean disagreement of two ratings of
    /// the same question, each question weighted by its number of ratings, and `D_e` that of any
    /// two ratings: 1 for perfect agreement, 0 for ratings that do not depend on the question (K.
    /// Krippendorff, "Content Analysis", 2004). Missing ratings are allowed; a question with one
    /// rating does not count. `None` where all ratings are equal, or none can be compared.
    #[must_use]
    pub fn alpha(&self, level: Level) -> Option<f64> {
        let units: Vec<Vec<f64>> = (0..self.questions.len())
            .map(|question| self.of_question(question, None))
            .filter(|ratings| ratings.len() > 1)
            .collect();
        let all: Vec<f64> = units.concat();
        let mut scale = all.clone();
        scale.sort_by(f64::total_cmp);
        // On the ordinal level, ratings are as far apart as the ratings between them are many,
        // where the two themselves count half: the difference of their mean ranks.
        let placed = |rating: f64| match level {
            Level::Interval => rating,
            Level::Ordinal => {
                let below = scale.partition_point(|v| *v < rating);
                let not_above = scale.partition_point(|v| *v <= rating);
                0.5 * (below + not_above) as f64
            }
        };
        let disagreement = |ratings: &[f64]| {
            // Σ (a − b)² over all ordered pairs is 2 n Σ (a − mean)².
            let places: Vec<f64> = ratings.iter().map(|r| placed(*r)).collect();
            let count = places.len() as f64;
            let mean = places.iter().sum::<f64>() / count;
            2.0 * count * places.iter().map(|p| (p - mean).powi(2)).sum::<f64>()
        };
        let count = all.len() as f64;
        let within = units.iter().map(|u| disagreement(u) / (u.len() - 1) as f64);
        let observed = within.sum::<f64>() / count;
        let expected = disagreement(&all) / (count * (count - 1.0));
        (expected > 0.0).then(|| 1.0 - observed / expected)
    }

    fn concordance(&self) -> Option<f64> {
        let complete: Vec<Vec<f64>> = self
            .raters
            .iter()
            .filter_map(|rater| rater.ratings.iter().copied().collect::<Option<Vec<f64>>>())
            .map(|ratings| ranks(&ratings))
            .collect();
        let (raters, questions) = (complete.len() as f64, self.questions.len() as f64);
        if complete.len() < 2 || self.questions.len() < 2 {
            return None;
        }
        let sums = (0..self.questions.len()).map(|q| complete.iter().map(|r| r[q]).sum::<f64>());
        let mean = raters * (questions + 1.0) / 2.0;
        let squares: f64 = sums.map(|sum| (sum - mean).powi(2)).sum();
        // The squares where all raters have one order: of the ranks of each, ties included.
        let own: f64 = complete
            .iter()
            .flatten()
            .map(|rank| (rank - (questions + 1.0) / 2.0).powi(2))
            .sum();
        (own > 0.0).then(|| squares / (raters * own))
    }
}
