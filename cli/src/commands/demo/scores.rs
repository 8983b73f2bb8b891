//! What was found, measured by the truth that the films were made of.

use std::path::Path;

use anyhow::{Context as _, Result};
use ga_runtime::cga3::Point;
use ga_video::comfort::Dimension;
use serde::Serialize;
use serde_json::Value;

use super::inputs::Truth;
use super::joints::JointErrors;
use super::run::Run;
use super::steps::{CALIBRATION, CONTOUR, EVALUATION};
use super::studio::SQUARE;

/// How good the results are.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Scores {
    /// Of the edges of squares, as the calibrated rig measures them.
    pub(super) board_edges_error_percent: f64,
    pub(super) baseline_error_millimetres: f64,
    pub(super) focal_error_percent: f64,
    /// Of all pixels with truth, and of those that both views show.
    pub(super) bad_2_percent: f64,
    pub(super) bad_2_visible_percent: f64,
    pub(super) circle_centre_error_millimetres: f64,
    pub(super) circle_radius_error_millimetres: f64,
    /// The true one.
    pub(super) circle_radius_metres: f64,
    #[serde(flatten)]
    pub(super) joints: JointErrors,
    /// Checks that are orange or red in a frame, by their names in files.
    pub(super) uncomfortable_before: Vec<String>,
    pub(super) uncomfortable_after: Vec<String>,
}

/// A score with what is asked for.
pub(super) struct Goal {
    pub(super) name: &'static str,
    pub(super) found: String,
    pub(super) asked: &'static str,
    pub(super) is_reached: bool,
}

impl Scores {
    pub(super) fn new(run: &Run, truth: &Truth) -> Result<Self> {
        let edges = run.number(CALIBRATION, "/square_edge_mean_metres")?;
        let (found, known) = (run.rig, truth.rig);
        let focal = found.left.intrinsics.focal()[0] / known.left.intrinsics.focal()[0];
        let centre = |axis: usize| run.number(CONTOUR, &format!("/circle/centre_metres/{axis}"));
        let centre = [centre(0)?, centre(1)?, centre(2)?];
        let in_frame = truth.rig.left.world_to_camera.transform(truth.disc.centre);
        // The command has y up and z backwards.
        let [x, y, z] = in_frame.coordinates();
        let in_frame = Point::new(x, -y, -z);
        let radius = run.number(CONTOUR, "/circle/radius_metres")?;
        Ok(Self {
            board_edges_error_percent: 100.0 * (edges / SQUARE - 1.0).abs(),
            baseline_error_millimetres: 1e3 * (found.baseline() - known.baseline()).abs(),
            focal_error_percent: 100.0 * (focal - 1.0).abs(),
            bad_2_percent: run.number(EVALUATION, "/bad_2")?,
            bad_2_visible_percent: run.number(EVALUATION, "/visible/bad_2")?,
            circle_centre_error_millimetres: 1e3 * in_frame.distance(centre.into()),
            circle_radius_error_millimetres: 1e3 * (radius - truth.disc.radius).abs(),
            circle_radius_metres: truth.disc.radius,
            joints: JointErrors::of_table(Path::new("person/joints.csv"), truth, &known.left)?,
            uncomfortable_before: uncomfortable(Path::new("comfort.json"))?,
            uncomfortable_after: uncomfortable(Path::new("aligned.json"))?,
        })
    }

    /// The scores that something is asked of.
    pub(super) fn goals(&self) -> Vec<Goal> {
        let joints = &self.joints;
        let below = |name, value: f64, unit: &str, most: f64, asked| Goal {
            name,
            found: match value {
                ..0.01 => format!("{value:.4}{unit}"),
                _ => format!("{value:.2}{unit}"),
            },
            asked,
            is_reached: value <= most,
        };
        let comfort = match self.uncomfortable_after.as_slice() {
            [] => "all green".to_owned(),
            checks => in_words(checks),
        };
        vec![
            below(
                "joints, mean distance from the true ones (MPJPE)",
                joints.mean_per_joint_position_error_millimetres,
                " mm",
                15.0,
                "≤ 15 mm",
            ),
            below(
                "joints, after each frame is aligned",
                joints.aligned_error_millimetres,
                " mm",
                12.0,
                "≤ 12 mm",
            ),
            below(
                "edges of the chessboard's squares",
                self.board_edges_error_percent,
                " %",
                0.5,
                "≤ 0.5 %",
            ),
            below(
                "pixels whose disparity is wrong by more than 2",
                self.bad_2_percent,
                " %",
                8.0,
                "≤ 8 %",
            ),
            Goal {
                name: "comfort of the aligned film",
                found: comfort,
                asked: "all green",
                is_reached: self.uncomfortable_after.is_empty(),
            },
        ]
    }
}

/// The checks of a summary that are orange or red in a frame. Too little depth does not count,
/// since it does not strain the eyes.
fn uncomfortable(path: &Path) -> Result<Vec<String>> {
    let text = std::fs::read(path).with_context(|| path.display().to_string())?;
    let summary: Value = serde_json::from_slice(&text)?;
    let rows = summary["rows"]
        .as_object()
        .context("a summary without rows")?;
    let strains = rows.iter().filter(|(name, row)| {
        let count = |level: &str| row[format!("frames_{level}")].as_u64().unwrap_or_default();
        name.as_str() != "weak_depth" && count("orange") + count("red") > 0
    });
    Ok(strains.map(|(name, _)| name.clone()).collect())
}

/// Names of checks as the pages of comfort have them.
pub(super) fn in_words(names: &[String]) -> String {
    let checks = Dimension::ALL.iter();
    let named = checks.filter(|check| names.iter().any(|name| name == check.name()));
    let words: Vec<String> = named.map(|check| check.in_words().to_lowercase()).collect();
    words.join(", ")
}
