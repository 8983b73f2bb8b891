//! Compressed clips as output: the bounds that they keep, and what is said about them.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::{Context as _, Result, ensure};
use ga_anim::clip::compressed::{self, JointBound, Options};
use ga_anim::recording::{RecordedJoint, Recording};
use serde::Serialize;

use super::info::Size;
use crate::format::Format;
use crate::frame::{self, Context, Progress, Warning};
use crate::output;
use crate::shell::quoted;

/// Where a clip is written, and within which bounds.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct TargetArguments {
    /// The greatest error of a joint by compression; by default that of the first motion where
    /// it is a clip, otherwise 0.0001.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    tolerance: Option<f64>,
    /// The distance from a joint within which points are kept within the tolerance; by default that
    /// of the first motion where it is a clip, otherwise 0.03.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    shell: Option<f64>,
    /// A joint with bounds of its own, such as `LeftHand=0.00005` or `LeftHand=0.00005,0.2` for
    /// another shell. May be given several times. Those of a first motion that is a clip are kept.
    #[arg(long = "joint", value_name = "NAME=METRES[,SHELL]")]
    joints: Vec<OwnBound>,
    /// The greatest deviation of scalar tracks, such as the weights of morph targets; by default
    /// that of the first motion where it is a clip, otherwise 0.0001.
    #[arg(long, value_name = "VALUE", allow_negative_numbers = true)]
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
        let report = write(recording, &options, file, &self.out, progress, || Ok(None))?;
        Ok(report.with_warnings(warnings))
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

/// The bound of one joint, as it is written on the command line.
#[derive(Clone, Debug)]
pub(super) struct OwnBound {
    name: String,
    tolerance: f64,
    shell: Option<f64>,
}

impl FromStr for OwnBound {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "must be a name, `=`, a tolerance and perhaps `,` and a shell".to_owned();
        let (name, numbers) = text.rsplit_once('=').ok_or_else(wrong)?;
        let (tolerance, shell) = match numbers.split_once(',') {
            Some((tolerance, shell)) => (tolerance, Some(shell)),
            None => (numbers, None),
        };
        let number = |text: &str| text.trim().parse().map_err(|_| wrong());
        Ok(Self {
            name: name.to_owned(),
            tolerance: number(tolerance)?,
            shell: shell.map(number).transpose()?,
        })
    }
}

/// Adds bounds of joints, which are known by name, to options.
pub(super) fn add_bounds(
    options: &mut Options,
    bounds: &[OwnBound],
    recording: &Recording,
    file: &str,
) -> Result<()> {
    for own in bounds {
        let named = |(_, joint): &(usize, &RecordedJoint)| joint.name == own.name;
        let joints = recording.joints().iter().enumerate().filter(named);
        let before = options.joints.len();
        let (tolerance, shell) = (own.tolerance, own.shell.unwrap_or(options.shell));
        options.joints.extend(joints.map(|(joint, _)| JointBound {
            joint,
            tolerance,
            shell,
        }));
        ensure!(
            options.joints.len() > before,
            "--joint {}: {file} has no such joint",
            own.name
        );
    }
    Ok(())
}

/// Compresses a recording and writes it. How many vertices a mesh has that it moves is asked for
/// before anything is written.
pub(super) fn write(
    recording: &Recording,
    options: &Options,
    file: String,
    out: &Path,
    progress: &Progress,
    mesh_vertices: impl FnOnce() -> Result<Option<u64>>,
) -> Result<Report> {
    progress.step("compressing");
    let clip = compressed::compress(recording, options, |done, steps| {
        progress.at(done as u64, steps as u64);
    })
    .with_context(|| file.clone())?;
    let measured = compressed::measure(recording, &clip)
        .context("the clip does not have the joints and frames of its recording")?;
    let mesh_vertices = mesh_vertices()?;
    output::write(out, clip.as_bytes())?;
    Ok(Report {
        file,
        out: out.display().to_string(),
        size: Size::new(&clip, mesh_vertices),
        max_error_metres: measured.error,
        max_error_joint: recording.joints()[measured.joint].name.clone(),
        max_error_frame: measured.frame,
        half_frame_error_metres: measured.half_frame_error,
        tracks: recording.tracks().len(),
        max_track_error: measured.track_error,
        warnings: Vec::new(),
    })
}

/// What was written, and how exact it is.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    file: String,
    out: String,
    #[serde(flatten)]
    size: Size,
    max_error_metres: f64,
    max_error_joint: String,
    max_error_frame: usize,
    half_frame_error_metres: f64,
    tracks: usize,
    max_track_error: f64,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Report {
    /// With errors against what the recording was made from, which is so far from it.
    pub(super) fn with_deviation(self, metres: f64) -> Self {
        Self {
            max_error_metres: self.max_error_metres + metres,
            half_frame_error_metres: self.half_frame_error_metres + metres,
            ..self
        }
    }

    /// With what is unusual about the motions.
    pub(super) fn with_warnings(self, warnings: Vec<Warning>) -> Self {
        Self { warnings, ..self }
    }
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
            file, out, size, ..
        } = self;
        let mut lines = format!(
            "{file}: {} frames of {} joints, {} numbers a frame change\n{out}: {}",
            size.frames,
            size.joints,
            size.channels,
            size.lines(),
        );
        lines += &format!(
            "error      {:.4} mm at most, of joint {} in frame {}; {:.4} mm half-way between frames\n",
            1e3 * self.max_error_metres,
            self.max_error_joint,
            self.max_error_frame,
            1e3 * self.half_frame_error_metres,
        );
        if self.tracks > 0 {
            lines += &format!(
                "tracks     {}, within {:.1e}\n",
                self.tracks, self.max_track_error
            );
        }
        lines
    }
}
