//! Cameras as JSON files.

use ga_render::{Camera, Intrinsics, RenderError};
use ga_runtime::cga3::Motor;
use serde::{Deserialize, Serialize};

/// A pinhole camera for pictures of one size: intrinsics in pixels, and the pose from the world to
/// the camera's frame with x to the right, y down and z forwards. The middle of the first pixel is
/// (0, 0).
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CameraFile {
    width: u32,
    height: u32,
    fx: f64,
    fy: f64,
    cx: f64,
    cy: f64,
    #[serde(default)]
    skew: f64,
    /// By rows.
    rotation: [[f64; 3]; 3],
    translation: [f64; 3],
    /// The least depth that is drawn, in the unit of the model.
    #[serde(default = "default_near")]
    near: f64,
    /// The greatest depth that is drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    far: Option<f64>,
}

/// What is wrong with a camera's file.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CameraFileError {
    /// It is not JSON of this form.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    /// The rotation is none.
    #[error("`rotation` and `translation` are not a rigid motion: {0:?}, {1:?}")]
    Pose([[f64; 3]; 3], [f64; 3]),
    /// The camera cannot be used.
    #[error(transparent)]
    Camera(#[from] RenderError),
}

fn default_near() -> f64 {
    1e-3
}

impl CameraFile {
    pub(crate) fn parse(bytes: &[u8]) -> Result<Self, CameraFileError> {
        let file: Self = serde_json::from_slice(bytes)?;
        file.camera()?;
        Ok(file)
    }

    /// The file of a camera that takes pictures of a size.
    pub(crate) fn new(camera: &Camera, [width, height]: [u32; 2]) -> Self {
        let intrinsics = camera.intrinsics(width, height);
        let pose = camera.world_to_camera();
        Self {
            width,
            height,
            fx: intrinsics.focal[0],
            fy: intrinsics.focal[1],
            cx: intrinsics.principal[0],
            cy: intrinsics.principal[1],
            skew: intrinsics.skew,
            rotation: pose.rotor().to_matrix(),
            translation: pose.translator().displacement(),
            near: camera.near(),
            far: Some(camera.far()).filter(|far| far.is_finite()),
        }
    }

    /// Columns and rows of its pictures.
    pub(crate) fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    pub(crate) fn camera(&self) -> Result<Camera, CameraFileError> {
        let (rotation, translation) = (self.rotation, self.translation);
        let rows = [0, 1, 2].map(|i: usize| {
            let [x, y, z] = rotation[i];
            [x, y, z, translation[i]]
        });
        let pose = Motor::from_matrix(rows).ok_or(CameraFileError::Pose(rotation, translation))?;
        let intrinsics = Intrinsics {
            skew: self.skew,
            ..Intrinsics::new([self.fx, self.fy], [self.cx, self.cy])
        };
        let camera = Camera::pinhole(intrinsics, pose, self.near)?;
        Ok(match self.far {
            Some(far) => camera.with_far(far)?,
            None => camera,
        })
    }
}
