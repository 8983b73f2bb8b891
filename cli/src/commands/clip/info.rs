//! `nullcone clip info`: what a compressed clip consists of.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::Result;
use ga_anim::clip::compressed::{CompressedClip, Sampler};
use serde::Serialize;

use crate::frame::{self, Command, Context};

/// Say what a compressed clip consists of, and how small and fast it is.
///
/// For instance
///
///   nullcone clip info walk.clip --mesh-vertices 13380 --json
///
/// prints {"bytes": …, "raw_bytes": …, "ratio": …, "frames": 2752, "joints": 31, …}. raw_bytes are
/// 40 for each joint and frame: a rotation, a translation and a factor along each axis in single
/// precision. bytes are all of the file but the joints' names. With --mesh-vertices, a frame is
/// compared with the positions of that many vertices in single precision.
/// decoded_frames_per_second is measured on one thread and differs from run to run.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The clip.
    #[arg(value_name = "FILE.clip")]
    clip: PathBuf,
    /// How many vertices the mesh has that the clip moves, to compare with frames stored as meshes.
    #[arg(long, value_name = "N")]
    mesh_vertices: Option<u64>,
}

impl Command for Arguments {
    type Report = Info;

    fn run(&self, context: &Context) -> Result<Info> {
        context.files([&self.clip])?;
        let clip = CompressedClip::read(&self.clip)?;
        Ok(Info::new(&self.clip, &clip, self.mesh_vertices))
    }
}

/// How large a clip is, and what it replaces.
#[derive(Debug, Serialize)]
pub(super) struct Size {
    pub(super) bytes: usize,
    raw_bytes: u64,
    ratio: f64,
    pub(super) frames: usize,
    pub(super) joints: usize,
    /// How many numbers change from frame to frame.
    pub(super) channels: usize,
    frame_time_seconds: f64,
    duration_seconds: f64,
    bytes_per_frame: f64,
    decoded_frames_per_second: f64,
    #[serde(flatten)]
    mesh: Option<MeshSize>,
}

/// A frame of the clip beside one that is stored as a mesh (Cui, fig. 5).
#[derive(Debug, Serialize)]
struct MeshSize {
    mesh_vertices: u64,
    mesh_bytes_per_frame: u64,
    mesh_ratio: f64,
}

/// The bytes of a joint in a frame: four numbers of a rotation, three of a translation, three
/// factors.
const RAW: u64 = 40;

/// The bytes of a vertex in a frame.
const VERTEX: u64 = 12;

impl Size {
    pub(super) fn new(clip: &CompressedClip, mesh_vertices: Option<u64>) -> Self {
        let bytes = clip.as_bytes().len() - clip.name_bytes();
        let (frames, joints) = (clip.frame_count(), clip.parents().len());
        let raw_bytes = RAW * frames as u64 * joints as u64;
        let bytes_per_frame = bytes as f64 / frames as f64;
        Self {
            bytes,
            raw_bytes,
            ratio: raw_bytes as f64 / bytes as f64,
            frames,
            joints,
            channels: clip.channel_count(),
            frame_time_seconds: clip.frame_time(),
            duration_seconds: clip.duration(),
            bytes_per_frame,
            decoded_frames_per_second: rate(clip),
            mesh: mesh_vertices.map(|mesh_vertices| {
                let mesh_bytes_per_frame = VERTEX.saturating_mul(mesh_vertices);
                MeshSize {
                    mesh_vertices,
                    mesh_bytes_per_frame,
                    mesh_ratio: mesh_bytes_per_frame as f64 / bytes_per_frame,
                }
            }),
        }
    }

    /// For people, as the rest of a line and lines below.
    pub(super) fn lines(&self) -> String {
        let mut lines = format!(
            "{} bytes instead of {}, {:.1} : 1; {:.1} bytes a frame\n",
            self.bytes, self.raw_bytes, self.ratio, self.bytes_per_frame
        );
        if let Some(mesh) = &self.mesh {
            lines += &format!(
                "mesh       {} vertices are {} bytes a frame, {:.0} times as many\n",
                mesh.mesh_vertices, mesh.mesh_bytes_per_frame, mesh.mesh_ratio
            );
        }
        lines += &format!(
            "decoding   {:.0} frames a second on one thread\n",
            self.decoded_frames_per_second
        );
        lines
    }
}

/// How many whole frames are decoded in a second.
fn rate(clip: &CompressedClip) -> f64 {
    const LEAST_SECONDS: f64 = 0.02;
    let mut sampler = Sampler::new(clip);
    let begin = Instant::now();
    let mut frames = 0;
    loop {
        for frame in 0..clip.frame_count().min(10_000) {
            sampler.sample_frame(frame);
            black_box(sampler.rotors());
            frames += 1;
        }
        let seconds = begin.elapsed().as_secs_f64();
        if seconds > LEAST_SECONDS {
            return f64::from(frames) / seconds;
        }
    }
}

/// What is said about a clip.
#[derive(Debug, Serialize)]
pub(crate) struct Info {
    file: String,
    #[serde(flatten)]
    size: Size,
    tolerance_metres: f64,
    shell_metres: f64,
    track_tolerance: f64,
    joint_bounds: Vec<Bound>,
    joint_names: Vec<String>,
    /// The index of each joint's parent; `null` for a root.
    joint_parents: Vec<Option<usize>>,
    tracks: Vec<String>,
}

/// The bound of one joint.
#[derive(Debug, Serialize)]
struct Bound {
    joint: String,
    tolerance_metres: f64,
    shell_metres: f64,
}

impl Info {
    fn new(path: &Path, clip: &CompressedClip, mesh_vertices: Option<u64>) -> Self {
        let options = clip.options();
        let own = options.joints.iter();
        Self {
            file: path.display().to_string(),
            size: Size::new(clip, mesh_vertices),
            tolerance_metres: options.tolerance,
            shell_metres: options.shell,
            track_tolerance: options.track_tolerance,
            joint_bounds: own
                .map(|bound| Bound {
                    joint: clip.names()[bound.joint].clone(),
                    tolerance_metres: bound.tolerance,
                    shell_metres: bound.shell,
                })
                .collect(),
            joint_names: clip.names().to_vec(),
            joint_parents: clip.parents().to_vec(),
            tracks: clip.track_names().map(ToOwned::to_owned).collect(),
        }
    }
}

impl frame::Report for Info {
    fn is_result(&self) -> bool {
        true
    }

    fn text(&self) -> String {
        let size = &self.size;
        let mut lines = format!("{}: {}", self.file, size.lines());
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
            1e3 * self.tolerance_metres,
            self.shell_metres
        );
        for bound in &self.joint_bounds {
            lines += &format!(
                "           {:.4} mm within {:.4} m of {}\n",
                1e3 * bound.tolerance_metres,
                bound.shell_metres,
                bound.joint
            );
        }
        if !self.tracks.is_empty() {
            let tracks = self.tracks.join(", ");
            lines += &format!("tracks     {tracks}; within {:.1e}\n", self.track_tolerance);
        }
        lines
    }
}
