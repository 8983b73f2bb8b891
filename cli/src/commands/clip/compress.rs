//! `nullcone clip compress`: a recording in few bytes, with an error that stays within a bound.

use std::path::PathBuf;
use std::str::FromStr;

use anyhow::{Context, Result, ensure};
use ga_anim::clip::compressed::{self, JointBound, Settings};
use serde::Serialize;

use super::info::Size;
use super::input::{Kind, MotionArguments, vertices};
use crate::output;
use crate::progress::Progress;

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
    /// Print one JSON object instead of lines.
    #[arg(long)]
    json: bool,
}

/// The bound of one joint, as it is written on the command line.
#[derive(Clone, Debug)]
struct OwnBound {
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

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    let file = arguments.motion.file();
    let progress = Progress::new(100, quiet);
    progress.step("reading the motion");
    let recording = arguments.motion.recording(quiet)?;
    let mut settings = Settings {
        tolerance: arguments.tolerance,
        shell: arguments.shell,
        track_tolerance: arguments.track_tolerance,
        joints: Vec::new(),
    };
    for own in &arguments.joints {
        let named =
            |(_, joint): &(usize, &ga_anim::recording::RecordedJoint)| joint.name == own.name;
        let found: Vec<usize> = recording
            .joints()
            .iter()
            .enumerate()
            .filter(named)
            .map(|(j, _)| j)
            .collect();
        ensure!(
            !found.is_empty(),
            "--joint {}: {file} has no such joint",
            own.name
        );
        settings
            .joints
            .extend(found.into_iter().map(|joint| JointBound {
                joint,
                tolerance: own.tolerance,
                shell: own.shell.unwrap_or(arguments.shell),
            }));
    }
    progress.step("compressing");
    let clip = compressed::compress(&recording, &settings, |done, steps| {
        progress.at(done as u64, steps as u64);
    })
    .with_context(|| file.clone())?;
    let measured = compressed::measure(&recording, &clip)
        .context("the clip does not have the joints and frames of its recording")?;
    drop(progress);
    let mesh_vertices = match (arguments.mesh_vertices, arguments.motion.kind()?) {
        (None, Kind::Gltf) => Some(vertices(&arguments.motion.document()?)),
        (vertices, _) => vertices,
    };
    clip.write(&arguments.out)?;
    let report = Report {
        file,
        out: arguments.out.display().to_string(),
        size: Size::new(&clip, mesh_vertices),
        max_error_metres: measured.error,
        max_error_joint: recording.joints()[measured.joint].name.clone(),
        max_error_frame: measured.frame,
        half_frame_error_metres: measured.half_frame_error,
        tracks: recording.tracks().len(),
        max_track_error: measured.track_error,
    };
    if arguments.json {
        return output::print_json(&report);
    }
    if quiet {
        return Ok(());
    }
    output::print(&report.lines())
}

/// What was written, and how exact it is.
#[derive(Debug, Serialize)]
struct Report {
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
}

impl Report {
    fn lines(&self) -> String {
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
