//! The options of the command.

use std::path::PathBuf;

/// Evaluate a table of ratings: mean opinion scores with intervals, groups, agreement, screening.
///
/// TABLE.csv has a line of names, a row for each rater and a column for each question. A column
/// rater has the raters' names; a column group, such as expert and lay, is compared by the test of
/// Welch. A rating may be missing. Raters who answer without order are found by the rule of ITU-R
/// BT.500; with --screen they are left out.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The ratings.
    #[arg(value_name = "TABLE.csv")]
    pub(super) table: PathBuf,
    /// The confidence of the intervals.
    #[arg(long, value_name = "PART", default_value_t = 0.95)]
    pub(super) confidence: f64,
    /// Leave out the raters who are rejected by the screening.
    #[arg(long)]
    pub(super) screen: bool,
    /// Write a picture of the opinions and of how many people gave which rating.
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
}
