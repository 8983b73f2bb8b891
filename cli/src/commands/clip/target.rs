//! Motions as output, in files of every kind, and what is said about them.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use ga_anim::MotionFileError;
use ga_anim::clip::compressed::{Accuracy, NamedBound, Options, Size};
use ga_anim::motion_file::{Contents, Format as MotionFormat, MotionFile, WriteOptions, Written};
use ga_anim::recording::Recording;
use ga_mesh::gltf;
use serde::Serialize;

use super::info::lines_of;
use super::input::{Input, MotionArguments, short};
use super::phases::Phases;
use crate::format::Format;
use crate::frame::{self, Context, Progress, Warning};
use crate::motion_file;
use crate::output::Staging;
use crate::shell::quoted;

/// The formats of motions.
pub(super) const FORMATS: [Format; 4] = [Format::Clip, Format::Bvh, Format::Glb, Format::Gltf];

/// Where a motion is written, and within which bounds it is compressed.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct TargetArguments {
    /// The greatest error of a joint by compression, for .clip; by default that of the first motion
    /// where it is a clip, otherwise 0.0001.
    #[arg(long, value_name = "METRES")]
    tolerance: Option<f64>,
    /// The distance from a joint within which points are kept within the tolerance, for .clip; by
    /// default that of the first motion where it is a clip, otherwise 0.03.
    #[arg(long, value_name = "METRES")]
    shell: Option<f64>,
    /// A joint with bounds of its own, for .clip, such as `LeftHand=0.00005` or
    /// `LeftHand=0.00005,0.2` for another shell. May be given several times. Those of a first
    /// motion that is a clip are kept.
    #[arg(long = "joint", value_name = "NAME=METRES[,SHELL]")]
    joints: Vec<NamedBound>,
    /// The greatest deviation of scalar tracks, such as the weights of morph targets, for .clip; by
    /// default that of the first motion where it is a clip, otherwise 0.0001.
    #[arg(long, value_name = "VALUE")]
    track_tolerance: Option<f64>,
    /// The length of one unit of a .bvh that is written, in metres [default: that of a first motion
    /// that is BVH, otherwise 1].
    #[arg(long, value_name = "METRES")]
    out_metres_per_unit: Option<f64>,
    /// The motion to be written, in the format that its name says.
    ///
    /// A .glb or .gltf keeps the nodes, meshes, skins and other animations of a first motion that
    /// is glTF; a .bvh the unit, channels and End Sites of one that is BVH. What a format does not
    /// hold is listed in warnings.
    #[arg(long, value_name = "OUT.clip|OUT.bvh|OUT.glb")]
    out: PathBuf,
}

/// A motion that becomes a file.
pub(super) struct Output<'a> {
    pub(super) recording: &'a Recording,
    /// What it was made of.
    pub(super) inputs: Vec<Input>,
    /// The first file that it was made of, and where that is.
    pub(super) like: (&'a Path, &'a MotionFile),
    pub(super) warnings: Vec<Warning>,
}

impl TargetArguments {
    /// Fails unless a motion is asked for that replaces none of those that are read; to be called
    /// before anything takes long.
    pub(super) fn check<P: AsRef<Path>>(
        &self,
        motions: impl IntoIterator<Item = P>,
        context: &Context,
    ) -> Result<Format> {
        let mut files = context.files(motions)?;
        let format = files.write("--out", &self.out, &FORMATS)?;
        let (is_clip, is_bvh) = (format == Format::Clip, format == Format::Bvh);
        for (option, is_given, applies) in [
            ("--tolerance", self.tolerance.is_some(), is_clip),
            ("--shell", self.shell.is_some(), is_clip),
            ("--joint", !self.joints.is_empty(), is_clip),
            ("--track-tolerance", self.track_tolerance.is_some(), is_clip),
            (
                "--out-metres-per-unit",
                self.out_metres_per_unit.is_some(),
                is_bvh,
            ),
        ] {
            ensure!(
                applies || !is_given,
                "{option} does not apply to --out {}",
                self.out.display()
            );
        }
        motion_file::checked_unit("--out-metres-per-unit", self.out_metres_per_unit)?;
        Ok(format)
    }

