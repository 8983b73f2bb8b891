//! The file of a compressed clip.

mod cursor;
mod joints;
mod read;
mod write;

pub(super) use read::{Parsed, parse};
pub(super) use write::{Contents, to_bytes};

/// How a file begins.
const MAGIC: [u8; 8] = *b"NULLCLIP";

/// The version of the format.
const VERSION: u32 = 1;

/// The length of the header with its checksum, in bytes.
const HEADER: usize = 76;

/// The greatest absolute values that channels may have: they stay finite in single precision even
/// when they are squared.
const MOST_LENGTH: f64 = 1e15;
const MOST_BIVECTOR: f64 = 1e6;

/// The most channels of a clip, so that the bits of a segment can be counted in 32 bits.
const MOST_CHANNELS: usize = 1 << 22;

/// What is wrong with the file of a compressed clip, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FileError {
    /// The file does not begin as a clip.
    #[error("the file is not a compressed clip: it does not begin with \"NULLCLIP\"")]
    NotAClip,
    /// The format has another version.
    #[error("the clip has version {0} of the format, and this program reads version 1")]
    Version(u32),
    /// The file ends early.
    #[error("the file ends in its {section}: it has {found} bytes of {expected}")]
    Truncated {
        /// The part of the file that is not complete.
        section: &'static str,
        /// How many bytes it should have.
        expected: u64,
        /// How many it has.
        found: u64,
    },
    /// Bytes follow the end.
    #[error("the file has {found} bytes, but its header announces {expected}")]
    TooLong {
        /// How many bytes it should have.
        expected: u64,
        /// How many it has.
        found: u64,
    },
    /// A part is damaged.
    #[error("the {section} of the file are damaged: their checksum does not match")]
    Checksum {
        /// The part of the file.
        section: &'static str,
    },
    /// A part that is whole by its checksum says something impossible.
    #[error("the clip is invalid: {what} {index}")]
    Invalid {
        /// What is wrong.
        what: &'static str,
        /// Which joint, track or segment has it, or which number.
        index: u64,
    },
    /// The numbers at the beginning say something impossible.
    #[error("the clip is invalid: {0}")]
    Header(&'static str),
    /// The clip has more of something than the format can say.
    #[error("the clip has {count} {what}, more than a file can hold")]
    TooMany {
        /// Joints, frames, tracks or bytes.
        what: &'static str,
        /// How many.
        count: usize,
    },
}
