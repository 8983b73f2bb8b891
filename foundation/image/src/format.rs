//! Formats of picture files.

use std::fmt;

/// A format of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Portable Network Graphics.
    Png,
    /// JPEG. It is read; [`write()`](crate::file::write()) does not write it, since colours change.
    Jpeg,
    /// Portable grey map and portable pixel map, PGM and PPM.
    Pnm,
    /// Portable float map.
    Pfm,
    /// YUV4MPEG2, a film without compression.
    Y4m,
}

impl Format {
    /// The format whose signature is at the beginning of `bytes`.
    #[must_use]
    pub fn detect(bytes: &[u8]) -> Option<Self> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => Some(Self::Png),
            [0xff, 0xd8, 0xff, ..] => Some(Self::Jpeg),
            [b'P', b'2' | b'3' | b'5' | b'6', ..] => Some(Self::Pnm),
            [b'P', b'F' | b'f', ..] => Some(Self::Pfm),
            _ => bytes.starts_with(b"YUV4MPEG2 ").then_some(Self::Y4m),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Png => "PNG",
            Self::Jpeg => "JPEG",
            Self::Pnm => "PNM",
            Self::Pfm => "PFM",
            Self::Y4m => "Y4M",
        })
    }
}
