//! Picture files of any known format.

use std::fmt;
use std::path::{Path, PathBuf};

use ga_files::{ReadError, WriteError};

use crate::picture::{Picture, PictureView};
use crate::{jpeg, pfm, png, pnm, y4m};

/// A format of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Portable Network Graphics.
    Png,
    /// JPEG. It is read; [`write()`] does not write it, since colours change.
    Jpeg,
    /// Portable grey map and portable pixel map, PGM and PPM.
    Pnm,
    /// Portable float map.
    Pfm,
    /// YUV4MPEG2, a film without compression.
    Y4m,
}

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

/// A picture that could not be written to a file.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    /// The picture has no form in the format.
    #[error("{}: {problem}", path.display())]
    Encode {
        /// The file.
        path: PathBuf,
        /// Why.
        problem: EncodeError,
    },
    /// The name of the file has no ending that stands for a format in which pictures are written.
    #[error("{}: the ending is not png, ppm, pgm, pnm or pfm", path.display())]
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// The file could not be written.
    #[error(transparent)]
    Write(#[from] WriteError),
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

/// Reads a picture; its format is known by its contents, whatever the name of the file. Of an
/// animation or a film it is the first frame.
///
/// ```
/// use ga_image::file;
/// use ga_image::plane::Plane;
///
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("ramp.png");
/// let ramp = Plane::from_fn(256, 2, |column, _| column as u8);
/// file::write(&path, &ramp)?;
/// assert_eq!(file::read(&path)?, ramp.into());
///
/// std::fs::write(&path, b"P5 40000 40000 255\n")?;
/// let message = file::read(&path).unwrap_err().to_string();
/// assert!(message.ends_with("the header claims 40000 × 40000 pixels, too many for 19 bytes"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`ReadError`], which names the file and says why: it cannot be opened, or a [`DecodeError`].
pub fn read(path: impl AsRef<Path>) -> Result<Picture, ReadError<DecodeError>> {
    ga_files::read(path, decode)
}

/// The picture in the bytes of a file of any known format; see [`read`].
///
/// # Errors
///
/// Any [`DecodeError`].
pub fn decode(bytes: &[u8]) -> Result<Picture, DecodeError> {
    match Format::detect(bytes) {
        Some(Format::Png) => png::decode(bytes),
        Some(Format::Jpeg) => jpeg::decode(bytes),
        Some(Format::Pnm) => pnm::decode(bytes),
        Some(Format::Pfm) => pfm::decode(bytes),
        Some(Format::Y4m) => y4m::decode_first(bytes),
        None => Err(DecodeError::UnknownFormat {
            start: bytes[..bytes.len().min(8)].to_vec(),
        }),
    }
}

/// Writes a picture, whole or not at all, in the format that the ending of the name stands for:
/// `png`, `ppm`, `pgm` and `pnm` (binary), or `pfm` (little endian).
///
/// # Errors
///
/// Any [`SaveError`].
pub fn write<'a>(
    path: impl AsRef<Path>,
    picture: impl Into<PictureView<'a>>,
) -> Result<(), SaveError> {
    let path = path.as_ref();
    let ending = path.extension().map(|e| e.to_ascii_lowercase());
    let encoded = match ending.as_ref().and_then(|e| e.to_str()) {
        Some("png") => png::encode(picture),
        Some("ppm" | "pgm" | "pnm") => pnm::encode(picture),
        Some("pfm") => pfm::encode(picture, pfm::ByteOrder::Little),
        _ => {
            return Err(SaveError::Ending {
                path: path.to_path_buf(),
            });
        }
    };
    save(path, encoded)
}

/// Writes what an encoder made.
pub(crate) fn save(path: &Path, encoded: Result<Vec<u8>, EncodeError>) -> Result<(), SaveError> {
    let bytes = encoded.map_err(|problem| SaveError::Encode {
        path: path.to_path_buf(),
        problem,
    })?;
    Ok(ga_files::write(path, &bytes)?)
}

/// Checks that a file of `length` bytes can hold the pixels, where one byte holds at most
/// `pixels_per_byte`. It is checked before memory for the pixels is taken. Returns their number.
pub(crate) fn check_claim(
    format: Format,
    [width, height]: [usize; 2],
    length: usize,
    pixels_per_byte: f64,
) -> Result<usize, DecodeError> {
    let claim = width as f64 * height as f64;
    match width.checked_mul(height) {
        Some(pixels) if claim <= length as f64 * pixels_per_byte => Ok(pixels),
        _ => Err(DecodeError::Claim {
            format,
            width,
            height,
            length,
        }),
    }
}

/// Columns and rows as `u32`, both at least 1.
pub(crate) fn size_for(
    format: Format,
    [width, height]: [usize; 2],
) -> Result<[u32; 2], EncodeError> {
    match [u32::try_from(width), u32::try_from(height)] {
        [Ok(columns), Ok(rows)] if columns > 0 && rows > 0 => Ok([columns, rows]),
        _ => Err(EncodeError::Size {
            format,
            width,
            height,
        }),
    }
}
