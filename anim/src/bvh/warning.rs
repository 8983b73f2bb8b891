//! Deviations from the format that are so common that a file with them is read.

use ga_files::{Deviation, Tolerated};
use ga_runtime::vga3::Vector;

use super::{BvhJoint, BvhProblem, Channel};

/// What the position channels of a joint are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PositionChannels {
    /// Numbers that are added to the joint's offset, as the format is described.
    Added,
    /// The place of the joint relative to its parent, with the offset in it.
    InPlace,
}

/// Something in a BVH file that deviates from the format and was read nevertheless.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BvhWarning {
    /// Lines that deviate from the format; each kind once.
    #[error("{0}")]
    Deviation(Deviation<BvhProblem>),
    /// Another number of frames than announced.
    #[error("line {line} announces {announced} frames, but the file has {found}, which are used")]
    FrameCount {
        /// The line that announces them, from 1.
        line: usize,
        /// How many are announced.
        announced: usize,
        /// How many there are.
        found: usize,
    },
    /// The positions of the root are added to its offset.
    #[error(
        "the positions of the root are added to its offset, since only that puts the body on the \
         ground"
    )]
    RootPositionsAdded,
    /// Joints below the root have position channels.
    #[error(
        "{joints} joints below the root have position channels, which are {}",
        match .positions {
            PositionChannels::Added => "added to the offsets",
            PositionChannels::InPlace => "used in place of the offsets",
        }
    )]
    PositionsBelowRoot {
        /// How many joints.
        joints: usize,
        /// How their position channels are used.
        positions: PositionChannels,
    },
}

impl BvhWarning {
    /// What it is, as one word for programs: `frame_count`, `root_positions_added`,
    /// `positions_below_root`, or the kind of a deviation.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Deviation(deviation) => deviation.problem.kind(),
            Self::FrameCount { .. } => "frame_count",
            Self::RootPositionsAdded => "root_positions_added",
            Self::PositionsBelowRoot { .. } => "positions_below_root",
        }
    }

    /// The line of the file that it is about, from 1, where it is about one.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        match self {
            Self::Deviation(Deviation { line, .. }) | Self::FrameCount { line, .. } => Some(*line),
            Self::RootPositionsAdded | Self::PositionsBelowRoot { .. } => None,
        }
    }
}

/// The part of an offset's length within which a position counts as the offset.
const NEAR: f64 = 0.25;

/// How the position channels of these joints are meant in these frames of `channel_count` numbers
/// each, and the warning where joints below the root have some.
pub(super) fn position_channels(
    joints: &[BvhJoint],
    values: &[f64],
    channel_count: usize,
) -> (PositionChannels, Option<BvhWarning>) {
    let below_root = || joints.iter().filter(|joint| joint.parent.is_some());
    let count = below_root()
        .filter(|joint| {
            let mut channels = joint.channels.iter();
            channels.any(|channel| matches!(channel, Channel::Position(_)))
        })
        .count();
    if count == 0 {
        return (PositionChannels::Added, None);
    }
    // Numbers that would be added are about 0; a joint that is not away from its parent shows
    // nothing.
    let telling: Vec<(Vector<f64>, [usize; 3])> = below_root()
        .filter(|joint| joint.offset != [0.0; 3])
        .filter_map(|joint| Some((joint.offset.into(), places(joint)?)))
        .collect();
    let (mut near, mut all) = (0_usize, 0_usize);
    for frame in values.chunks_exact(channel_count.max(1)) {
        for &(offset, places) in &telling {
            let position = Vector::from(places.map(|place| frame[place]));
            all += 1;
            near += usize::from(position.distance(offset) <= NEAR * offset.length());
        }
    }
    let positions = if 2 * near > all {
        PositionChannels::InPlace
    } else {
        PositionChannels::Added
    };
    let warning = BvhWarning::PositionsBelowRoot {
        joints: count,
        positions,
    };
    (positions, Some(warning))
}

/// Where in a frame a joint's positions along x, y and z are, if it has all three.
fn places(joint: &BvhJoint) -> Option<[usize; 3]> {
    let place = |axis| {
        let mut channels = joint.channels.iter();
        let index = channels.position(|&channel| channel == Channel::Position(axis))?;
        Some(joint.first_channel + index)
    };
    Some([place(0)?, place(1)?, place(2)?])
}
