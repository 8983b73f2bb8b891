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
//!   root as well, with a [warning](Bvh::warnings). The description adds, and so does three.js;
//!   assimp takes the positions as they are, and Blender moves each bone by their difference from
//!   its place at rest, which is the same. MotionBuilder is not documented; the files that it and
//!   its plug-ins write have the place of the first frame as offset and in the positions too, so
//!   that adding would put the body at twice its height.
//! - Where the positions of other joints are near their offsets, within a quarter of their lengths,
//!   in most frames, they take the place of these.
//!
//! The reader is strict where numbers would be guessed: an error names the line, and a frame has
//! exactly one number for each channel. Two deviations are so common that such files are read, with
//! a [warning](Bvh::warnings):
//!
//! - The file has one frame more or one fewer than it announces. The frames that are there count.
//! - Position channels are on joints below the root, see above.
//!
//! Source: the description by the Motion Capture Web Group, University of Wisconsin, on which
//! readers agree.

mod conversion;
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
use ga_files::ReadError;

pub use joint::{BvhJoint, Channel};
pub use motion::Bvh;
pub use problem::BvhProblem;
pub use warning::{BvhWarning, PositionChannels};

/// Reads the motion in a file.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`decode`] gives.
pub fn read(path: impl AsRef<Path>) -> Result<Bvh, ReadError<MotionFileError>> {
    ga_files::read(path, decode)
}

/// Reads a motion from the bytes of a file.
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
    parser::parse(bytes)
}
