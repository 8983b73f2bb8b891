//! What a file says of a camera, under the names of JSON.

use serde::Serialize;

use super::camera::used_coefficients;
use super::camera_file::NamedCamera;
use super::error::CameraFileError;

/// A camera in pixels and metres.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CameraSummary {
    /// Its name.
    pub name: String,
    /// The columns of its pictures, where they are known.
    pub width_px: Option<usize>,
    /// Their rows.
    pub height_px: Option<usize>,
    /// The focal lengths.
    pub focal_px: [f64; 2],
    /// The principal point.
    pub principal_px: [f64; 2],
    /// The kind of the lens.
    pub lens: &'static str,
    /// Its coefficients in OpenCV's order.
    pub distortion: Vec<f64>,
    /// The rotation from the world to the camera, by rows, where the pose is known.
    pub rotation: Option<[[f64; 3]; 3]>,
    /// The translation after it.
    pub translation_metres: Option<[f64; 3]>,
}

impl CameraSummary {
    /// The summary of a camera.
    ///
    /// # Errors
    /// As [`NamedCamera::intrinsics_and_skew`].
    pub fn new(camera: &NamedCamera) -> Result<Self, CameraFileError> {
        let (intrinsics, _) = camera.intrinsics_and_skew()?;
        let lens = intrinsics.lens();
        Ok(Self {
            name: camera.name.clone(),
            width_px: camera.size.map(|[width, _]| width),
            height_px: camera.size.map(|[_, height]| height),
            focal_px: intrinsics.focal(),
            principal_px: intrinsics.principal(),
            lens: lens.model().name(),
            distortion: used_coefficients(&lens),
            rotation: camera.pose.map(|pose| pose.rotor().to_matrix()),
            translation_metres: camera.pose.map(|pose| pose.translator().displacement()),
        })
    }
}
