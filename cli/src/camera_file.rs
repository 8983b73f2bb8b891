//! The cameras that commands read from files.

use std::path::Path;

use anyhow::{Error, Result, bail};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use ga_camera::LensModel;
use ga_camera::format::{self, CameraFile, CameraFileError, Format, NamedCamera, NamedRig};
use serde::{Serialize, Serializer};

use crate::frame::{Warning, warn};

/// The lens of a file that does not say which it is.
#[derive(Clone, Copy, Debug, Serialize, clap::Args)]
pub(crate) struct LensChoice {
    /// The lens of a file of cameras that has four coefficients and does not say whose they are.
    #[arg(long, value_name = "LENS", value_parser = lens())]
    #[serde(serialize_with = "named")]
    lens: Option<LensModel>,
}

fn named<S: Serializer>(
    lens: &Option<LensModel>,
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    lens.map(LensModel::name).serialize(serializer)
}

/// The kinds of lenses with four coefficients.
fn lens() -> impl TypedValueParser<Value = LensModel> {
    let names = [LensModel::RadialTangential, LensModel::Fisheye].map(LensModel::name);
    PossibleValuesParser::new(names)
        .map(|name| LensModel::named(&name).unwrap_or(LensModel::Pinhole))
}

/// Which cameras of a file are taken.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct ChosenPair {
    /// The left and the right camera where the file has more than two, or in another order, each by
    /// its name or by its number from 0: --view A --view B.
    #[arg(long = "view", value_name = "NAME", action = clap::ArgAction::Append)]
    names: Vec<String>,
    #[command(flatten)]
    lens: LensChoice,
}

impl LensChoice {
    /// The cameras of a file.
    pub(crate) fn read(self, path: &Path) -> Result<CameraFile> {
        Ok(self.read_with_format(path)?.1)
    }

    /// Fails where a lens is chosen and no file of cameras is read.
    pub(crate) fn refuse(self, reason: &str) -> Result<()> {
        match self.lens {
            Some(lens) => bail!("--lens {}: {reason}", lens.name()),
            None => Ok(()),
        }
    }

    /// The cameras of a file and its format.
    pub(crate) fn read_with_format(self, path: &Path) -> Result<(Format, CameraFile)> {
        let (format, file) = format::read_with_format(path)?;
        Ok((format, file.with_lens_model(self.lens)))
    }

    /// The camera of a file that has one, or that of a name.
    pub(crate) fn read_one(self, path: &Path, name: Option<&str>) -> Result<NamedCamera> {
        let file = self.read(path)?;
        let camera = file.one(name).map_err(|error| about(path, error))?;
        Ok(camera.clone())
    }

    /// The camera for one side of a pair: that of a file with one camera, or of two the one in its
    /// place, 0 on the left and 1 on the right.
    pub(crate) fn read_side(self, path: &Path, side: usize) -> Result<NamedCamera> {
        let file = self.read(path)?;
        let camera = file.side(side).map_err(|error| about(path, error))?;
        Ok(camera.clone())
    }
}

/// Warns of a file whose lengths are used and may not be in metres.
pub(crate) fn warn_of_unit(format: Format, path: &Path) {
    if !format.states_unit() {
        let text = format!(
            "{} states no unit of length: it is taken for metres",
            format.name()
        );
        warn(Warning::new("unclear_unit", text).in_file(path));
    }
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
        let (format, file) = self.lens.read_with_format(path)?;
        warn_of_unit(format, path);
        file.named_rig(&self.names)
            .map_err(|error| about(path, error))
    }

    /// Reads all cameras of a file.
    pub(crate) fn read_all(&self, path: &Path) -> Result<CameraFile> {
        let (format, file) = self.lens.read_with_format(path)?;
        warn_of_unit(format, path);
        Ok(file)
    }

    /// Reads the camera of one view, by its name where one is given.
    pub(crate) fn read_one(&self, path: &Path) -> Result<NamedCamera> {
        match self.names.as_slice() {
            [] => self.lens.read_one(path, None),
            [name] => self.lens.read_one(path, Some(name)),
            several => bail!(
                "--view is given {} times, and there is one view",
                several.len()
            ),
        }
    }

    /// Fails where cameras or a lens are chosen and no file of cameras is read.
    pub(crate) fn refuse(&self, reason: &str) -> Result<()> {
        self.refuse_names(reason)?;
        self.lens.refuse(reason)
    }

    /// Fails where cameras are chosen, and all of a file are read.
    pub(crate) fn refuse_names(&self, reason: &str) -> Result<()> {
        match self.names.first() {
            Some(name) => bail!("--view {name}: {reason}"),
            None => Ok(()),
        }
    }
}
