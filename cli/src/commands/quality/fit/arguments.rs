//! The options of the command.

use std::path::PathBuf;

/// Fit opinion scores by a measure of quality, and say how well the measure predicts them.
///
/// SCORES.csv has a line of names and the columns objective (the scores of the measure) and
/// subjective (the mean opinion scores), perhaps also deviation (the standard deviation of each
/// mean opinion score). Logistic curves with four and five parameters are fitted. Of the prediction
/// by the curve with five follow the linear correlation (PLCC), the error (RMSE) and the part of
/// outliers; the rank correlations SROCC and KROCC need no curve. Intervals come from the
/// bootstrap.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The scores.
    #[arg(value_name = "SCORES.csv")]
    pub(super) scores: PathBuf,
    /// Compare with another measure, whose scores stand in this column, and say whether the
    /// difference is significant.
    #[arg(long, value_name = "COLUMN")]
    pub(super) against: Option<String>,
    /// The confidence of the intervals.
    #[arg(long, value_name = "PART", default_value_t = 0.95)]
    pub(super) confidence: f64,
    /// How often the scores are drawn again for the intervals.
    #[arg(long, value_name = "N", default_value_t = 1000,
        value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(super) draws: u32,
    /// The seed of the draws.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(super) seed: u64,
    /// Write a picture of the scores with the fitted curves.
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
}
