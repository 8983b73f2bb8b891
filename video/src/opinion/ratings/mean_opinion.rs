//! Mean opinion scores.

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};
use statrs::distribution::{ContinuousCDF, StudentsT};

use super::super::OpinionError;
use super::Ratings;

/// The mean of the ratings of a question (mean opinion score, MOS; ITU-T P.800.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanOpinion {
    /// The mean.
    pub mean: f64,
    /// How many ratings there are.
    pub ratings: usize,
    /// The standard deviation of the ratings, with one less than their number as the divisor;
    /// `None` for one rating.
    pub deviation: Option<f64>,
    /// Half the width of the confidence interval of the mean, `t s / √n` with Student's t (ITU-R
    /// BT.500); `None` for one rating.
    pub half_width: Option<f64>,
}

impl MeanOpinion {
    /// The ends of the confidence interval of the mean; `None` for one rating.
    #[must_use]
    pub fn interval(&self) -> Option<[f64; 2]> {
        self.half_width
            .map(|half| [self.mean - half, self.mean + half])
    }
}

impl Serialize for MeanOpinion {
    /// The ends of the interval stand for its width.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("MeanOpinion", 4)?;
        object.serialize_field("mean_opinion_score", &self.mean)?;
        object.serialize_field("interval", &self.interval())?;
        object.serialize_field("standard_deviation", &self.deviation)?;
        object.serialize_field("ratings", &self.ratings)?;
        object.end()
    }
}

/// How the opinions of two groups differ.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct GroupDifference {
    /// The first group's mean minus the second's.
    pub difference: f64,
    /// The probability of a difference at least as great where there is none, by the test of B. L.
    /// Welch ("The generalization of Student's problem when several different population variances
    /// are involved", 1947); `None` where a group has one rating, or where neither varies.
    pub p_value: Option<f64>,
}

impl Ratings {
    /// The mean opinion of all raters, or of one group, with an interval of this confidence.
    ///
    /// # Errors
    ///
    /// [`OpinionError::Confidence`]; [`OpinionError::TooFew`] where the group has no rating of this
    /// question, or where there is no such question.
    pub fn mean_opinion(
        &self,
        question: usize,
        group: Option<&str>,
        confidence: f64,
    ) -> Result<MeanOpinion, OpinionError> {
        if !(confidence > 0.0 && confidence < 1.0) {
            return Err(OpinionError::Confidence(confidence));
        }
        let ratings = self.of_question(question, group);
        let Some((mean, variance)) = mean_and_variance(&ratings) else {
            return Err(OpinionError::TooFew {
                what: "ratings of a question",
                found: 0,
                least: 1,
            });
        };
        let count = ratings.len() as f64;
        let half_width = |variance: f64| {
            let student = StudentsT::new(0.0, 1.0, count - 1.0).ok()?;
            let t = student.inverse_cdf(0.5 + 0.5 * confidence);
            Some(t * (variance / count).sqrt())
        };
        Ok(MeanOpinion {
            mean,
            ratings: ratings.len(),
            deviation: variance.map(f64::sqrt),
            half_width: variance.and_then(half_width),
        })
    }

    /// How the opinions of two groups about a question differ; `None` where a group has no rating
    /// of it.
    ///
    /// ```
    /// # use ga_video::opinion::ratings::{Rater, Ratings};
    /// # let rater = |name: &str, group: &str, rating| Rater {
    /// #     name: name.to_owned(),
    /// #     group: Some(group.to_owned()),
    /// #     ratings: vec![Some(rating)],
    /// # };
    /// let raters = vec![
    ///     rater("Ada", "expert", 4.0),
    ///     rater("Bob", "expert", 5.0),
    ///     rater("Eve", "lay", 3.0),
    ///     rater("Max", "lay", 2.0),
    /// ];
    /// let ratings = Ratings::new(vec!["clarity".to_owned()], raters)?;
    /// let found = ratings.group_difference(0, ["expert", "lay"]).unwrap();
    /// assert_eq!(found.difference, 2.0);
    /// // t = 2 / √(1/4 + 1/4), with two degrees of freedom.
    /// assert!((found.p_value.unwrap() - 0.105_572_8).abs() < 1e-6);
    /// # Ok::<(), ga_video::opinion::OpinionError>(())
    /// ```
    #[must_use]
    pub fn group_difference(&self, question: usize, groups: [&str; 2]) -> Option<GroupDifference> {
        let [first, second] = groups.map(|group| self.of_question(question, Some(group)));
        let (first_mean, first_variance) = mean_and_variance(&first)?;
        let (second_mean, second_variance) = mean_and_variance(&second)?;
        let difference = first_mean - second_mean;
        let p_value = || {
            let [n, m] = [first.len() as f64, second.len() as f64];
            let [a, b] = [first_variance? / n, second_variance? / m];
            let degrees = (a + b).powi(2) / (a * a / (n - 1.0) + b * b / (m - 1.0));
            let student = StudentsT::new(0.0, 1.0, degrees).ok()?;
            Some(2.0 * student.cdf(-difference.abs() / (a + b).sqrt()))
        };
        Some(GroupDifference {
            difference,
            p_value: p_value(),
        })
    }
}

/// The mean, and the variance where there is more than one number; `None` where there is none.
pub(super) fn mean_and_variance(values: &[f64]) -> Option<(f64, Option<f64>)> {
    let count = values.len() as f64;
    let mean = (!values.is_empty()).then(|| values.iter().sum::<f64>() / count)?;
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    Some((mean, (values.len() > 1).then(|| squares / (count - 1.0))))
}
