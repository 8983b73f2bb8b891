//! What is said of a person.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::ground::Ground;

/// What was found of a person.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CharacterReport {
    /// The number of views.
    pub views: usize,
    /// The number of frames.
    pub frames: usize,
    /// The frame rate of the animation.
    pub frames_per_second: f64,
    /// The names of the character's joints that were fitted.
    pub joints: Vec<String>,
    /// The names of points of the skin that were fitted beside them: nose, eyes, ears, heels, toes.
    pub points_of_the_skin: Vec<String>,
    /// The names of joints of the person that the character does not have.
    pub joints_without_counterpart: Vec<String>,
    /// The median of the distances from pixels.
    pub reprojection_median_px: f64,
    /// The root mean square of the distances from pixels.
    pub reprojection_rms_px: f64,
    /// The greatest of these distances.
    pub reprojection_max_px: f64,
    /// By how much the standard deviations of pixels are larger than was stated, as the distances
    /// show; at least 1.
    pub deviation_factor: f64,
    /// How many joints no view shows, over all frames.
    pub joints_unseen: usize,
    /// In how many frames there are such joints.
    pub frames_with_unseen_joints: usize,
    /// The time of the fit, with all threads.
    pub milliseconds_per_frame: f64,
    /// Where lengths were fitted, by the name of each joint by how much longer the way from the
    /// joint above it has become.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_factors: Option<BTreeMap<String, f64>>,
    /// The lengths of the bones.
    pub bones: Vec<BoneReport>,
    /// The ground, where it was asked for and found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ground: Option<Ground>,
    /// One for each view.
    pub per_view: Vec<ViewReport>,
    /// One for each frame.
    pub per_frame: Vec<FrameReport>,
}

/// What was found in a view.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ViewReport {
    /// The name of the view.
    pub name: String,
    /// How many joints it shows, over all frames.
    pub joints_seen: usize,
    /// The median of the distances from its pixels.
    pub reprojection_median_px: f64,
    /// The root mean square of the distances from its pixels.
    pub reprojection_rms_px: f64,
    /// The number of the frame that shows what frame 0 of the first view shows, as the motion
    /// shows it; `None` where it does not, or was not asked.
    pub offset_frames: Option<f64>,
    /// The standard deviation of this number.
    pub offset_deviation_frames: Option<f64>,
    /// By how much the camera is rotated from where it was said to be.
    pub rotation_degrees: Option<f64>,
    /// The standard deviation of this angle about an axis.
    pub rotation_deviation_degrees: Option<f64>,
    /// The frames in which left and right are exchanged.
    pub frames_with_exchanged_sides: Vec<usize>,
}

/// The length of a bone: of the way from a joint to the one above it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoneReport {
    /// The name of the joint.
    pub joint: String,
    /// The length.
    pub length_metres: f64,
    /// Its standard deviation; `None` where the length was not estimated.
    pub deviation_metres: Option<f64>,
}

/// What was found in a frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FrameReport {
    /// The root mean square of the distances from its pixels, over all views.
    pub reprojection_rms_px: f64,
    /// The names of the joints that no view shows.
    pub joints_unseen: Vec<String>,
}
