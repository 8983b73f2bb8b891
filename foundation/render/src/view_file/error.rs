use ga_camera::format::CameraFileError;
use ga_image::file::FormatError;

use crate::RenderError;

/// A camera that cannot be drawn from, or pictures and cameras that cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ViewFileError {
    /// The camera has no pose, size or picture.
    #[error(transparent)]
    Camera(#[from] CameraFileError),
    /// The camera is not one that can be drawn from.
    #[error(transparent)]
    View(#[from] RenderError),
    /// The picture has no camera.
    #[error("the camera of a picture: {0}")]
    PictureCamera(RenderError),
    /// The picture cannot be encoded.
    #[error(transparent)]
    Picture(#[from] FormatError),
}
