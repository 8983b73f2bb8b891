//! What ratings say, in all numbers that are reported.

use std::collections::BTreeMap;

use serde::Serialize;

use super::super::OpinionError;
use super::{Agreement, GroupDifference, MeanOpinion, Ratings, Screening};

/// Opinions about all questions, the agreement of the raters, and their screening.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Evaluation {
    /// The number of raters that are counted.
    pub raters: usize,
    /// What they say of each question.
    pub questions: Vec<QuestionEvaluation>,
    /// How far they agree.
    pub agreement: Agreement,
    /// The screening of all raters.
    pub screening: Vec<ScreenedRater>,
    /// The names of the raters whom the screening rejects.
    pub rejected: Vec<String>,
    /// Whether these were left out.
    pub screened: bool,
    /// The confidence of the intervals.
    pub confidence: f64,
    /// The ratings that are counted.
    #[serde(skip)]
    pub(super) ratings: Ratings,
}

/// What raters say of a question.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct QuestionEvaluation {
    /// The question.
    pub question: String,
    /// The opinion of all raters.
    #[serde(flatten)]
    pub opinion: MeanOpinion,
    /// How many raters gave each rating.
    pub counts: BTreeMap<String, usize>,
    /// The opinions of groups.
    pub groups: BTreeMap<String, MeanOpinion>,
    /// The differences of each two groups, where they can be found.
    pub differences: Vec<GroupComparison>,
}

/// How the opinions of two groups about a question differ.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GroupComparison {
    /// The first group.
    pub first: String,
    /// The second group.
    pub second: String,
    /// The first one's mean minus the second one's.
    #[serde(flatten)]
    pub found: GroupDifference,
}

/// The screening of a rater.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScreenedRater {
    /// The rater's name.
    pub rater: String,
    /// How the answers lie among all answers.
    #[serde(flatten)]
    pub screening: Screening,
}

impl Ratings {
    /// Evaluates the ratings, with intervals of this confidence. `is_screened` says whether raters
    /// whom the screening rejects are left out.
    ///
    /// # Errors
    ///
    /// [`OpinionError::Confidence`]; those of [`without`](Self::without) where too few raters are
    /// left.
    pub fn evaluate(&self, confidence: f64, is_screened: bool) -> Result<Evaluation, OpinionError> {
        let names = self.raters().iter().map(|rater| rater.name.clone());
        let screening = names.zip(self.screening());
        let screening = screening.map(|(rater, screening)| ScreenedRater { rater, screening });
        let screening: Vec<ScreenedRater> = screening.collect();
        let found = screening.iter().enumerate();
        let found = found.filter(|(_, rater)| rater.screening.is_rejected);
        let (rejected, names): (Vec<usize>, Vec<String>) = found
            .map(|(place, found)| (place, found.rater.clone()))
            .unzip();
        let ratings = match is_screened {
            true => self.without(&rejected)?,
            false => self.clone(),
        };
        let questions = 0..ratings.questions().len();
        let questions = questions.map(|question| ratings.evaluate_question(question, confidence));
        Ok(Evaluation {
            raters: ratings.raters().len(),
            questions: questions.collect::<Result<_, _>>()?,
            agreement: ratings.agreement(),
            screening,
            rejected: names,
            screened: is_screened,
            confidence,
            ratings,
        })
    }

    fn evaluate_question(
        &self,
        question: usize,
        confidence: f64,
    ) -> Result<QuestionEvaluation, OpinionError> {
        let opinion = |group| self.mean_opinion(question, group, confidence);
        let mut counts = BTreeMap::new();
        for rating in self.of_question(question, None) {
            *counts.entry(rating.to_string()).or_default() += 1;
        }
        let names = self.groups();
        let (mut groups, mut differences) = (BTreeMap::new(), Vec::new());
        for (place, first) in names.iter().enumerate() {
            if self.of_question(question, Some(first)).is_empty() {
                continue;
            }
            groups.insert((*first).to_owned(), opinion(Some(first))?);
            for second in &names[place + 1..] {
                if let Some(found) = self.group_difference(question, [first, second]) {
                    differences.push(GroupComparison {
                        first: (*first).to_owned(),
                        second: (*second).to_owned(),
                        found,
                    });
                }
            }
        }
        Ok(QuestionEvaluation {
            question: self.questions()[question].clone(),
            opinion: opinion(None)?,
            counts,
            groups,
            differences,
        })
    }
}
