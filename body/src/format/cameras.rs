//! Which camera of a file belongs to which view.

use ga_camera::Camera;
use ga_camera::format::NamedCamera;

use super::{JointViews, JointsError};

impl JointViews {
    /// The camera of each view: that of the picture with its name, with or without the ending, or
    /// where no view has the name of a picture, that in its place.
    ///
    /// # Errors
    /// [`JointsError::CameraCount`], [`JointsError::NoPicture`], [`JointsError::SamePicture`], and
    /// [`JointsError::Camera`] for a camera that has skew or no pose.
    pub fn match_cameras(&self, cameras: &[NamedCamera]) -> Result<Vec<Camera>, JointsError> {
        let views = self.views();
        let named = views.iter().map(|view| only_named(cameras, &view.name));
        let named: Vec<Option<usize>> = named.collect();
        let is_named = named.iter().any(Option::is_some);
        if !is_named && views.len() != cameras.len() {
            return Err(JointsError::CameraCount {
                views: views.len(),
                cameras: cameras.len(),
            });
        }
        let mut matched = Vec::with_capacity(views.len());
        for (index, (view, camera)) in views.iter().zip(&named).enumerate() {
            let missing = || JointsError::NoPicture {
                view: view.name.clone(),
            };
            let camera = match is_named {
                true => camera.ok_or_else(missing)?,
                false => index,
            };
            let before = named[..index].iter();
            if let Some(other) = before.clone().position(|other| *other == Some(camera)) {
                return Err(JointsError::SamePicture {
                    views: [&views[other].name, &view.name].map(Clone::clone),
                });
            }
            matched.push(cameras[camera].camera()?);
        }
        Ok(matched)
    }
}

/// The one camera whose picture has this name.
fn only_named(cameras: &[NamedCamera], name: &str) -> Option<usize> {
    let mut found = (0..cameras.len()).filter(|&index| cameras[index].is_named(name));
    match (found.next(), found.next()) {
        (Some(index), None) => Some(index),
        _ => None,
    }
}
