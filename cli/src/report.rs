//! `report.json`: the input, the results and their quality. Equal input gives equal bytes.

use serde::Serialize;

use crate::checks::Checks;
use crate::output::File;
use crate::two_views::TwoViews;

#[derive(Clone, Debug, Serialize)]
pub(crate) struct Report {
    pub(crate) tool: Tool,
    pub(crate) command: &'static str,
    pub(crate) input: Input,
    pub(crate) figure: FigureReport,
    pub(crate) animation: AnimationReport,
    pub(crate) two_views: TwoViews,
    pub(crate) files: Vec<FileReport>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct Tool {
    pub(crate) name: &'static str,
    pub(crate) version: &'static str,
}

impl Tool {
    pub(crate) const NULLCONE: Self = Self {
        name: "nullcone",
        version: env!("CARGO_PKG_VERSION"),
    };
}

/// The input.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Input {
    /// File names without their folders, or what the program made itself.
    pub(crate) mesh: String,
    pub(crate) rig: String,
    pub(crate) weights: String,
    pub(crate) motion: MotionInput,
}

/// The motion of the input.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct MotionInput {
    pub(crate) name: String,
    pub(crate) joints: usize,
    pub(crate) frames: usize,
    pub(crate) frames_per_second: f64,
    /// The frames that were used, counted from 0.
    pub(crate) first_frame: usize,
    pub(crate) last_frame: usize,
    /// Whether frame 0 was taken for a calibration pose and left out.
    pub(crate) calibration_frame_left_out: bool,
    /// Joints of the rig that the motion does not have: they move with their parents.
    pub(crate) joints_without_counterpart: Vec<String>,
    /// How long one unit of the motion is on the figure.
    pub(crate) metres_per_unit: f64,
}

/// The figure that moves.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct FigureReport {
    pub(crate) name: String,
    /// The group of the input mesh that it is; `null` for the whole.
    pub(crate) group: Option<String>,
    /// How long one unit of the input mesh is.
    pub(crate) metres_per_unit: f64,
    pub(crate) height_metres: f64,
    pub(crate) vertices: usize,
    pub(crate) faces: usize,
    pub(crate) triangles: usize,
    pub(crate) joints: usize,
    /// The greatest number of joints that move one vertex.
    pub(crate) influences_max: usize,
}

/// The animation that was written.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct AnimationReport {
    pub(crate) name: String,
    pub(crate) frames: usize,
    pub(crate) frames_per_second: f64,
    pub(crate) duration_seconds: f64,
    pub(crate) checks: Checks,
    /// The greatest distance of a joint of an in-between on the sheet from its recorded position at
    /// that time; `null` where the motion consists of key frames only.
    pub(crate) in_between_deviation_max_metres: Option<f64>,
}

/// A file that was written beside this one.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct FileReport {
    pub(crate) name: &'static str,
    pub(crate) bytes: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) vertices: Option<usize>,
    /// Width and height.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) pixels: Option<[u32; 2]>,
}

impl FileReport {
    pub(crate) fn new(file: &File, vertices: Option<usize>, pixels: Option<[u32; 2]>) -> Self {
        Self {
            name: file.name,
            bytes: file.contents.len(),
            vertices,
            pixels,
        }
    }
}
