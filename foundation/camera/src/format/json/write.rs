//! Cameras as JSON.

use std::path::Path;

use serde::Serialize;

use crate::Lens;
use crate::format::camera_file::NamedCamera;
use crate::format::error::CameraFileError;

#[derive(Serialize)]
struct Views {
    views: Vec<View>,
}

#[derive(Serialize)]
struct View {
    picture: String,
    camera: Camera,
}

#[derive(Serialize)]
struct Camera {
    width: usize,
    height: usize,
    fx: f64,
    fy: f64,
    cx: f64,
    cy: f64,
    skew: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    lens: Option<&'static str>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    distortion: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rotation: Option<[[f64; 3]; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    translation: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    near: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    far: Option<f64>,
}

/// The text of the file of one camera.
///
/// # Errors
/// [`CameraFileError::NoSize`] for a camera whose size is not known.
pub fn encode(camera: &NamedCamera) -> Result<String, CameraFileError> {
    text(&Camera::new(camera)?)
}

/// The text of a file of views, which lies in a folder to which the paths of pictures are relative.
///
/// # Errors
/// [`CameraFileError`] for a camera without a size, a pose or a picture.
pub fn encode_views(cameras: &[NamedCamera], folder: &Path) -> Result<String, CameraFileError> {
    let views = cameras.iter().map(|camera| {
        let picture = camera.picture.as_deref();
        let picture = picture.ok_or_else(|| CameraFileError::NoPicture {
            name: camera.name.clone(),
        })?;
        let relative = picture.strip_prefix(folder).unwrap_or(picture);
        camera.world_to_camera()?;
        Ok(View {
            picture: relative.to_string_lossy().into_owned(),
            camera: Camera::new(camera)?,
        })
    });
    text(&Views {
        views: views.collect::<Result<_, CameraFileError>>()?,
    })
}

fn text(value: &impl Serialize) -> Result<String, CameraFileError> {
    serde_json::to_string_pretty(value).map_err(|error| CameraFileError::Syntax {
        line: error.line(),
        format: "JSON",
        problem: error.to_string(),
    })
}

impl Camera {
    fn new(camera: &NamedCamera) -> Result<Self, CameraFileError> {
        let (intrinsics, skew) = camera.intrinsics_and_skew()?;
        let [width, height] = camera.known_size()?;
        let ([fx, fy], [cx, cy]) = (intrinsics.focal(), intrinsics.principal());
        let lens = intrinsics.lens();
        Ok(Self {
            width,
            height,
            fx,
            fy,
            cx,
            cy,
            skew,
            lens: (lens != Lens::Pinhole).then(|| lens.model().name()),
            distortion: lens.coefficients()[..lens.coefficient_count()].to_vec(),
            rotation: camera.pose.map(|pose| pose.rotor().to_matrix()),
            translation: camera.pose.map(|pose| pose.translator().displacement()),
            near: camera.near,
            far: camera.far,
        })
    }
}
