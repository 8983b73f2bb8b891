use ga_camera::Camera;
use ga_camera::format::NamedCamera;

use super::error::ViewFileError;
use crate::View;

/// The least depth that is drawn where the file of a camera states none, in the unit of the model.
const NEAR: f64 = 1e-3;

/// What a camera of a file sees. Its least depth is 0.001 where the file states none.
///
/// # Errors
///
/// [`ViewFileError::Camera`] for a camera without a pose or of an unclear lens, and
/// [`ViewFileError::View`] for one that is not drawn from; see [`View::pinhole`].
pub fn from_camera(camera: &NamedCamera) -> Result<View, ViewFileError> {
    let (intrinsics, skew) = camera.intrinsics_and_skew()?;
    let pinhole = Camera {
        intrinsics,
        world_to_camera: camera.world_to_camera()?,
    };
    let view = View::pinhole(&pinhole, camera.near.unwrap_or(NEAR))?.with_skew(skew)?;
    Ok(match camera.far {
        Some(far) => view.with_far(far)?,
        None => view,
    })
}

/// The camera of a view that is drawn as a picture of these columns and rows.
///
/// # Errors
///
/// [`ViewFileError::PictureCamera`] for a picture without rows.
pub fn to_camera(name: &str, view: &View, size: [u32; 2]) -> Result<NamedCamera, ViewFileError> {
    let camera = view.camera(size[0], size[1]);
    let camera = camera.map_err(ViewFileError::PictureCamera)?;
    let mut named = NamedCamera::new(name, camera.intrinsics).with_skew(view.skew());
    named.size = Some(size.map(|side| side as usize));
    named.pose = Some(camera.world_to_camera);
    named.near = Some(view.near());
    named.far = Some(view.far()).filter(|far| far.is_finite());
    Ok(named)
}
