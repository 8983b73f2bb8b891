//! Found cuts against labelled ones.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use ga_files::table::Table;
use ga_video::keyframe::evaluation::score;
use serde::{Deserialize, Serialize};

use crate::frame::{self, Command, Context};

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

#[derive(Serialize)]
pub(super) struct Scores {
    correct: usize,
    extra: usize,
    missed: usize,
    precision: Option<f64>,
    recall: Option<f64>,
    f1: Option<f64>,
}

impl Command for Arguments {
    type Report = Scores;

    fn run(&self, context: &Context) -> Result<Scores> {
        context.files([&self.found, &self.labels])?;
        let found: Found = serde_json::from_slice(&read(&self.found)?)
            .with_context(|| self.found.display().to_string())?;
        let labels = labels(&self.labels)?;
        let scored = score(&found.cuts, &labels, self.tolerance);
        Ok(Scores {
            correct: scored.correct,
            extra: scored.extra,
            missed: scored.missed,
            precision: scored.precision(),
            recall: scored.recall(),
            f1: scored.f1(),
        })
    }
}

impl frame::Report for Scores {
    fn text(&self) -> String {
        let shown = |value: Option<f64>| value.map_or("none".into(), |value| format!("{value:.4}"));
        format!(
            "{} correct, {} extra, {} missed\nprecision {}, recall {}, F1 {}\n",
            self.correct,
            self.extra,
            self.missed,
            shown(self.precision),
            shown(self.recall),
            shown(self.f1)
        )
    }
}

fn read(path: &Path) -> Result<Vec<u8>> {
    std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))
}

/// The numbers of the first column.
fn labels(path: &Path) -> Result<Vec<usize>> {
    let table = Table::parse(&read(path)?).with_context(|| path.display().to_string())?;
    let labels = (0..table.len()).map(|row| {
        let label = table.text(row, 0);
        label.parse().with_context(|| {
            let (file, line) = (path.display(), table.line(row));
            format!("{file}: line {line}: {label:?} is not a frame number")
        })
    });
    labels.collect()
}
