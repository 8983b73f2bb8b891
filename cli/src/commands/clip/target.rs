//! Compressed clips as output: the bounds that they keep, and what is said about them.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use ga_anim::clip::compressed::{self, Accuracy, NamedBound, Options, Size};
use ga_anim::recording::Recording;
use serde::Serialize;

use super::info::lines_of;
use super::input::MotionArguments;
use crate::format::Format;
use crate::frame::{self, Context, Progress, Warning};
use crate::output;
use crate::shell::quoted;

/// Where a clip is written, and within which bounds.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct TargetArguments {
    /// The greatest error of a joint by compression; by default that of the first motion where
    /// it is a clip, otherwise 0.0001.
    #[arg(long, value_name = "METRES")]
    tolerance: Option<f64>,
    /// The distance from a joint within which points are kept within the tolerance; by default that
    /// of the first motion where it is a clip, otherwise 0.03.
    #[arg(long, value_name = "METRES")]
    shell: Option<f64>,
    /// A joint with bounds of its own, such as `LeftHand=0.00005` or `LeftHand=0.00005,0.2` for
    /// another shell. May be given several times. Those of a first motion that is a clip are kept.
    #[arg(long = "joint", value_name = "NAME=METRES[,SHELL]")]
    joints: Vec<NamedBound>,
    /// The greatest deviation of scalar tracks, such as the weights of morph targets; by default
    /// that of the first motion where it is a clip, otherwise 0.0001.
    #[arg(long, value_name = "VALUE")]
    track_tolerance: Option<f64>,
    /// The clip to be written.
    #[arg(long, value_name = "OUT.clip")]
    out: PathBuf,
}

impl TargetArguments {
    /// Fails unless a clip is asked for that replaces no motion; to be called before anything takes
    /// long.
    pub(super) fn check<P: AsRef<Path>>(
        &self,
        motions: impl IntoIterator<Item = P>,
        context: &Context,
    ) -> Result<()> {
        check(motions, &self.out, context)
    }

    /// Compresses a recording and writes it. `file` is what it was made of, and `defaults` are the
    /// bounds where none are given.
    pub(super) fn write(
        &self,
        recording: &Recording,
        file: String,
        defaults: Options,
        progress: &Progress,
        warnings: Vec<Warning>,
    ) -> Result<Report> {
        let mut options = Options {
            tolerance: self.tolerance.unwrap_or(defaults.tolerance),
            shell: self.shell.unwrap_or(defaults.shell),
            track_tolerance: self.track_tolerance.unwrap_or(defaults.track_tolerance),
            joints: defaults.joints,
        };
        add_bounds(&mut options, &self.joints, recording, &file)?;
        let compression = Compression {
            recording,
            options,
            deviation: 0.0,
            mesh_vertices: None,
        };
        compression.write(file, &self.out, progress, warnings)
    }

    /// Reads a motion, and writes what becomes of it.
    pub(super) fn write_changed(
        &self,
        motion: &MotionArguments,
        context: &Context,
        change: impl FnOnce(Recording) -> Result<Recording>,
    ) -> Result<Report> {
        self.check([&motion.motion], context)?;
        let progress = context.progress(100);
        progress.step("reading the motion");
        let mut warnings = Vec::new();
        let (recording, defaults) = motion.recording(&mut warnings)?;
        let changed = change(recording)?;
        self.write(&changed, motion.file(), defaults, &progress, warnings)
    }
}

/// Fails unless a clip can be written to `out` that replaces none of the motions.
pub(super) fn check<P: AsRef<Path>>(
    motions: impl IntoIterator<Item = P>,
    out: &Path,
    context: &Context,
) -> Result<()> {
    context
        .files(motions)?
        .write("--out", out, &[Format::Clip])?;
    Ok(())
}

/// Adds bounds of joints, which are known by name, to options.
pub(super) fn add_bounds(
    options: &mut Options,
    bounds: &[NamedBound],
    recording: &Recording,
    file: &str,
) -> Result<()> {
    for bound in bounds {
        ensure!(
            options.bound_by_name(bound, recording.joints()),
            "--joint {}: {file} has no such joint",
            bound.name
        );
    }
    Ok(())
}

/// A recording that becomes a clip.
pub(super) struct Compression<'a> {
    pub(super) recording: &'a Recording,
    pub(super) options: Options,
    /// How far the recording is from what it was made of, in metres.
    pub(super) deviation: f64,
    pub(super) mesh_vertices: Option<u64>,
}

impl Compression<'_> {
    /// Compresses the recording, which was made of `file`, and writes it.
    pub(super) fn write(
        &self,
        file: String,
        out: &Path,
        progress: &Progress,
        warnings: Vec<Warning>,
    ) -> Result<Report> {
        progress.step("compressing");
        let recording = self.recording;
        let clip = compressed::compress(recording, &self.options, |done, steps| {
            progress.at(done as u64, steps as u64);
        })
        .with_context(|| file.clone())?;
        let accuracy = Accuracy::new(recording, &clip, self.deviation)
            .context("the clip does not have the joints and frames of its recording")?;
        output::write(out, clip.as_bytes())?;
        Ok(Report {
            file,
            out: out.display().to_string(),
            size: Size::new(&clip, self.mesh_vertices),
            accuracy,
            warnings,
        })
    }
}

/// What was written, and how exact it is.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    file: String,
    out: String,
    #[serde(flatten)]
    size: Size,
    #[serde(flatten)]
    accuracy: Accuracy,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn next(&self) -> Option<String> {
        let is_file = Format::Clip.fits(Path::new(&self.out));
        is_file.then(|| format!("nullcone clip info {}", quoted(&self.out)))
    }

    fn text(&self) -> String {
        let Self {
            file,
            out,
            size,
            accuracy,
            ..
        } = self;
        let mut lines = format!(
            "{file}: {} frames of {} joints, {} numbers a frame change\n{out}: {}",
            size.frames,
            size.joints,
            size.channels,
            lines_of(size),
        );
        lines += &format!(
            "error      {:.4} mm at most, of joint {} in frame {}; {:.4} mm half-way between frames\n",
            1e3 * accuracy.max_error_metres,
            accuracy.max_error_joint,
            accuracy.max_error_frame,
            1e3 * accuracy.half_frame_error_metres,
        );
        if accuracy.tracks > 0 {
            lines += &format!(
                "tracks     {}, within {:.1e}\n",
                accuracy.tracks, accuracy.max_track_error
            );
        }
        lines
    }
}
