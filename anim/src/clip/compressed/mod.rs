//! Clips compressed with an error that stays within a bound on every frame.
//!
//! [`compress`] makes a [`CompressedClip`] of a [`Recording`](crate::recording::Recording), whose
//! bytes are its file, and a [`Sampler`] decodes any frame of it without its predecessors, in
//! single precision. [`measure`] compares both on every frame.
//!
//! # How
//!
//! - *Channels*. The rotation of a joint is projected stereographically about its middle rotation:
//!   R = M (1 + B)² / (1 + |B|²) with a bivector B. Of B, of the translation and of the factors
//!   only those principal axes are kept along which something changes: a hinge is one channel, and
//!   what is constant takes no bits.
//! - *Segments* of 32 frames. In each, a channel is a polynomial of degree up to 5 in an orthogonal
//!   basis, with integer coefficients in Rice codes, and a residual of a fixed number of bits for
//!   each frame. All channels' residuals of a frame lie together.
//! - *Closed loop*. Joints are encoded from the roots on, each against its decoded parent, and
//!   rotated by the least angle with which the joints that it carries come to their true places. So
//!   errors do not add up along the hierarchy.
//! - *Search*. The bits of each channel in each segment are raised until the bound holds, then
//!   lowered one by one as long as it does; then one is raised where this lets others be lowered by
//!   more.
//!
//! # File
//!
//! All numbers are little-endian. A header of fixed length with counts, options and the lengths of
//! the sections, then three sections: names, joints, segments. The header and each section end with
//! a CRC-32, so a file that is cut or changed anywhere is a [`ClipError`](crate::clip::ClipError).

mod basis;
mod bits;
mod clip;
mod encode;
mod file;
mod layout;
mod measure;
mod named_bound;
mod options;
mod pack;
mod piece;
mod sampler;
mod shell;
mod size;
mod skin;
mod summary;
mod tables;

pub use clip::CompressedClip;
pub use encode::compress;
pub(crate) use layout::double_transform;
pub use measure::{Measured, measure};
pub use named_bound::{NamedBound, NamedBoundError};
pub use options::{JointBound, Options};
pub use sampler::Sampler;
pub(crate) use shell::ShellError;
pub use size::{MeshSize, Size};
pub use skin::{SkinMismatch, error_at_skin};
pub use summary::{Accuracy, BoundSummary, Summary};
