//! `nullcone clip compress`: a recording in few bytes, with an error that stays within a bound.

use std::path::PathBuf;

use anyhow::{Result, ensure};
use ga_anim::clip::compressed::Options;
use ga_anim::recording::Recording;

use super::input::{Kind, MotionArguments, vertices};
use super::target::{self, OwnBound, Report};
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
///   nullcone clip compress 01_01.bvh --metres-per-unit 0.056444 --tolerance 0.0001 --out walk.clip
///
/// prints
///
///   01_01.bvh: 2752 frames of 31 joints, 64 numbers a frame change
///   walk.clip: 128699 bytes instead of 3412480, 26.5 : 1; 46.8 bytes a frame
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
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    tolerance: f64,
    /// The distance from a joint within which points are kept within the tolerance.
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 0.03,
        allow_negative_numbers = true
    )]
    shell: f64,
    /// A joint with bounds of its own, such as `LeftHand=0.00005` or `LeftHand=0.00005,0.2` for
    /// another shell. May be given several times.
    #[arg(long = "joint", value_name = "NAME=METRES[,SHELL]")]
    joints: Vec<OwnBound>,
    /// The greatest deviation of scalar tracks, such as the weights of morph targets.
    #[arg(
        long,
        value_name = "VALUE",
        default_value_t = 1e-4,
        allow_negative_numbers = true
    )]
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
        let (motion, file, out) = (&self.motion, self.motion.file(), &self.out);
        target::check([motion.path()], out, context)?;
        let progress = context.progress(100);
        progress.step("reading the motion");
        let mut warnings = Vec::new();
        let recording = motion.recording(&mut warnings)?;
        let mut options = Options {
            tolerance: self.tolerance,
            shell: self.shell,
            track_tolerance: self.track_tolerance,
            joints: Vec::new(),
        };
        target::add_bounds(&mut options, &self.joints, &recording, &file)?;
        let deviation = leave_for_deviation(&mut options, motion, &recording)?;
        let mesh_vertices = || -> Result<Option<u64>> {
            match (self.mesh_vertices, motion.kind()?) {
                (None, Kind::Gltf) => Ok(Some(vertices(&motion.document()?))),
                (vertices, _) => Ok(vertices),
            }
        };
        let report = target::write(&recording, &options, file, out, &progress, mesh_vertices)?;
        Ok(report.with_deviation(deviation).with_warnings(warnings))
    }
}

/// How far the recording is from a glTF document, by which the tolerances become smaller, so that
/// they hold against the document.
fn leave_for_deviation(
    options: &mut Options,
    motion: &MotionArguments,
    recording: &Recording,
) -> Result<f64> {
    // Far below single precision.
    const ROUNDING: f64 = 1e-5;
    let shells = options.joints.iter().map(|bound| bound.shell);
    let shell = shells.fold(options.shell, f64::max);
    let deviation = motion.deviation(recording, shell)?;
    let own = options.joints.iter_mut().map(|bound| &mut bound.tolerance);
    for tolerance in own.chain([&mut options.tolerance]) {
        // What is not a tolerance is refused later.
        if *tolerance > 0.0 && deviation > ROUNDING * *tolerance {
            ensure!(
                deviation < *tolerance,
                "{}: shear in matrices of nodes moves points by {deviation} m, which is not within \
                 {tolerance} m",
                motion.file()
            );
            *tolerance -= deviation;
        }
    }
    Ok(deviation)
}
