//! What `nullcone capture` prints.

use std::path::PathBuf;

use ga_vision::capture::summary::{ExpressionSummary, PoseSummary, SurfaceSummary};
use serde::Serialize;

use crate::frame::{self, Warning};

#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    pub(super) warnings: Vec<Warning>,
    /// What was written.
    #[serde(skip)]
    pub(super) files: Vec<PathBuf>,
    pub(super) frames: usize,
    pub(super) frames_without_pose: usize,
    pub(super) points: usize,
    pub(super) calibrated: Vec<String>,
    pub(super) reference_frame: String,
    pub(super) expression: ExpressionSummary,
    pub(super) poses: Vec<PoseSummary>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) surface: Option<SurfaceSummary>,
    pub(super) seconds: f64,
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        let greatest = |of: fn(&PoseSummary) -> Option<f64>| {
            self.poses.iter().filter_map(of).fold(0.0, f64::max)
        };
        let outliers: usize = self.poses.iter().map(|pose| pose.outliers.len()).sum();
        let expression = &self.expression;
        let mut lines = format!(
            "{} frames of {} points; {} of them calibrated, at rest in frame {}\n\
             pose: rotations up to {:.2}°, calibrated points agree to {:.3} mm, {outliers} left \
             out\n\
             expression: {:.2} mm root mean square, up to {:.2} mm at point {} in frame {}\n",
            self.frames,
            self.points,
            self.calibrated.len(),
            self.reference_frame,
            greatest(|pose| pose.rotation_degrees),
            1e3 * greatest(|pose| pose.rms),
            1e3 * expression.rms,
            1e3 * expression.max,
            expression.max_point,
            expression.max_frame
        );
        if let Some(surface) = &self.surface {
            let area = &surface.area;
            let [x, y, z] = area.centre;
            let kept = if area.centre_kept { ", kept" } else { "" };
            lines += &format!(
                "surface: {} of {} vertices move with {} keys; {} morph targets, exact to {:.4} mm\n\
                 centre of gravity ({x:.4}, {y:.4}, {z:.4}){kept}\n",
                area.vertices,
                surface.vertices,
                surface.keys,
                surface.morph_targets,
                1e3 * surface.morph_error_max
            );
        }
        for path in &self.files {
            lines += &format!("wrote {}\n", path.display());
        }
        lines
    }
}
