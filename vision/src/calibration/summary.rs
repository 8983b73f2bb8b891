//! What a calibration says of a rig and its cameras, under the names of JSON.

use ga_camera::Intrinsics;
use serde::Serialize;

use super::board_pairs::BoardCalibration;

/// Root mean square distances of corners from their projections, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Residuals {
    /// Of both cameras.
    #[serde(rename = "rms_px")]
    pub both: f64,
    /// Of the left camera.
    #[serde(rename = "rms_left_px")]
    pub left: f64,
    /// Of the right camera.
    #[serde(rename = "rms_right_px")]
    pub right: f64,
}

/// A rig, in metres, degrees and pixels.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RigSummary {
    /// The distance between the cameras.
    #[serde(rename = "baseline_metres")]
    pub baseline: f64,
    /// Its standard deviation.
    #[serde(rename = "baseline_deviation_metres")]
    pub baseline_deviation: f64,
    /// The mean length of the edges of squares.
    #[serde(rename = "square_edge_mean_metres")]
    pub square_edge_mean: f64,
    /// Their root mean square difference from the given length.
    #[serde(rename = "square_edge_rms_error_metres")]
    pub square_edge_rms_error: f64,
    /// The angle between the cameras.
    pub rotation_degrees: f64,
    /// The left camera.
    pub left: CameraParameters,
    /// The right camera.
    pub right: CameraParameters,
    /// For each pair that was used the root mean square distance of its corners.
    pub pair_rms_px: Vec<f64>,
}

/// Intrinsic parameters with their standard deviations, in pixels.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CameraParameters {
    /// The focal lengths along u and v.
    #[serde(rename = "focal_px")]
    pub focal: [f64; 2],
    /// Their deviations, 0 for those that were not determined, as all that follow.
    #[serde(rename = "focal_deviation_px")]
    pub focal_deviation: [f64; 2],
    /// The principal point.
    #[serde(rename = "principal_px")]
    pub principal: [f64; 2],
    /// The deviations of its coordinates.
    #[serde(rename = "principal_deviation_px")]
    pub principal_deviation: [f64; 2],
    /// The coefficients of the lens in OpenCV's order, up to the last one that is not 0.
    pub distortion: Vec<f64>,
    /// Their deviations.
    pub distortion_deviation: Vec<f64>,
}

impl CameraParameters {
    /// The parameters of a camera with deviations in the order of [`Intrinsics::parameters`].
    #[must_use]
    pub fn new(camera: &Intrinsics, deviations: &[f64; Intrinsics::MAX_PARAMETERS]) -> Self {
        let coefficients = &camera.parameters()[4..];
        let last = coefficients
            .iter()
            .rposition(|coefficient| *coefficient != 0.0);
        let count = last.map_or(0, |last| last + 1);
        Self {
            focal: camera.focal(),
            focal_deviation: [deviations[0], deviations[1]],
            principal: camera.principal(),
            principal_deviation: [deviations[2], deviations[3]],
            distortion: coefficients[..count].to_vec(),
            distortion_deviation: deviations[4..4 + count].to_vec(),
        }
    }
}

impl BoardCalibration {
    /// How far corners are from their projections.
    #[must_use]
    pub fn residuals(&self) -> Residuals {
        let [left, right] = self.stereo.camera_rms;
        Residuals {
            both: self.stereo.rms,
            left,
            right,
        }
    }

    /// The rig in numbers.
    #[must_use]
    pub fn summary(&self) -> RigSummary {
        let found = &self.stereo;
        let rig = &found.rig;
        let rotation = rig.left_to_right().motor.rotor().canonical();
        RigSummary {
            baseline: rig.baseline(),
            baseline_deviation: found.baseline_deviation,
            square_edge_mean: self.edges.mean,
            square_edge_rms_error: self.edges.rms_error,
            rotation_degrees: rotation.to_axis_angle().1.to_degrees(),
            left: CameraParameters::new(&rig.left.intrinsics, &found.deviations[0]),
            right: CameraParameters::new(&rig.right.intrinsics, &found.deviations[1]),
            pair_rms_px: found.pair_rms.clone(),
        }
    }
}
