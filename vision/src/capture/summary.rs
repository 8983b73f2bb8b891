//! How far the points of a face and its surface move, in metres, under the names of JSON.

use ga_runtime::vga3::Vector;
use serde::Serialize;

use super::sequence::{CapturedFrame, FrameOutcome};
use super::table::{PointRow, PointTable};

/// How far points move beyond the pose.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExpressionSummary {
    /// The root mean square over all points that were seen.
    #[serde(rename = "rms_metres")]
    pub rms: f64,
    /// The greatest displacement.
    #[serde(rename = "max_metres")]
    pub max: f64,
    /// The name of its point.
    pub max_point: String,
    /// The name of its frame.
    pub max_frame: String,
    /// Each point.
    pub points: Vec<PointSummary>,
}

/// How far one point moves beyond the pose.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PointSummary {
    /// Its name.
    pub name: String,
    /// In how many frames with a pose it was seen.
    pub frames_seen: usize,
    /// The root mean square over those.
    #[serde(rename = "rms_metres")]
    pub rms: f64,
    /// The greatest displacement.
    #[serde(rename = "max_metres")]
    pub max: f64,
}

/// The pose of the head in a frame: the motion since it was at rest. The numbers of a frame without
/// a pose do not exist, and are `null` in JSON.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct PoseSummary {
    /// The name of the frame.
    pub frame: String,
    /// The translation.
    #[serde(rename = "translation_metres")]
    pub translation: Option<[f64; 3]>,
    /// x, y, z, w.
    pub rotation_quaternion: Option<[f64; 4]>,
    /// The axis, of length 1.
    pub rotation_axis: Option<[f64; 3]>,
    /// The angle, of no more than 180°.
    pub rotation_degrees: Option<f64>,
    /// The root mean square distance of the calibrated points that agree from where the pose takes
    /// them.
    #[serde(rename = "rms_metres")]
    pub rms: Option<f64>,
    /// How many agree.
    pub inliers: Option<usize>,
    /// Calibrated points that were seen and do not agree.
    pub outliers: Vec<String>,
    /// Calibrated points that were not seen.
    pub missing: Vec<String>,
    /// Why the frame has no pose.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pose_reason: Option<String>,
}

/// A surface and its motion, in the coordinates of the mesh, scaled to metres.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SurfaceSummary {
    /// How many vertices there are.
    pub vertices: usize,
    /// How many keys there are.
    pub keys: usize,
    /// How often a key was not seen, and moved as its neighbours do.
    pub keys_filled: usize,
    /// The root mean square distance between the keys and the points at rest.
    #[serde(rename = "key_fit_rms_metres")]
    pub key_fit_rms: f64,
    /// The centre from which the surface is seen.
    #[serde(rename = "sphere_centre_metres")]
    pub sphere_centre: [f64; 3],
    /// How many triangles are seen from the other side than most of the area is.
    pub folded_triangles: usize,
    /// How many shapes represent the motion.
    pub morph_targets: usize,
    /// The greatest distance of a key from where they take it.
    #[serde(rename = "morph_error_max_metres")]
    pub morph_error_max: f64,
    /// The length of the mesh's unit.
    pub metres_per_mesh_unit: f64,
    /// The part that moves.
    pub area: AreaSummary,
}

/// The part of a surface that moves.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AreaSummary {
    /// The key in its middle, unless it is the whole surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub key: Option<String>,
    /// Its radius.
    #[serde(rename = "radius_metres", skip_serializing_if = "Option::is_none")]
    pub radius: Option<f64>,
    /// How many vertices it has.
    pub vertices: usize,
    /// Its centre of gravity at rest.
    #[serde(rename = "centre_metres")]
    pub centre: [f64; 3],
    /// Whether the centre stays there.
    pub centre_kept: bool,
    /// How far the centre is from there, in each frame; `None` where the surface has no expression.
    #[serde(rename = "centre_displacement_metres")]
    pub centre_displacement: Vec<Option<[f64; 3]>>,
}

impl ExpressionSummary {
    /// Of those frames of a table that have a pose.
    #[must_use]
    pub fn new(points: &PointTable, frames: &[FrameOutcome]) -> Self {
        let mut of_points = Vec::with_capacity(points.names.len());
        let (mut squares, mut count) = (0.0, 0);
        // The greatest, its point and its frame.
        let mut greatest = (0.0, 0, 0);
        for (point, name) in points.names.iter().enumerate() {
            let (mut sum, mut seen, mut max) = (0.0, 0, 0.0_f64);
            for (index, frame) in frames.iter().enumerate() {
                let moved = frame
                    .as_ref()
                    .ok()
                    .and_then(|frame| frame.expression[point]);
                let Some(length) = moved.map(Vector::length) else {
                    continue;
                };
                sum += length * length;
                seen += 1;
                max = max.max(length);
                if length > greatest.0 {
                    greatest = (length, point, index);
                }
            }
            squares += sum;
            count += seen;
            of_points.push(PointSummary {
                name: name.clone(),
                frames_seen: seen,
                rms: (sum / seen.max(1) as f64).sqrt(),
                max,
            });
        }
        let (max, point, frame) = greatest;
        Self {
            rms: (squares / count.max(1) as f64).sqrt(),
            max,
            max_point: points.names[point].clone(),
            max_frame: points.frames[frame].label.clone(),
            points: of_points,
        }
    }
}

impl PoseSummary {
    /// Of each frame of a table, in which some points are calibrated.
    #[must_use]
    pub fn of_frames(
        points: &PointTable,
        calibrated: &[usize],
        frames: &[FrameOutcome],
    ) -> Vec<Self> {
        let names = |all: Vec<usize>| all.into_iter().map(|k| points.names[k].clone()).collect();
        let summary = |(row, outcome): (&PointRow, &FrameOutcome)| {
            let (seen, missing): (Vec<usize>, Vec<usize>) = calibrated
                .iter()
                .partition(|&&point| row.points[point].is_some());
            let start = Self {
                frame: row.label.clone(),
                missing: names(missing),
                ..Self::default()
            };
            match outcome {
                Ok(frame) => {
                    let is_outlier = |point: &usize| !frame.pose.inliers.contains(point);
                    let outliers = names(seen.into_iter().filter(is_outlier).collect());
                    Self { outliers, ..start }.with_pose(frame)
                }
                Err(problem) => Self {
                    pose_reason: Some(points.reason(problem)),
                    ..start
                },
            }
        };
        points.frames.iter().zip(frames).map(summary).collect()
    }

    fn with_pose(self, frame: &CapturedFrame) -> Self {
        let motor = frame.motor();
        let rotor = motor.rotor();
        let (rotation_axis, angle) = rotor.canonical().to_axis_angle();
        let ([x, y, z], w) = rotor.to_quaternion();
        Self {
            translation: Some(motor.translator().displacement()),
            rotation_quaternion: Some([x, y, z, w]),
            rotation_axis: Some(rotation_axis),
            rotation_degrees: Some(angle.to_degrees()),
            rms: Some(frame.pose.root_mean_square),
            inliers: Some(frame.pose.inliers.len()),
            ..self
        }
    }
}
