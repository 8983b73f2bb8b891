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
