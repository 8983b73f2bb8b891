//! The cameras that commands read from files.

use std::path::Path;

use anyhow::{Error, Result, bail};
use ga_camera::format::{self, CameraFileError, NamedCamera, NamedRig};

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