    /// Writes a motion.
    pub(super) fn write(
        &self,
        format: Format,
        output: Output,
        outputs: &Staging,
        progress: &Progress,
    ) -> Result<Report> {
        let (_, like) = output.like;
        let defaults = like.compression();
        let mut compression = Options {
            tolerance: self.tolerance.unwrap_or(defaults.tolerance),
            shell: self.shell.unwrap_or(defaults.shell),
            track_tolerance: self.track_tolerance.unwrap_or(defaults.track_tolerance),
            joints: defaults.joints,
        };
        let file = output.file();
        add_bounds(&mut compression, &self.joints, output.recording, &file)?;
        let options = WriteOptions {
            name: &ga_files::stem(&self.out),
            like: Some(like),
            metres_per_unit: self.out_metres_per_unit,
            compression,
            ..WriteOptions::default()
        };
        let exact = (0.0, None);
        write(
            &self.out, format, output, &options, exact, outputs, progress,
        )
    }

    /// Reads a motion, and writes what becomes of it.
    pub(super) fn write_changed(
        &self,
        motion: &MotionArguments,
        context: &Context,
        change: impl FnOnce(&MotionFile, &Recording) -> Result<Recording>,
    ) -> Result<Report> {
        let format = self.check([&motion.motion], context)?;
        let progress = context.progress(100);
        progress.step("reading the motion");
        let mut warnings = Vec::new();
        let (file, recording) = motion.recording(&mut warnings)?;
        let output = Output {
            recording: &change(&file, &recording)?,
            inputs: vec![Input::new(motion.file(), &file, &recording)],
            like: (&motion.motion, &file),
            warnings,
        };
        self.write(format, output, context.outputs(), &progress)
    }
}

impl Output<'_> {
    /// What it was made of, as messages name it.
    fn file(&self) -> String {
        let files = self.inputs.iter().map(|input| input.file.as_str());
        files.collect::<Vec<_>>().join(", ")
    }
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

/// Writes a motion. Beside it are how far the recording is from what it was made of, in metres, and
/// how many vertices the mesh has that it moves.
pub(super) fn write(
    out: &Path,
    format: Format,
    output: Output,
    options: &WriteOptions,
    (deviation, mesh_vertices): (f64, Option<u64>),
    outputs: &Staging,
    progress: &Progress,
) -> Result<Report> {
    let file = output.file();
    let Output {
        recording,
        inputs,
        like: (like_path, like),
        mut warnings,
    } = output;
    let written = written(recording, format, options, progress);
    let written = written.with_context(|| match like.likely_unit() {
        Some(unit) => format!("{file}, with a unit of {} m", short(unit.metres)),
        None => file.clone(),
    })?;
    let mut compressed = None;
    if let Contents::Clip(clip) = &written.contents {
        let accuracy = Accuracy::new(recording, clip, deviation)
            .context("the clip does not have the joints and frames of its recording")?;
        let size = Size::new(clip, mesh_vertices);
        compressed = Some(Compressed { size, accuracy });
    }
    let out_metres_per_unit = written.metres_per_unit;
    let bytes = put(out, format, written, like_path, outputs, &mut warnings)?;
    let plain = compressed.is_none().then(|| Plain {
        bytes,
        frames: recording.frame_count(),
        joints: recording.joints().len(),
        frame_time_seconds: recording.frame_time(),
        duration_seconds: recording.duration(),
        out_metres_per_unit,
    });
    Ok(Report {
        file,
        out: out.display().to_string(),
        metres_per_unit: inputs.first().map_or(1.0, |input| input.metres_per_unit),
        inputs,
        compressed,
        plain,
        phases: None,
        warnings,
    })
}

