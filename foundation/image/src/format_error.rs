//! What is wrong with the contents of a file, or with what is to become such contents.

use std::io;

use crate::format::Format;

/// Bytes that are not a picture or a film, or a picture or a film that has no form in a format.
/// Frames are counted from 0.
#[derive(Debug, thiserror::Error)]
pub enum FormatError {
    /// The first bytes are not those of any known format.
    #[error(
        "not a picture of a known format ({}): it begins with {start:02x?}",
        Format::names()
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
    /// The pixels would take more memory than is allowed.
    #[error(
        "{format}: the header claims {width} × {height} pixels, which take more than {most} bytes"
    )]
    TooLarge {
        /// The format.
        format: Format,
        /// Columns as stated.
        width: usize,
        /// Rows as stated.
        height: usize,
        /// The greatest number of bytes that is allowed.
        most: u64,
    },
    /// What follows the header is not as long as the size that it states.
    #[error(
        "{format}: the header claims {width} × {height} pixels, which are {expected} bytes, and \
         {found} bytes follow it"
    )]
    Length {
        /// The format.
        format: Format,
        /// Columns as stated.
        width: usize,
        /// Rows as stated.
        height: usize,
        /// The bytes of so many pixels.
        expected: usize,
        /// The bytes behind the header.
        found: usize,
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
    PngDecode(#[from] ::png::DecodingError),
    /// The JPEG decoder refused the bytes.
    #[error("JPEG: {0:?}")]
    JpegDecode(#[from] zune_jpeg::errors::DecodeErrors),
    /// The decoder of a TIFF, BMP or WebP file refused the bytes.
    #[error("{format}: {problem}")]
    Decode {
        /// The format.
        format: Format,
        /// What is wrong.
        problem: image::ImageError,
    },
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
    /// A frame, or a second header before it, states another size than the first one.
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
    PngEncode(#[from] ::png::EncodingError),
    /// The JPEG encoder failed.
    #[error("JPEG: {0}")]
    JpegEncode(#[from] image::ImageError),
    /// The bytes could not be read.
    #[error("frame {frame} cannot be read: {source}")]
    Read {
        /// The frame.
        frame: usize,
        /// What the operating system said.
        source: io::Error,
    },
    /// The film ends within a frame.
    #[error("the film ends within frame {frame}, after {found} of {expected} bytes")]
    Truncated {
        /// The frame.
        frame: usize,
        /// Bytes that are there, of the three planes.
        found: usize,
        /// Bytes that three planes have.
        expected: usize,
    },
    /// A frame does not begin with the line FRAME.
    #[error("frame {frame} does not begin with a line FRAME")]
    Marker {
        /// The frame.
        frame: usize,
    },
    /// A second header states another rate, sampling, depth or range.
    #[error("the header before frame {frame} differs from the first header")]
    Differs {
        /// The frame.
        frame: usize,
    },
    /// A number is greater than its bits allow.
    #[error("frame {frame} has the number {value}, which needs more than 10 bits")]
    Number {
        /// The frame.
        frame: usize,
        /// The number.
        value: u16,
    },
    /// The planes are for another depth than the film has.
    #[error("the film has {bit_depth} bits for each number, which the planes do not have")]
    Depth {
        /// The bits of the film.
        bit_depth: u32,
    },
    /// The bytes could not be written.
    #[error("frame {frame} cannot be written: {source}")]
    Write {
        /// The frame.
        frame: usize,
        /// What the operating system said.
        source: io::Error,
    },
}
