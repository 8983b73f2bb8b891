//! Tables of ratings: raters, who may belong to groups, and questions.

mod agreement;
mod classes;
mod evaluation;
mod mean_opinion;
mod page;
mod plot;
mod screening;
mod table;

pub use agreement::{Agreement, Level};
pub use evaluation::{Evaluation, GroupComparison, QuestionEvaluation, ScreenedRater};
pub use mean_opinion::{GroupDifference, MeanOpinion};
pub use screening::Screening;
pub use table::Rows;

use std::collections::HashSet;

use super::OpinionError;

/// What each of several people answered to each of several questions, as numbers on one scale; an
/// answer may be missing.
///
/// ```
/// use ga_video::opinion::OpinionError;
/// use ga_video::opinion::ratings::{Rater, Ratings};
///
/// let rater = |name: &str, ratings: [f64; 2]| Rater {
///     name: name.to_owned(),
///     group: None,
///     ratings: ratings.map(Some).to_vec(),
/// };
/// let questions = vec!["clarity".to_owned(), "realism".to_owned()];
/// let raters = vec![rater("Ada", [4.0, 5.0]), rater("Bob", [5.0, 5.0])];
/// let ratings = Ratings::new(questions, raters)?;
/// let clarity = ratings.mean_opinion(0, None, 0.95)?;
/// assert_eq!(clarity.mean, 4.5);
/// // Student's t for one degree of freedom makes the interval wide.
/// assert!((clarity.half_width.unwrap() - 6.353).abs() < 1e-3);
/// # Ok::<(), OpinionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Ratings {
    questions: Vec<String>,
    raters: Vec<Rater>,
}

/// A person with ratings.
#[derive(Clone, Debug, PartialEq)]
pub struct Rater {
    /// The person's name or number.
    pub name: String,
    /// The group, such as `expert` or `lay`, where there are groups.
    pub group: Option<String>,
    /// One rating for each question; `None` where it is missing.
    pub ratings: Vec<Option<f64>>,
}

impl Ratings {
    /// A table.
    ///
    /// # Errors
    ///
    /// [`OpinionError::TooFew`] for fewer than two raters, or no question;
    /// [`OpinionError::Unanswered`], [`OpinionError::Ragged`], [`OpinionError::Rating`],
    /// [`OpinionError::Repeated`].
    pub fn new(questions: Vec<String>, raters: Vec<Rater>) -> Result<Self, OpinionError> {
        let too_few = |what, found, least| Err(OpinionError::TooFew { what, found, least });
        if raters.len() < 2 {
            return too_few("raters", raters.len(), 2);
        }
        if questions.is_empty() {
            return too_few("questions", 0, 1);
        }
        distinct("question", questions.iter())?;
        distinct("rater", raters.iter().map(|rater| &rater.name))?;
        for rater in &raters {
            if rater.ratings.len() != questions.len() {
                return Err(OpinionError::Ragged {
                    rater: rater.name.clone(),
                    found: rater.ratings.len(),
                    expected: questions.len(),
                });
            }
            for (question, value) in questions.iter().zip(&rater.ratings) {
                if let Some(value) = value.filter(|value| !value.is_finite()) {
                    return Err(OpinionError::Rating {
                        rater: rater.name.clone(),
                        question: question.clone(),
                        value,
                    });
                }
            }
        }
        for (place, question) in questions.iter().enumerate() {
            if raters.iter().all(|rater| rater.ratings[place].is_none()) {
                let question = question.clone();
                return Err(OpinionError::Unanswered { question });
            }
        }
        Ok(Self { questions, raters })
    }

    /// The questions.
    #[must_use]
    pub fn questions(&self) -> &[String] {
        &self.questions
    }

    /// The raters.
    #[must_use]
    pub fn raters(&self) -> &[Rater] {
        &self.raters
    }

    /// The groups, in the order in which they first occur.
    #[must_use]
    pub fn groups(&self) -> Vec<&str> {
        let mut groups = Vec::new();
        for group in self
            .raters
            .iter()
            .filter_map(|rater| rater.group.as_deref())
        {
            if !groups.contains(&group) {
                groups.push(group);
            }
        }
        groups
    }

    /// The ratings of a question by all raters, or by those of one group.
    #[must_use]
    pub fn of_question(&self, question: usize, group: Option<&str>) -> Vec<f64> {
        let raters = self.raters.iter();
        let raters = raters.filter(|r| group.is_none() || r.group.as_deref() == group);
        raters
            .filter_map(|rater| *rater.ratings.get(question)?)
            .collect()
    }

    /// The same table without some raters.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new), where too few are left.
    pub fn without(&self, raters: &[usize]) -> Result<Self, OpinionError> {
        let kept = self.raters.iter().enumerate();
        let kept = kept.filter(|(place, _)| !raters.contains(place));
        Self::new(
            self.questions.clone(),
            kept.map(|(_, rater)| rater.clone()).collect(),
        )
    }
}

fn distinct<'a>(
    what: &'static str,
    mut names: impl Iterator<Item = &'a String>,
) -> Result<(), OpinionError> {
    let mut seen = HashSet::new();
    match names.find(|name| !seen.insert(name.as_str())) {
        None => Ok(()),
        Some(name) => Err(OpinionError::Repeated {
            what,
            name: name.clone(),
        }),
    }
}
