//! Motions from files of every kind.

use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use ga_anim::motion_file::{Format, MotionFile, Options};
use ga_anim::recording::Recording;
use serde::Serialize;

use crate::frame::Warning;
use crate::motion_file;

/// The option that gives the length of a unit.
const UNIT: &str = "--metres-per-unit";

/// A motion in a file, and how to read it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct MotionArguments {
    /// The motion: BVH, glTF or a compressed clip.
    #[arg(value_name = "MOTION")]
    pub(super) motion: PathBuf,
    /// The length of one unit of the motion in metres [default: of BVH found from the length of the
    /// legs, of glTF 1]. A compressed clip is in metres.
    #[arg(long, value_name = "METRES")]
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
            (UNIT, unit.is_some(), format != Format::Clip),
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
            metres_per_unit: motion_file::checked_unit(UNIT, unit)?,
            animation: self.animation.unwrap_or(0),
            rate: self.rate,
            ..Options::default()
        };
        motion_file::read_any(&self.motion, options, UNIT, warnings)
    }

    /// Reads the file as [`read`](Self::read), frame by frame.
    pub(super) fn recording(&self, warnings: &mut Vec<Warning>) -> Result<(MotionFile, Recording)> {
        let motion = self.read(warnings)?;
        let recording = motion.recording().with_context(|| self.file())?;
        Ok((motion, recording))
    }
}

/// A motion that was read, as reports describe it.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Input {
    pub(super) file: String,
    frames: usize,
    joints: usize,
    frame_time_seconds: f64,
    duration_seconds: f64,
    pub(super) metres_per_unit: f64,
}

impl Input {
    pub(super) fn new(file: String, motion: &MotionFile, recording: &Recording) -> Self {
        Self {
            file,
            frames: recording.frame_count(),
            joints: recording.joints().len(),
            frame_time_seconds: recording.frame_time(),
            duration_seconds: recording.duration(),
            metres_per_unit: motion.metres_per_unit(),
        }
    }

    /// The motion for people, as a line.
    pub(super) fn line(&self) -> String {
        format!(
            "{}: {} frames of {} joints, {:.2} s; a unit is {} m\n",
            self.file,
            self.frames,
            self.joints,
            self.duration_seconds,
            short(self.metres_per_unit)
        )
    }
}

/// A length with six digits, and no zeros behind them.
pub(super) fn short(metres: f64) -> String {
    let digits = (5.0 - metres.log10().floor()).clamp(0.0, 12.0) as usize;
    let text = format!("{metres:.digits$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
