//! Motions from files of every kind.

use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use ga_anim::clip::compressed;
use ga_anim::motion_file::{Format, MotionFile, Options};
use ga_anim::recording::Recording;

use crate::frame::Warning;
use crate::motion_file;

/// A motion in a file, and how to read it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct MotionArguments {
    /// The motion.
    #[arg(value_name = "MOTION")]
    pub(super) motion: PathBuf,
    /// The length of one unit of the motion in metres [default: 1]. A compressed clip is in metres.
    #[arg(long, value_name = "N")]
    pub(super) metres_per_unit: Option<f64>,
    /// The number of the animation in a glTF file, from 0 [default: 0].
    #[arg(long, value_name = "N")]
    pub(super) animation: Option<usize>,
    /// Frames per second at which a glTF animation is recorded; by default those of its keys.
    #[arg(long, value_name = "HZ")]
    pub(super) rate: Option<f64>,
}

impl MotionArguments {
    /// The file as messages name it.
    pub(super) fn file(&self) -> String {
        self.motion.display().to_string()
    }

    pub(super) fn format(&self) -> Result<Format> {
        Ok(Format::of_path(&self.motion)?)
    }

    /// Reads the file, and adds what is unusual about it to the warnings. Fails where an option is
    /// given that this kind of file does not have.
    pub(super) fn read(&self, warnings: &mut Vec<Warning>) -> Result<MotionFile> {
        let format = self.format()?;
        let (unit, is_gltf) = (self.metres_per_unit, format == Format::Gltf);
        for (option, is_given, applies) in [
            ("--metres-per-unit", unit.is_some(), format != Format::Clip),
            ("--animation", self.animation.is_some(), is_gltf),
            ("--rate", self.rate.is_some(), is_gltf),
        ] {
            ensure!(
                applies || !is_given,
                "{option} does not apply to {}",
                self.file()
            );
        }
        let options = Options {
            metres_per_unit: checked_unit("--metres-per-unit", unit)?,
            animation: self.animation.unwrap_or(0),
            rate: self.rate,
            ..Options::default()
        };
        motion_file::read_any(&self.motion, options, warnings)
    }

    /// The recording in the file, and the bounds within which it may be compressed.
    pub(super) fn recording(
        &self,
        warnings: &mut Vec<Warning>,
    ) -> Result<(Recording, compressed::Options)> {
        let motion = self.read(warnings)?;
        let recording = motion.recording().with_context(|| self.file())?;
        Ok((recording, motion.compression()))
    }
}

/// The length of one unit in metres, 1 where it is not given.
pub(super) fn checked_unit(option: &str, metres: Option<f64>) -> Result<f64> {
    let metres = metres.unwrap_or(1.0);
    ensure!(
        metres > 0.0 && metres.is_finite(),
        "{option} {metres}: the length of a unit must be greater than 0 and finite"
    );
    Ok(metres)
}
