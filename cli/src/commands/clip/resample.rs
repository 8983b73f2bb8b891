//! `nullcone clip resample`: the same motion at another number of frames per second.

use std::path::PathBuf;

use anyhow::{Context as _, Result};

use super::input::MotionArguments;
use super::target::{Report, TargetArguments};
use crate::frame::{Command, Context};

/// Write the same motion at another number of frames per second.
///
/// Between the frames of the motion rotations move along the shorter arc at constant speed,
/// translations and factors linearly. The last frame is the last whole step within the duration of
/// the motion. A glTF animation is sampled from its own curves, up to the step at or after its last
/// key.
///
/// For instance
///
///   nullcone clip resample walk.clip --rate 30 --out walk-30.clip
///
/// writes a frame every 1/30 s. With --json it prints the same keys as `nullcone clip convert`;
/// max_error_metres is the error of compression to .clip, against the resampled motion.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The motion: BVH, glTF or a compressed clip.
    #[arg(value_name = "MOTION")]
    motion: PathBuf,
    /// Frames per second.
    #[arg(long, value_name = "HZ")]
    rate: f64,
    /// The length of one unit of the motion in metres [default: of BVH found from the length of the
    /// legs, of glTF 1]. A compressed clip is in metres.
    #[arg(long, value_name = "METRES")]
    metres_per_unit: Option<f64>,
    /// The number of the animation in a glTF file, from 0 [default: 0].
    #[arg(long, value_name = "N")]
    animation: Option<usize>,
    #[command(flatten)]
    target: TargetArguments,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let rate = self.rate;
        let motion = MotionArguments {
            motion: self.motion.clone(),
            metres_per_unit: self.metres_per_unit,
            animation: self.animation,
            rate: None,
        };
        self.target
            .write_changed(&motion, context, |file, recording| {
                let resampled = file.resampled(recording, rate);
                resampled.with_context(|| format!("{}: --rate {rate}", motion.file()))
            })
    }
}
