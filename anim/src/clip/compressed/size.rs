//! How small and how fast a compressed clip is.

use std::hint::black_box;
use std::time::Instant;

use serde::Serialize;

use super::{CompressedClip, Sampler};

/// The bytes of a joint in a frame that is not compressed: four numbers of a rotation, three of a
/// translation and three factors in single precision.
const RAW: u64 = 40;

/// The bytes of a vertex in a frame that is stored as a mesh.
const VERTEX: u64 = 12;

/// How large a compressed clip is, and what it replaces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Size {
    /// All bytes of the file but the joints' names.
    pub bytes: usize,
    /// 40 bytes for each joint and frame: a rotation, a translation and a factor along each axis in
    /// single precision.
    pub raw_bytes: u64,
    /// `raw_bytes` divided by `bytes`.
    pub ratio: f64,
    /// How many frames there are.
    pub frames: usize,
    /// How many joints there are.
    pub joints: usize,
    /// How many numbers change from frame to frame.
    pub channels: usize,
    /// The time from one frame to the next.
    pub frame_time_seconds: f64,
    /// The time of the last frame.
    pub duration_seconds: f64,
    /// `bytes` divided by `frames`.
    pub bytes_per_frame: f64,
    /// How many whole frames are decoded in a second on one thread, measured here and now.
    pub decoded_frames_per_second: f64,
    /// A frame beside one that is stored as a mesh.
    #[serde(flatten)]
    pub mesh: Option<MeshSize>,
}

/// A frame of a clip beside one that is stored as a mesh (Cui, fig. 5).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshSize {
    /// How many vertices the mesh has.
    pub mesh_vertices: u64,
    /// The positions of the vertices in single precision.
    pub mesh_bytes_per_frame: u64,
    /// `mesh_bytes_per_frame` divided by the bytes of a frame of the clip.
    pub mesh_ratio: f64,
}

impl Size {
    /// Measures a clip, which takes a few hundredths of a second; `mesh_vertices` are those of the
    /// mesh that it moves.
    #[must_use]
    pub fn new(clip: &CompressedClip, mesh_vertices: Option<u64>) -> Self {
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
            decoded_frames_per_second: decoding_rate(clip),
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
}

/// How many whole frames are decoded in a second.
fn decoding_rate(clip: &CompressedClip) -> f64 {
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
