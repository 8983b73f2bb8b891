//! `nullcone clip info`: what a motion consists of.

use anyhow::{Context as _, Result};
use ga_anim::clip::compressed::{Size, Summary};
use ga_anim::motion_file::{Contents, MotionFile};
use ga_anim::recording::Recording;
use serde::Serialize;

use super::input::{MotionArguments, short};
use crate::frame::{self, Command, Context, Warning};

/// Say what a motion consists of, and how small and fast a compressed clip is.
///
/// For instance
///
///   nullcone clip info walk.clip --mesh-vertices 13380 --json
///
/// prints {"metres_per_unit": 1.0, "bytes": …, "raw_bytes": …, "ratio": …, "frames": 2752,
/// "joints": 31, …}. raw_bytes are 40 for each joint and frame: a rotation, a translation and a
/// factor along each axis in single precision. bytes are all of the file but the joints' names.
/// With --mesh-vertices, a frame is compared with the positions of that many vertices in single
/// precision. decoded_frames_per_second is measured on one thread and differs from run to run. Of
/// BVH and glTF, frames, joints, times, tracks and the names of the joints are printed.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    motion: MotionArguments,
    /// How many vertices the mesh has that a clip moves, to compare with frames stored as meshes.
    #[arg(long, value_name = "N")]
    mesh_vertices: Option<u64>,
}

impl Command for Arguments {
    type Report = Info;

    fn run(&self, context: &Context) -> Result<Info> {
        context.files([&self.motion.motion])?;
        let mut warnings = Vec::new();
        let motion = self.motion.read(&mut warnings)?;
        let (clip, frames) = match motion.contents() {
            Contents::Clip(clip) => (Some(Summary::new(clip, self.mesh_vertices)), None),
            _ => {
                let recording = motion.recording();
                let recording = recording.with_context(|| self.motion.file())?;
                (None, Some(Frames::new(&motion, &recording)))
            }
        };
        Ok(Info {
            file: self.motion.file(),
            metres_per_unit: motion.metres_per_unit(),
            clip,
            frames,
            warnings,
        })
    }
}

/// What is said about a motion.
#[derive(Debug, Serialize)]
pub(crate) struct Info {
    file: String,
    metres_per_unit: f64,
    #[serde(flatten)]
    clip: Option<Summary>,
    #[serde(flatten)]
    frames: Option<Frames>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

/// A motion that is not compressed.
#[derive(Debug, Serialize)]
struct Frames {
    frames: usize,
    joints: usize,
    frame_time_seconds: f64,
    duration_seconds: f64,
    /// Of glTF.
    #[serde(skip_serializing_if = "Option::is_none")]
    animations: Option<usize>,
    joint_names: Vec<String>,
    joint_parents: Vec<Option<usize>>,
    tracks: Vec<String>,
}

impl Frames {
    fn new(motion: &MotionFile, recording: &Recording) -> Self {
        let joints = recording.joints().iter();
        let tracks = recording.tracks().iter();
        Self {
            frames: recording.frame_count(),
            joints: recording.joints().len(),
            frame_time_seconds: recording.frame_time(),
            duration_seconds: recording.duration(),
            animations: match motion.contents() {
                Contents::Gltf(document) => Some(document.animations.len()),
                _ => None,
            },
            joint_names: joints.map(|joint| joint.name.clone()).collect(),
            joint_parents: recording.parents().to_vec(),
            tracks: tracks.map(|track| track.name.clone()).collect(),
        }
    }
}

/// The size of a clip for people, as the rest of a line and lines below.
pub(super) fn lines_of(size: &Size) -> String {
    let mut lines = format!(
        "{} bytes instead of {}, {:.1} : 1; {:.1} bytes a frame\n",
        size.bytes, size.raw_bytes, size.ratio, size.bytes_per_frame
    );
    if let Some(mesh) = &size.mesh {
        lines += &format!(
            "mesh       {} vertices are {} bytes a frame, {:.0} times as many\n",
            mesh.mesh_vertices, mesh.mesh_bytes_per_frame, mesh.mesh_ratio
        );
    }
    let rate = size.decoded_frames_per_second;
    lines + &format!("decoding   {rate:.0} frames a second on one thread\n")
}

impl frame::Report for Info {
    fn is_result(&self) -> bool {
        true
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        let Some(summary) = &self.clip else {
            return self.lines_of_frames();
        };
        let size = &summary.size;
        let mut lines = format!("{}: {}", self.file, lines_of(size));
        lines += &format!(
            "motion     {} frames of {} joints, {:.2} s at {:.2} Hz; {} numbers a frame change\n",
            size.frames,
            size.joints,
            size.duration_seconds,
            1.0 / size.frame_time_seconds,
            size.channels,
        );
        lines += &format!(
            "bound      {:.4} mm for points within {:.4} m of a joint\n",
            1e3 * summary.tolerance_metres,
            summary.shell_metres
        );
        for bound in &summary.joint_bounds {
            lines += &format!(
                "           {:.4} mm within {:.4} m of {}\n",
                1e3 * bound.tolerance_metres,
                bound.shell_metres,
                bound.joint
            );
        }
        if !summary.tracks.is_empty() {
            let tracks = summary.tracks.join(", ");
            lines += &format!(
                "tracks     {tracks}; within {:.1e}\n",
                summary.track_tolerance
            );
        }
        lines
    }
}

impl Info {
    /// A motion that is not compressed, for people.
    fn lines_of_frames(&self) -> String {
        let Some(frames) = &self.frames else {
            return String::new();
        };
        let mut lines = format!(
            "{}: {} frames of {} joints, {:.2} s at {:.2} Hz; a unit is {} m\n",
            self.file,
            frames.frames,
            frames.joints,
            frames.duration_seconds,
            1.0 / frames.frame_time_seconds,
            short(self.metres_per_unit)
        );
        if let Some(animations) = frames.animations {
            lines += &format!("animations {animations}\n");
        }
        if !frames.tracks.is_empty() {
            lines += &format!("tracks     {}\n", frames.tracks.join(", "));
        }
        lines
    }
}
