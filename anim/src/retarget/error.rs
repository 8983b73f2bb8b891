//! Why motions cannot be retargeted.

use crate::clip::ClipError;
use crate::pose::PoseError;

/// Why a recording cannot move a skeleton.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RetargetError {
    /// No joint of the recording belongs to one of the skeleton, by name or by the map.
    #[error("no joint of the motion belongs to a joint of the skeleton, by name or by the map")]
    NoMatch,
    /// No leg was found: matched long bones above a foot on the ground.
    #[error(
        "rig and motion have no leg in common; a leg is a chain of long bones above one that lies on the ground"
    )]
    NoLegs,
    /// The recording has no frame.
    #[error("the motion has no frames")]
    NoFrames,
    /// A range of frames is empty or goes beyond the recording.
    #[error("frames {from} to {to} are not in a motion of {frames} frames, counted from 0")]
    FrameRange {
        /// The first frame.
        from: usize,
        /// The last frame.
        to: usize,
        /// How many frames the recording has.
        frames: usize,
    },
    /// The recording's numbers are so large that computations overflow.
    #[error("frame {frame} of the motion overflows")]
    Overflow {
        /// The frame, from 0.
        frame: usize,
    },
    /// A setting of foot locking is not positive and finite.
    #[error("{name} cannot be {value}")]
    FootLocking {
        /// What it is.
        name: &'static str,
        /// The number.
        value: f64,
    },
    /// The poses do not form a clip.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// A pose does not fit the skeleton.
    #[error(transparent)]
    Pose(#[from] PoseError),
}
