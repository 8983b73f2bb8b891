//! BVH (Biovision hierarchy): motion capture as text, a skeleton and then its channels frame by
//! frame.
//!
//! Every joint lists its channels, in an order that may differ from joint to joint. A joint's
//! motion relative to its parent is
//!
//! ```text
//! M = T(offset + position) R₁ R₂ R₃
//! ```
//!
//! with the rotations about the fixed axes x, y, z in the order of the channels, so that the last
//! one acts on a point first, and with the position channels added to the offset. Angles are
//! degrees in the file. Lengths have the file's unit, which it does not state; by convention y
//! points up.
//!
//! The reader is strict where numbers would be guessed: an error names the line, and a frame has
//! exactly one number for each channel. Two deviations are so common that such files are read, with
//! a [warning](Bvh::warnings):
//!
//! - The file has one frame more or one fewer than it announces. The frames that are there count.
//! - Position channels sit on joints below the root. Some programs write what is added to the
//!   offset there, as the description says; others write the offset and what is added to it, so
//!   that the numbers take the place of the offset. The second reading is chosen where the numbers
//!   are near the offsets, within a quarter of their lengths, in most frames. It then holds for all
//!   joints.
//!
//! Source: the description by the Motion Capture Web Group, University of Wisconsin, on which
//! readers agree.

mod conversion;
mod kinematics;
mod parser;
mod warning;
mod words;
mod writer;

use std::path::Path;

use ga_files::ReadError;

pub use warning::{BvhWarning, PositionChannels};
pub use writer::BvhConversionError;

/// A skeleton and its motion in the form of a BVH file.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh {
    joints: Vec<BvhJoint>,
    frame_time: f64,
    frame_count: usize,
    /// Frame by frame, within a frame in the order of the joints and their channels.
    values: Vec<f64>,
    positions: PositionChannels,
    warnings: Vec<BvhWarning>,
}

/// A joint of a BVH skeleton.
#[derive(Clone, Debug, PartialEq)]
pub struct BvhJoint {
    /// The name, unique in its file.
    pub name: String,
    /// The index of the parent joint, or `None` for a root. Parents come before children.
    pub parent: Option<usize>,
    /// Where the joint is at rest, relative to its parent.
    pub offset: [f64; 3],
    /// The joint's channels, in the order of the file.
    pub channels: Vec<Channel>,
    /// How many channels the joints before this one have.
    pub first_channel: usize,
    /// The end of the bone at rest, relative to this joint, if the joint has an End Site.
    pub end_site: Option<[f64; 3]>,
}

/// What one number of a frame moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// A translation along an axis: 0, 1, 2 for x, y, z.
    Position(usize),
    /// A rotation about an axis: 0, 1, 2 for x, y, z; in degrees, by the right-hand rule.
    Rotation(usize),
}

/// Reads the motion in a file.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`parse`] gives.
pub fn read(path: impl AsRef<Path>) -> Result<Bvh, ReadError<BvhError>> {
    ga_files::read(path, parse)
}

/// Reads a motion from the bytes of a file.
///
/// # Errors
///
/// [`BvhError`], for the first fault.
///
/// # Examples
///
/// ```
/// let text = b"HIERARCHY
/// ROOT Hips
/// {
///   OFFSET 0 0 0
///   CHANNELS 4 Yposition Zrotation Xrotation Yrotation
///   End Site
///   {
///     OFFSET 0 2 0
///   }
/// }
/// MOTION
/// Frames: 1
/// Frame Time: 0.04
/// 9.5 0 90 0
/// ";
/// let motion = ga_anim::bvh::parse(text)?;
/// assert_eq!(motion.joints()[0].name, "Hips");
/// assert_eq!(motion.frame(0), Some(&[9.5, 0.0, 90.0, 0.0][..]));
///
/// let error = ga_anim::bvh::parse(&text[..text.len() - 5]).unwrap_err();
/// assert_eq!(error.to_string(), "line 14: a frame has 4 numbers, but this one has 2");
/// # Ok::<(), ga_anim::bvh::BvhError>(())
/// ```
pub fn parse(bytes: &[u8]) -> Result<Bvh, BvhError> {
    parser::parse(bytes)
}

