//! `nullcone clip convert`: a motion in another format.

use anyhow::Result;

use super::input::MotionArguments;
use super::target::{Report, TargetArguments};
use crate::frame::{Command, Context};

/// Write a motion in another format: BVH, glTF 2.0 or a compressed clip, from any to any.
///
/// The endings of the names say the formats. Joints are where they were in every frame, and rotate
/// as they did: exactly in BVH, to single precision in glTF, and within the bounds of compression
/// in a clip. What the other format does not hold is listed in warnings, such as meshes, skins and
/// weights of morph targets, and in BVH factors of joints and their axes at rest.
///
/// The unit of a .bvh that is read is found from the body in motion: it is the one with which thigh
/// and shin are most like an adult's 0.82 m, of metre, 0.0254/0.45 m as CMU has it, inch,
/// centimetre and millimetre. It is printed, and a warning says where it is not clear.
///
/// For instance
///
///   nullcone clip convert walk.clip --out walk.bvh
///
/// writes a BVH file in metres. With --json it prints {"file": …, "out": …, "metres_per_unit": …,
/// "inputs": [{"file": …, "frames": …, "joints": …, …}], "frames": …, "joints": …,
/// "frame_time_seconds": …, "duration_seconds": …, …, "warnings": […]}; for a .clip with the keys
/// of `nullcone clip compress`. frames are those of the file that is written.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    motion: MotionArguments,
    #[command(flatten)]
    target: TargetArguments,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        self.target
            .write_changed(&self.motion, context, |_, recording| Ok(recording.clone()))
    }
}
