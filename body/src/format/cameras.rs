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
        let matched = match_named(&self.view_names(), cameras)?.into_iter();
        let cameras = matched.map(NamedCamera::camera);
        Ok(cameras.collect::<Result<_, _>>()?)
    }
}

/// The camera of each view of these names, as [`JointViews::match_cameras`] finds it, with what its
/// file says of it beside.
///
/// # Errors
/// [`JointsError::CameraCount`], [`JointsError::NoPicture`] and [`JointsError::SamePicture`].
pub fn match_named<'c, N: AsRef<str>>(
    views: &[N],
    cameras: &'c [NamedCamera],
) -> Result<Vec<&'c NamedCamera>, JointsError> {
    let named = views.iter().map(|view| only_named(cameras, view.as_ref()));
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
            view: view.as_ref().to_owned(),
        };
        let camera = match is_named {
            true => camera.ok_or_else(missing)?,
            false => index,
        };
        let mut before = named[..index].iter();
        if let Some(other) = before.position(|other| *other == Some(camera)) {
            return Err(JointsError::SamePicture {
                views: [&views[other], view].map(|view| view.as_ref().to_owned()),
            });
        }
        matched.push(&cameras[camera]);
    }
    Ok(matched)
}

/// The one camera whose picture has this name.
fn only_named(cameras: &[NamedCamera], name: &str) -> Option<usize> {
    let mut found = (0..cameras.len()).filter(|&index| cameras[index].is_named(name));
    match (found.next(), found.next()) {
        (Some(index), None) => Some(index),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use ga_camera::Intrinsics;
    use ga_runtime::cga3::Motor;

    use super::*;
    use crate::format::JointView;

    /// Cameras that differ in their focal lengths, of these pictures.
    fn cameras(pictures: &[&str]) -> Vec<NamedCamera> {
        let camera = |(index, picture): (usize, &&str)| {
            let focal_length = 100.0 * (1.0 + index as f64);
            let intrinsics = Intrinsics::new([focal_length; 2], [0.0; 2]).unwrap();
            let mut camera = NamedCamera::new("", intrinsics);
            camera.picture = Some((*picture).into());
            camera.pose = Some(Motor::default());
            camera
        };
        pictures.iter().enumerate().map(camera).collect()
    }

    fn matched(views: &[&str], pictures: &[&str]) -> Result<Vec<f64>, JointsError> {
        let view = |name: &&str| JointView {
            name: (*name).to_owned(),
            frames: vec![vec![None]],
        };
        let views = views.iter().map(view).collect();
        let joints = JointViews::new(vec!["Hips".to_owned()], None, views)?;
        let found = joints.match_cameras(&cameras(pictures))?;
        Ok(found
            .iter()
            .map(|camera| camera.intrinsics.focal()[0])
            .collect())
    }

    #[test]
    fn views_have_the_cameras_of_their_pictures_or_those_in_their_places() {
        let pictures = ["p/a.png", "p/b.png", "c.png"];
        assert_eq!(matched(&["c", "a.png"], &pictures).unwrap(), [300.0, 100.0]);
        assert_eq!(
            matched(&["x", "y", "z"], &pictures).unwrap(),
            [100.0, 200.0, 300.0]
        );
        let error = |views: &[&str]| matched(views, &pictures).unwrap_err();
        assert!(matches!(
            error(&["x", "y"]),
            JointsError::CameraCount {
                views: 2,
                cameras: 3
            }
        ));
        assert!(matches!(error(&["a", "y"]), JointsError::NoPicture { view } if view == "y"));
        assert!(matches!(
            error(&["a", "a.png"]),
            JointsError::SamePicture { .. }
        ));
        // A name of two pictures is that of none.
        let twice = matched(&["a", "b"], &["p/a.png", "q/a.png", "b.png"]).unwrap_err();
        assert!(matches!(twice, JointsError::NoPicture { view } if view == "a"));
    }
}
