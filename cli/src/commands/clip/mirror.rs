//! `nullcone clip mirror`: left and right change places.

use anyhow::{Context as _, Result};
use clap::ValueEnum;
use ga_runtime::vga3::Vector;

use super::input::MotionArguments;
use super::target::{Report, TargetArguments};
use crate::frame::{Command, Context};

/// Write the mirror image of a motion: left and right change places.
///
/// The mirror is the plane through the origin across the axis. Each joint moves as its counterpart
/// on the other side does, and joints in the middle move as their own mirror images. The names tell
/// the sides: LeftHand and RightHand, hand.L and hand.R, hand_l and hand_r, lHand and rHand, LHand
/// and RHand. The joints at rest stay as they are, and bones keep their lengths.
///
/// For instance
///
///   nullcone clip mirror walk.clip --out walk-mirrored.clip
///
/// exchanges left and right of a person who looks along y or z. With --json it prints the same keys
/// as `nullcone clip convert`; max_error_metres is the error of compression to .clip, against the
/// mirrored motion.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    motion: MotionArguments,
    /// The axis across which the motion is mirrored.
    #[arg(long, value_enum, default_value_t = Axis::X)]
    axis: Axis,
    #[command(flatten)]
    target: TargetArguments,
}

/// An axis of model space.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Axis {
    X,
    Y,
    Z,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let normal = match self.axis {
            Axis::X => Vector::new(1.0, 0.0, 0.0),
            Axis::Y => Vector::new(0.0, 1.0, 0.0),
            Axis::Z => Vector::new(0.0, 0.0, 1.0),
        };
        self.target
            .write_changed(&self.motion, context, |_, recording| {
                let mirrored = recording.mirrored(normal);
                mirrored.with_context(|| self.motion.file())
            })
    }
}
