//! What is reported of ratings.

use std::collections::BTreeMap;

use serde::Serialize;

#[derive(Serialize)]
pub(crate) struct Report {
    pub(super) raters: usize,
    pub(super) questions: Vec<QuestionReport>,
    pub(super) agreement: AgreementReport,
    pub(super) screening: Vec<ScreeningReport>,
    pub(super) rejected: Vec<String>,
    /// Whether the rejected raters were left out.
    pub(super) screened: bool,
    pub(super) confidence: f64,
}

#[derive(Serialize)]
pub(super) struct QuestionReport {
    pub(super) question: String,
    #[serde(flatten)]
    pub(super) opinion: OpinionReport,
    /// How many people gave each rating.
    pub(super) counts: BTreeMap<String, usize>,
    pub(super) groups: BTreeMap<String, OpinionReport>,
    /// The differences between two groups.
    pub(super) differences: Vec<DifferenceReport>,
}

#[derive(Serialize)]
pub(super) struct OpinionReport {
    pub(super) mean_opinion_score: f64,
    pub(super) interval: Option<[f64; 2]>,
    pub(super) standard_deviation: Option<f64>,
    pub(super) ratings: usize,
}

#[derive(Serialize)]
pub(super) struct DifferenceReport {
    pub(super) first: String,
    pub(super) second: String,
    pub(super) difference: f64,
    pub(super) p_value: Option<f64>,
}

#[derive(Serialize)]
pub(super) struct AgreementReport {
    pub(super) krippendorff_alpha_interval: Option<f64>,
    pub(super) krippendorff_alpha_ordinal: Option<f64>,
    pub(super) kendall_w: Option<f64>,
}

#[derive(Serialize)]
pub(super) struct ScreeningReport {
    pub(super) rater: String,
    pub(super) above: usize,
    pub(super) below: usize,
    pub(super) ratings: usize,
    pub(super) correlation: Option<f64>,
    pub(super) rejected: bool,
}

/// A number that may not exist.
pub(super) fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "none".to_owned(), |value| format!("{value:.3}"))
}
