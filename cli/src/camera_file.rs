//! The cameras that commands read from files, and cameras of pictures that are drawn.

use std::path::Path;

use anyhow::{Context, Error, Result, bail};
use ga_camera::format::{self, CameraFileError, NamedCamera, NamedRig};
use ga_render::View;

/// The least depth that is drawn where the file of a camera states none, in the unit of the model.
const NEAR: f64 = 1e-3;

/// Which cameras of a file are taken.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct ChosenPair {
    /// The left and the right camera where the file has more than two, or in another order, each by
    /// its name or by its number from 0: --view A --view B.
    #[arg(long = "view", value_name = "NAME", action = clap::ArgAction::Append)]
    names: Vec<String>,
}

/// The camera of a file that has one, or that of a name.
pub(crate) fn read_one(path: &Path, name: Option<&str>) -> Result<NamedCamera> {
    let file = format::read(path)?;
    let camera = file.one(name).map_err(|error| about(path, error))?;
    Ok(camera.clone())
}

/// The camera for one side of a pair: that of a file with one camera, or of two the one in its
/// place, 0 on the left and 1 on the right.
pub(crate) fn read_side(path: &Path, side: usize) -> Result<NamedCamera> {
    let file = format::read(path)?;
    let camera = file.side(side).map_err(|error| about(path, error))?;
    Ok(camera.clone())
}

/// An error of a file, which it names.
pub(crate) fn about(path: &Path, error: CameraFileError) -> Error {
    let chooses = matches!(error, CameraFileError::Several { .. });
    let error = Error::new(error);
    let error = match chooses {
        true => Error::msg(format!("{error} with --view NAME")),
        false => error,
    };
    error.context(path.display().to_string())
}

impl ChosenPair {
    /// Reads a rig.
    pub(crate) fn read(&self, path: &Path) -> Result<NamedRig> {
        let rig = format::read(path)?.named_rig(&self.names);
        rig.map_err(|error| about(path, error))
    }

    /// Reads the camera of one view, by its name where one is given.
    pub(crate) fn read_one(&self, path: &Path) -> Result<NamedCamera> {
        match self.names.as_slice() {
            [] => read_one(path, None),
            [name] => read_one(path, Some(name)),
            several => bail!(
                "--view is given {} times, and there is one view",
                several.len()
            ),
        }
    }

    /// Fails where cameras are chosen and none are read, or not from one file of a pair.
    pub(crate) fn refuse(&self, reason: &str) -> Result<()> {
        match self.names.first() {
            Some(name) => bail!("--view {name}: {reason}"),
            None => Ok(()),
        }
    }
}

/// What a camera of a file sees, as it is drawn.
pub(crate) fn to_view(camera: &NamedCamera) -> Result<View> {
    let (intrinsics, skew) = camera.intrinsics_and_skew();
    let pinhole = ga_camera::Camera {
        intrinsics,
        world_to_camera: camera.world_to_camera()?,
    };
    let view = View::pinhole(&pinhole, camera.near.unwrap_or(NEAR))?.with_skew(skew)?;
    Ok(match camera.far {
        Some(far) => view.with_far(far)?,
        None => view,
    })
}

/// The camera of a view that is drawn as a picture of a size.
pub(crate) fn of_view(name: &str, view: &View, size: [u32; 2]) -> Result<NamedCamera> {
    let camera = view
        .camera(size[0], size[1])
        .context("the camera of a picture")?;
    let mut named = NamedCamera::new(name, camera.intrinsics).with_skew(view.skew());
    named.size = Some(size.map(|side| side as usize));
    named.pose = Some(camera.world_to_camera);
    named.near = Some(view.near());
    named.far = Some(view.far()).filter(|far| far.is_finite());
    Ok(named)
}