/// A motion in a format.
pub(super) fn written(
    recording: &Recording,
    format: Format,
    options: &WriteOptions,
    progress: &Progress,
) -> Result<Written, MotionFileError> {
    let format = match format {
        Format::Bvh => MotionFormat::Bvh,
        Format::Glb | Format::Gltf => MotionFormat::Gltf,
        _ => MotionFormat::Clip,
    };
    progress.step(match format {
        MotionFormat::Clip => "compressing",
        _ => "writing",
    });
    Written::new(recording, format, options, |done, steps| {
        progress.at(done as u64, steps as u64);
    })
}

/// Puts a motion, with what it has from the file that it is like, into a file, and adds what is not
/// there to the warnings. The result is how many bytes it is, where it is one file.
pub(super) fn put(
    out: &Path,
    format: Format,
    mut written: Written,
    like: &Path,
    outputs: &Staging,
    warnings: &mut Vec<Warning>,
) -> Result<Option<usize>> {
    let shown = || format!("{} cannot be written", out.display());
    let losses = written.losses.iter();
    warnings.extend(losses.map(|loss| motion_file::lost(loss, out)));
    if let Contents::Gltf(document) = &mut written.contents {
        **document = document.relocated(like, out).with_context(shown)?;
        if format == Format::Gltf {
            let files = gltf::path_files(out, document).with_context(shown)?;
            // What refers to the others takes its name after them.
            for (name, bytes) in files.into_iter().rev() {
                outputs.write(out.with_file_name(name), bytes)?;
            }
            return Ok(None);
        }
    }
    let bytes = written.encode().with_context(shown)?;
    outputs.write(out, &bytes)?;
    Ok(Some(bytes.len()))
}

/// What was written, and how exact it is.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    file: String,
    out: String,
    metres_per_unit: f64,
    inputs: Vec<Input>,
    #[serde(flatten)]
    compressed: Option<Compressed>,
    #[serde(flatten)]
    plain: Option<Plain>,
    #[serde(flatten)]
    phases: Option<Phases>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

/// A clip that was written.
#[derive(Debug, Serialize)]
struct Compressed {
    #[serde(flatten)]
    size: Size,
    #[serde(flatten)]
    accuracy: Accuracy,
}

/// A motion of another format that was written.
#[derive(Debug, Serialize)]
struct Plain {
    /// Of one file.
    #[serde(skip_serializing_if = "Option::is_none")]
    bytes: Option<usize>,
    frames: usize,
    joints: usize,
    frame_time_seconds: f64,
    duration_seconds: f64,
    out_metres_per_unit: f64,
}

impl Report {
    /// The same of motions that were brought in step.
    pub(super) fn in_step(self, phases: Option<Phases>) -> Self {
        Self { phases, ..self }
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn next(&self) -> Option<String> {
        let is_file = Format::of(Path::new(&self.out), &FORMATS).is_some();
        is_file.then(|| format!("nullcone clip info {}", quoted(&self.out)))
    }

    fn text(&self) -> String {
        let mut lines: String = self.inputs.iter().map(Input::line).collect();
        let out = &self.out;
        if let Some(plain) = &self.plain {
            lines += &format!(
                "{out}: {} frames of {} joints, {:.2} s at {:.2} Hz\n",
                plain.frames,
                plain.joints,
                plain.duration_seconds,
                1.0 / plain.frame_time_seconds
            );
        }
        if let Some(Compressed { size, accuracy }) = &self.compressed {
            lines += &format!(
                "{out}: {} frames of {} joints, {} numbers a frame change; {}",
                size.frames,
                size.joints,
                size.channels,
                lines_of(size)
            );
            lines += &format!(
                "error      {:.4} mm at most, of joint {} in frame {}; {:.4} mm half-way between \
                 frames\n",
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
        }
        lines
    }
}
