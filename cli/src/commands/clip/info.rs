//! `nullcone clip info`: what a compressed clip consists of.

use std::path::PathBuf;

use anyhow::Result;
use ga_anim::clip::compressed::{CompressedClip, Size, Summary};
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
        Ok(Info {
            file: self.clip.display().to_string(),
            summary: Summary::new(&clip, self.mesh_vertices),
        })
    }
}

/// What is said about a clip.
#[derive(Debug, Serialize)]
pub(crate) struct Info {
    file: String,
    #[serde(flatten)]
    summary: Summary,
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

    fn text(&self) -> String {
        let (summary, size) = (&self.summary, &self.summary.size);
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