impl Bvh {
    /// The joints, parents before children, in the order of the file.
    #[must_use]
    pub fn joints(&self) -> &[BvhJoint] {
        &self.joints
    }

    /// The index of the joint of this name.
    #[must_use]
    pub fn index(&self, name: &str) -> Option<usize> {
        self.joints.iter().position(|joint| joint.name == name)
    }

    /// The time from one frame to the next, in seconds.
    #[must_use]
    pub fn frame_time(&self) -> f64 {
        self.frame_time
    }

    /// How many frames there are; may be 0.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        self.frame_count
    }

    /// The numbers of a frame, in the order of the joints and their channels.
    #[must_use]
    pub fn frame(&self, frame: usize) -> Option<&[f64]> {
        let channels = self.channel_count();
        (frame < self.frame_count).then(|| &self.values[frame * channels..(frame + 1) * channels])
    }

    /// What in the file deviates from the format and was read nevertheless; each kind once.
    #[must_use]
    pub fn warnings(&self) -> &[BvhWarning] {
        &self.warnings
    }

    /// How the position channels are meant.
    #[must_use]
    pub fn position_channels(&self) -> PositionChannels {
        self.positions
    }

    /// How many numbers a frame has.
    #[must_use]
    pub fn channel_count(&self) -> usize {
        self.joints.iter().map(|joint| joint.channels.len()).sum()
    }
}

/// What is wrong with a BVH file, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("line {line}: {problem}")]
pub struct BvhError {
    /// The line, from 1; for what is missing, the last line.
    pub line: usize,
    /// What is wrong.
    pub problem: BvhProblem,
}

/// What can be wrong with a BVH file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BvhProblem {
    /// The line is not UTF-8, or holds a null byte.
    #[error("the file is not UTF-8 text")]
    NotText,
    /// Another word should stand here.
    #[error("expected {expected}, found {found:?}")]
    Expected {
        /// What should stand here.
        expected: &'static str,
        /// What does.
        found: String,
    },
    /// The file ends too early.
    #[error("the file ends; expected {expected}")]
    EndOfFile {
        /// What should follow.
        expected: &'static str,
    },
    /// A word is in the place of a number.
    #[error("{word:?} is not a number")]
    NotANumber {
        /// The word.
        word: String,
    },
    /// A number is infinite, not a number, or too large.
    #[error("{word:?} is not a finite number")]
    NotFinite {
        /// The word.
        word: String,
    },
    /// A frame time is 0 or negative.
    #[error("the frame time must be greater than 0 seconds, but is {0}")]
    FrameTime(f64),
    /// A word is in the place of a channel; perhaps fewer channels follow than the line announces.
    #[error("{word:?} is not a channel")]
    UnknownChannel {
        /// The word.
        word: String,
    },
    /// A joint has one channel twice.
    #[error("joint {joint:?} has channel {word} twice")]
    DuplicateChannel {
        /// The joint.
        joint: String,
        /// The channel.
        word: String,
    },
    /// Two joints have the same name.
    #[error("two joints are called {name:?}")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// An element that a joint must have once is missing or there twice.
    #[error("joint {joint:?} has {found} {what} lines instead of one")]
    NotOnce {
        /// The joint.
        joint: String,
        /// `"OFFSET"`, `"CHANNELS"` or `"End Site"`.
        what: &'static str,
        /// How many it has.
        found: usize,
    },
    /// No joint has a channel.
    #[error("no joint has a channel")]
    NoChannels,
    /// The numbers of a frame are not as many as the channels.
    #[error("a frame has {expected} numbers, but this one has {found}")]
    FrameLength {
        /// How many channels there are.
        expected: usize,
        /// How many numbers the frame has.
        found: usize,
    },
    /// The number of frames differs from the one announced by more than one, or none is there.
    #[error("the file announces {expected} frames and has {found}")]
    FrameCount {
        /// How many frames are announced.
        expected: usize,
        /// How many there are, or two more than announced.
        found: usize,
    },
}
