//! `report.json`, and what is printed of it.

use std::collections::BTreeMap;

use anyhow::Result;
use serde::Serialize;
use serde_json::Value;

use super::algebra::{LegBothWays, Level, Weights};
use super::run::Run;
use super::scores::Scores;
use crate::frame::{self, Warning};
use crate::pipeline::REPORT;
use crate::report::{self, Performed, Written};

/// What was made and found.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(flatten)]
    figure: report::Report,
    scores: Scores,
    #[serde(skip_serializing_if = "Option::is_none")]
    leg: Option<LegBothWays>,
    modelling_points: Vec<Level>,
    weights: Weights,
    steps: BTreeMap<&'static str, Value>,
    /// Only printed.
    #[serde(rename = "written", skip_serializing_if = "Vec::is_empty")]
    pub(super) files: Vec<Written>,
    #[serde(skip_serializing_if = "is_zero")]
    pub(super) seconds: f64,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
fn is_zero(seconds: &f64) -> bool {
    *seconds == 0.0
}

impl Report {
    pub(super) fn new(
        figure: Performed,
        run: &Run,
        scores: Scores,
        leg: Option<LegBothWays>,
        modelling_points: Vec<Level>,
        weights: Weights,
    ) -> Self {
        Self {
            figure: figure.report,
            scores,
            leg,
            modelling_points,
            weights,
            steps: run.values(),
            files: Vec::new(),
            seconds: 0.0,
            warnings: figure.warnings,
        }
    }

    /// Writes the file into the current folder.
    pub(super) fn write(&self) -> Result<()> {
        let text = serde_json::to_string_pretty(self)? + "\n";
        Ok(ga_files::write(REPORT, text.as_bytes())?)
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        let mut text = String::new();
        for goal in self.scores.goals() {
            let word = if goal.is_reached { "reached" } else { "missed" };
            text += &format!(
                "{:50} {:>9}  {:8} {word}\n",
                goal.name, goal.found, goal.asked
            );
        }
        let bytes: usize = self.files.iter().map(|file| file.bytes).sum();
        text += &format!(
            "wrote {} files, {:.0} MB, in {:.1} s\n",
            self.files.len(),
            bytes as f64 / 1e6,
            self.seconds
        );
        text
    }
}
