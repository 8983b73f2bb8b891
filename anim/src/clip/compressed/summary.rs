//! What is said of a compressed clip.

use serde::Serialize;

use super::{CompressedClip, Size, measure};
use crate::recording::Recording;

/// What a compressed clip consists of.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// How large it is.
    #[serde(flatten)]
    pub size: Size,
    /// The greatest error of a joint.
    pub tolerance_metres: f64,
    /// The distance from a joint within which points are kept within the tolerance.
    pub shell_metres: f64,
    /// The greatest deviation of a scalar track.
    pub track_tolerance: f64,
    /// Joints with bounds of their own.
    pub joint_bounds: Vec<BoundSummary>,
    /// The names of the joints.
    pub joint_names: Vec<String>,
    /// The index of each joint's parent; `None` for a root.
    pub joint_parents: Vec<Option<usize>>,
    /// The names of the scalar tracks.
    pub tracks: Vec<String>,
}

/// The bound of one joint.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoundSummary {
    /// The name of the joint.
    pub joint: String,
    /// Its greatest error.
    pub tolerance_metres: f64,
    /// The distance within which points are kept within it.
    pub shell_metres: f64,
}

impl Summary {
    /// Sums up a clip; see [`Size::new`].
    #[must_use]
    pub fn new(clip: &CompressedClip, mesh_vertices: Option<u64>) -> Self {
        let options = clip.options();
        let bounds = options.joints.iter().filter_map(|bound| {
            Some(BoundSummary {
                joint: clip.names().get(bound.joint)?.clone(),
                tolerance_metres: bound.tolerance,
                shell_metres: bound.shell,
            })
        });
        Self {
            size: Size::new(clip, mesh_vertices),
            tolerance_metres: options.tolerance,
            shell_metres: options.shell,
            track_tolerance: options.track_tolerance,
            joint_bounds: bounds.collect(),
            joint_names: clip.names().to_vec(),
            joint_parents: clip.parents().to_vec(),
            tracks: clip.track_names().map(ToOwned::to_owned).collect(),
        }
    }
}

/// How exact a compressed clip is: the errors of [`measure`] with the names of joints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Accuracy {
    /// The greatest error of a joint in a frame.
    pub max_error_metres: f64,
    /// The name of the joint that has it.
    pub max_error_joint: String,
    /// The frame in which it has it.
    pub max_error_frame: usize,
    /// The greatest error half-way between two frames.
    pub half_frame_error_metres: f64,
    /// How many scalar tracks there are.
    pub tracks: usize,
    /// The greatest deviation of a scalar track.
    pub max_track_error: f64,
}

impl Accuracy {
    /// The errors of a clip against a recording, or against what the recording was made of, from
    /// which it is `deviation` metres away. `None` unless the recording has the joints, frames and
    /// tracks of the clip.
    #[must_use]
    pub fn new(recording: &Recording, clip: &CompressedClip, deviation: f64) -> Option<Self> {
        let measured = measure(recording, clip)?;
        Some(Self {
            max_error_metres: measured.error + deviation,
            max_error_joint: recording.joints().get(measured.joint)?.name.clone(),
            max_error_frame: measured.frame,
            half_frame_error_metres: measured.half_frame_error + deviation,
            tracks: recording.tracks().len(),
            max_track_error: measured.track_error,
        })
    }
}
