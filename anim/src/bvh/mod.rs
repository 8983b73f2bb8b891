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
//! one acts on a point first. Angles are degrees in the file. Lengths have the file's unit, which
//! it does not state; by convention y points up.
//!
//! The positions of a root take the place of its offset, and those of other joints are added to
//! theirs, with two exceptions:
//!
//! - Where only the sum of offset and position puts the body on the ground, they are added at the
//!   root as well, with a [warning](Bvh::warnings). The description adds, and so does three.js at
//!   every joint. assimp takes the positions of a joint with six channels as they are, and
//!   Blender those of every joint: it stands a bone at its offset and moves it by the difference
//!   of position and offset. Autodesk does not publish how MotionBuilder reads them. In recordings
//!   of Ubisoft the offset of the root is a place in the room like its positions, so that adding
//!   would put the body at twice its height.
//! - Where the positions of other joints are near their offsets, within a quarter of their lengths,
//!   in most frames, they take the place of these.
//!
//! The reader is strict where numbers would be guessed: an error names the line, and the numbers of
//! a frame are just as many as the channels. A [warning](Bvh::warnings) says that position channels
//! are on joints below the root, see above, or that the file has one frame more or one fewer than
//! it announces; the frames that are there count.
//!
//! # Deviations
//!
//! A [tolerant](ga_files::Reading) reading, which [`read`] and [`decode`] do, also takes what other
//! programs read, with one warning for each kind, which names its first line and says how many
//! lines there are. A strict reading makes an error of it.
//!
//! | in the file | read as | as by |
//! | --- | --- | --- |
//! | `End Site NAME` | `End Site` | Blender, the Python package bvh |
//! | `Frames:3`, `Frames :3`, `Frames 3`, and so with `Frame Time` | `Frames: 3` | three.js |
//! | another number of frames than announced, but some | those that are there | Blender |
//! | a frame on several lines, several on a line | frames across lines | assimp |
//! | joints of the same name | the later ones as `Spine.001` | Blender |
//! | a joint without `CHANNELS` | a joint that does not move | assimp |
//! | more or fewer channels than announced | those that are listed | Blender |
//! | text behind `MOTION`, the two numbers, or the last frame | left out | assimp, three.js |
//! | lines that end in CR alone | lines | assimp |
//! | names that are not UTF-8 | see [`ga_files::text::decode`] | |
//!
//! Frames begin and end anywhere in lines only where all lines have the same number of numbers, the
//! last perhaps fewer, and together just those of the frames that are announced; otherwise a line
//! or a group of lines is a frame.
//!
//! A number that is missing from a frame, text among the frames, NaN and infinity are errors in
//! either reading. Keywords may be in small letters, with any white space between them.
//!
//! Source: the description by the Motion Capture Web Group, University of Wisconsin, on which
//! readers agree.

mod channels;
mod conversion;
mod frames;
mod from_recording;
mod joint;
mod kinematics;
mod motion;
mod parser;
pub(crate) mod problem;
mod root_offset;
mod warning;
mod words;
mod writer;

use std::path::Path;

use crate::file_error::MotionFileError;
use ga_files::{ReadError, Reading};

pub use joint::{BvhJoint, Channel};
pub use motion::Bvh;
pub use problem::BvhProblem;
pub use warning::{BvhWarning, PositionChannels};

/// Reads the motion in a file tolerantly.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`decode`] gives.
pub fn read(path: impl AsRef<Path>) -> Result<Bvh, ReadError<MotionFileError>> {
    read_as(path, Reading::Tolerant)
}

/// Reads the motion in a file.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`decode_as`] gives.
pub fn read_as(
    path: impl AsRef<Path>,
    reading: Reading,
) -> Result<Bvh, ReadError<MotionFileError>> {
    ga_files::read(path, |bytes| decode_as(bytes, reading))
}

/// Reads a motion from the bytes of a file tolerantly.
///
/// # Errors
///
/// [`MotionFileError`], for the first fault.
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
/// let motion = ga_anim::bvh::decode(text)?;
/// assert_eq!(motion.joints()[0].name, "Hips");
/// assert_eq!(motion.frame(0), Some(&[9.5, 0.0, 90.0, 0.0][..]));
///
/// let error = ga_anim::bvh::decode(&text[..text.len() - 5]).unwrap_err();
/// assert_eq!(error.to_string(), "line 14: a frame has 4 numbers, but this one has 2");
/// # Ok::<(), ga_anim::MotionFileError>(())
/// ```
pub fn decode(bytes: &[u8]) -> Result<Bvh, MotionFileError> {
    decode_as(bytes, Reading::Tolerant)
}

/// Reads a motion from the bytes of a file.
///
/// # Errors
///
/// As [`decode`]; for a strict reading also what other readers tolerate.
///
/// # Examples
///
/// ```
/// use ga_anim::bvh;
/// use ga_files::Reading;
///
/// let text = b"HIERARCHY
/// ROOT Hips
/// {
///   OFFSET 0 0 0
///   CHANNELS 1 Xrotation
/// }
/// MOTION
/// Frames:1
/// Frame Time: 0.04
/// 90
/// ";
/// let motion = bvh::decode_as(text, Reading::Tolerant)?;
/// let warning = motion.warnings()[0].to_string();
/// assert!(warning.starts_with("line 8: expected Frames:, found \"Frames:1\"; "), "{warning}");
/// assert!(bvh::decode_as(text, Reading::Strict).is_err());
/// # Ok::<(), ga_anim::MotionFileError>(())
/// ```
pub fn decode_as(bytes: &[u8], reading: Reading) -> Result<Bvh, MotionFileError> {
    parser::parse(bytes, reading)
}
