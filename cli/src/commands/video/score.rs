//! Found cuts against labelled ones.

use std::path::PathBuf;

use anyhow::Result;
use ga_video::keyframe::evaluation::{Score, labels, score};
use serde::Deserialize;

use crate::frame::{Command, Context, Shown};

/// Compare found cuts with labelled ones: precision, recall and F1.
///
/// Each found cut is paired with at most one label that is at most --tolerance frames away, and
/// each label with at most one cut. --json prints {"correct", "extra", "missed", "precision",
/// "recall", "f1"}; a quotient without a denominator is null.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(super) struct Arguments {
    /// What nullcone video keyframes --json printed, or any JSON object with "cuts".
    #[arg(value_name = "FOUND.json")]
    found: PathBuf,
    /// The first frames of the shots after the labelled cuts, a number a line; the first line may
    /// be a name.
    #[arg(value_name = "LABELS.csv")]
    labels: PathBuf,
    /// How far a cut may be from its label, in frames.
    #[arg(long, value_name = "FRAMES", default_value_t = 0)]
    tolerance: usize,
}

#[derive(Deserialize)]
struct Found {
    cuts: Vec<usize>,
}

impl Command for Arguments {
    type Report = Shown<Score>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        context.files([&self.found, &self.labels])?;
        let found: Found = ga_files::read(&self.found, |bytes| serde_json::from_slice(bytes))?;
        let labels = ga_files::read(&self.labels, labels)?;
        let scored = score(&found.cuts, &labels, self.tolerance);
        let number = |value: Option<f64>| value.map_or("none".into(), |v| format!("{v:.4}"));
        let text = format!(
            "{} correct, {} extra, {} missed\nprecision {}, recall {}, F1 {}\n",
            scored.correct,
            scored.extra,
            scored.missed,
            number(scored.precision()),
            number(scored.recall()),
            number(scored.f1())
        );
        Ok(Shown::new(scored, text))
    }
}
