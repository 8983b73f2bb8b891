//! Why pictures cannot be read or written.

use crate::format::Format;

/// Bytes that are not a picture.
#[derive(Debug, thiserror::Error)]
pub enum DecodeError {
    /// The first bytes are not those of any known format.
    #[error(
        "not a picture of a known format (PNG, JPEG, PGM, PPM, PFM, Y4M): it begins with {start:02x?}"
    )]
    UnknownFormat {
        /// The first bytes, at most eight.
        start: Vec<u8>,
    },
    /// The bytes break a rule of the format.
    #[error("{format}, byte {offset}: {problem}")]
    Syntax {
        /// The format.
        format: Format,
        /// The index of the byte at which the rule is broken.
        offset: usize,
        /// What is wrong.
        problem: &'static str,
    },
    /// The header states a size for which the file is too short, even with the best compression.
    #[error("{format}: the header claims {width} × {height} pixels, too many for {length} bytes")]
    Claim {
        /// The format.
        format: Format,
        /// Columns as stated.
        width: usize,
        /// Rows as stated.
        height: usize,
        /// The length of the file.
        length: usize,
    },
    /// The format allows it, this reader does not.
    #[error("{format}: {what} is not supported")]
    Unsupported {
        /// The format.
        format: Format,
        /// What is not supported.
        what: String,
    },
    /// The PNG decoder refused the bytes.
    #[error("PNG: {0}")]
    Png(#[from] ::png::DecodingError),
    /// The JPEG decoder refused the bytes.
    #[error("JPEG: {0:?}")]
    Jpeg(#[from] zune_jpeg::errors::DecodeErrors),
}

/// A picture that has no form in a format.
#[derive(Debug, thiserror::Error)]
pub enum EncodeError {
    /// The format has no such pixels.
    #[error("{format} cannot hold {kind}")]
    Kind {
        /// The format.
        format: Format,
        /// The kind of pixel.
        kind: &'static str,
    },
    /// There are no pixels, or more rows or columns than the format can count.
    #[error("{format} cannot hold a picture of {width} × {height} pixels")]
    Size {
        /// The format.
        format: Format,
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// A film or an animation has no frames, or more than the format can count.
    #[error("{format} cannot hold a film of {frames} frames")]
    Frames {
        /// The format.
        format: Format,
        /// The number of frames.
        frames: usize,
    },
    /// A frame differs in size from the first one.
    #[error(
        "frame {frame} has {} × {} pixels, the first has {} × {}",
        size[0], size[1], first[0], first[1]
    )]
    FrameSize {
        /// The index of the frame, from 0.
        frame: usize,
        /// Its columns and rows.
        size: [usize; 2],
        /// Columns and rows of the first frame.
        first: [usize; 2],
    },
    /// A palette has no colours or more than 256, or a pixel names a colour that it does not have.
    #[error(
        "the pixel {index} is not in a palette of {colours} colours, or these are not 1 to 256"
    )]
    Palette {
        /// The greatest number among the pixels.
        index: u8,
        /// The number of colours.
        colours: usize,
    },
    /// The PNG encoder failed.
    #[error("PNG: {0}")]
    Png(#[from] ::png::EncodingError),
    /// The JPEG encoder failed.
    #[error("JPEG: {0}")]
    Jpeg(#[from] image::ImageError),
}
