//! The cameras that commands read from files.

use std::path::Path;

use anyhow::{Error, Result, bail, ensure};
use ga_camera::format::{self, CameraFile, CameraFileError, NamedCamera, Rectified};
use ga_camera::rig::StereoRig;

/// Which cameras of a file are taken.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct ChosenPair {
    /// The left and the right camera where the file has more than two, or in another order, each by
    /// its name or by its number from 0: --view A --view B.
    #[arg(long = "view", value_name = "NAME", action = clap::ArgAction::Append)]
    names: Vec<String>,
}

/// A rig of a file.
pub(crate) struct Rig {
    /// The cameras, in the frame of the left one.
    pub(crate) rig: StereoRig,
    /// What the file says of rectified pictures, where the views are such.
    pub(crate) rectified: Option<Rectified>,
    sizes: [Option<[usize; 2]>; 2],
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
    let camera = match file.cameras.as_slice() {
        [left, right] => Ok([left, right][side.min(1)]),
        _ => file.one(None),
    };
    Ok(camera.map_err(|error| about(path, error))?.clone())
}

/// Fails where a picture does not have the size that a file of cameras is for.
pub(crate) fn check_size(
    expected: Option<[usize; 2]>,
    found: [usize; 2],
    picture: &Path,
    cameras: &Path,
) -> Result<()> {
    let Some(expected) = expected else {
        return Ok(());
    };
    ensure!(
        found == expected,
        "{} has {} × {} pixels, and {} is for {} × {}",
        picture.display(),
        found[0],
        found[1],
        cameras.display(),
        expected[0],
        expected[1]
    );
    Ok(())
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
    pub(crate) fn read(&self, path: &Path) -> Result<Rig> {
        let file = format::read(path)?;
        self.rig(&file).map_err(|error| about(path, error))
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

    fn rig(&self, file: &CameraFile) -> Result<Rig, CameraFileError> {
        let pair = file.pair(&self.names)?;
        let rig = file.rig(&self.names)?;
        let as_listed = pair.into_iter().eq(file.cameras.iter());
        Ok(Rig {
            rig,
            rectified: file.rectified.filter(|_| as_listed),
            sizes: pair.map(|camera| camera.size),
        })
    }
}

impl Rig {
    /// Fails where views do not have the sizes that the file states.
    pub(crate) fn check_sizes(
        &self,
        found: [usize; 2],
        views: [&Path; 2],
        path: &Path,
    ) -> Result<()> {
        let mut sides = self.sizes.into_iter().zip(views);
        sides.try_for_each(|(size, view)| check_size(size, found, view, path))
    }
}
