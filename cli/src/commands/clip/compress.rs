//! `nullcone clip compress`: a recording in few bytes, with an error that stays within a bound.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use ga_anim::clip::compressed::{NamedBound, Options};
use ga_anim::motion_file::{Format, WriteOptions};

use super::input::{Input, MotionArguments};
use super::target::{Output, Report, add_bounds, write};
use crate::format;
use crate::frame::{Command, Context};

/// Compress a recording so that a bound on its error holds on every frame.
///
/// The error of a joint is that of all points within a distance of it, the shell, which move with
/// it: ‖Δt‖ + shell · ‖ΔR‖ in model space, for the difference of the joint's true and decoded
/// frames. max_error_metres is the greatest one of all joints and frames. It is measured on the
/// written bytes: transforms relative to the parents, decoded in single precision and composed to
/// model space in double precision, as `nullcone clip sample` does. half_frame_error_metres is the
/// greatest one half-way between frames, against rotations by slerp and linear translations between
/// those of the recording.
///
/// For instance
///
///   nullcone clip compress 01_01.bvh --tolerance 0.0001 --out walk.clip
///
/// prints
///
///   01_01.bvh: 2752 frames of 31 joints, 22.92 s; a unit is 0.0564444 m
///   walk.clip: 2752 frames of 31 joints, 64 numbers a frame change; 128699 bytes instead of …
///
/// and then the speed of decoding and the errors. With --json it prints {"file": …, "out": …,
/// "bytes": 128699, "raw_bytes": 3412480, "ratio": …, "frames": 2752, "joints": 31, …,
/// "max_error_metres": …, "half_frame_error_metres": …, …}. raw_bytes are 40 for each joint and
/// frame, and bytes are all of the file but the joints' names.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    motion: MotionArguments,
    /// The greatest error of a joint.
    #[arg(long, value_name = "METRES")]
    tolerance: f64,
    /// The distance from a joint within which points are kept within the tolerance.
    #[arg(long, value_name = "METRES", default_value_t = 0.03)]
    shell: f64,
    /// A joint with bounds of its own, such as `LeftHand=0.00005` or `LeftHand=0.00005,0.2` for
    /// another shell. May be given several times.
    #[arg(long = "joint", value_name = "NAME=METRES[,SHELL]")]
    joints: Vec<NamedBound>,
    /// The greatest deviation of scalar tracks, such as the weights of morph targets.
    #[arg(long, value_name = "VALUE", default_value_t = 1e-4)]
    track_tolerance: f64,
    /// How many vertices the mesh has that the clip moves, to compare with frames stored as meshes;
    /// by default those of a glTF file.
    #[arg(long, value_name = "N")]
    mesh_vertices: Option<u64>,
    /// The clip to be written.
    #[arg(long, value_name = "FILE.clip")]
    out: PathBuf,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let (motion, file) = (&self.motion, self.motion.file());
        let mut files = context.files([&motion.motion])?;
        let format = files.write("--out", &self.out, &[format::Format::Clip])?;
        let progress = context.progress(100);
        progress.step("reading the motion");
        ensure!(
            motion.format()? != Format::Clip,
            "{file}: the motion is already compressed"
        );
        let mut warnings = Vec::new();
        let (read, recording) = motion.recording(&mut warnings)?;
        let mut compression = Options {
            tolerance: self.tolerance,
            shell: self.shell,
            track_tolerance: self.track_tolerance,
            joints: Vec::new(),
        };
        add_bounds(&mut compression, &self.joints, &recording, &file)?;
        let deviation = read.deviation(&recording, compression.greatest_shell());
        let deviation = deviation.with_context(|| file.clone())?;
        let left = compression.leave_for(deviation);
        left.with_context(|| file.clone())?;
        let output = Output {
            recording: &recording,
            inputs: vec![Input::new(file, &read, &recording)],
            like: (&motion.motion, &read),
            warnings,
        };
        // What is beside the motion is not asked for.
        let options = WriteOptions {
            compression,
            ..WriteOptions::default()
        };
        let vertices = self.mesh_vertices.or(read.vertex_count());
        let beside = (deviation, vertices);
        let outputs = context.outputs();
        write(
            &self.out, format, output, &options, beside, outputs, &progress,
        )
    }
}
