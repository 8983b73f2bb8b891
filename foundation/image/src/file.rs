//! Picture files of any known format.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use ga_files::ReadError;

pub use crate::format::Format;
pub use crate::format_error::FormatError;
pub use crate::oriented::Oriented;
pub use crate::save::FileError;

use crate::picture::{Picture, PictureView};
use crate::save::save;
use crate::{decoder, jpeg, pfm, png, pnm, y4m};

/// Reads a picture; its format is known by its contents, whatever the name of the file. Of an
/// animation or a film it is the first frame, of a TIFF file the first picture.
///
/// The picture is upright: the orientation that the file notes is applied; [`read_oriented`] says
/// which one.
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
/// [`ReadError`], which names the file and says why: it cannot be opened, or a [`FormatError`].
pub fn read(path: impl AsRef<Path>) -> Result<Picture, ReadError<FormatError>> {
    ga_files::read(path, decode)
}

/// As [`read`], with the orientation that was applied, for what measures in pictures: the
/// parameters of a camera hold for pictures in one orientation only.
///
/// # Errors
///
/// As [`read`].
pub fn read_oriented(path: impl AsRef<Path>) -> Result<Oriented, ReadError<FormatError>> {
    ga_files::read(path, decode_oriented)
}

/// The format of a file by its beginning; `None` where it is of no known one.
///
/// # Errors
///
/// The file cannot be read.
pub fn detect(path: impl AsRef<Path>) -> io::Result<Option<Format>> {
    let mut start = Vec::new();
    File::open(path)?
        .take(Format::SIGNATURE as u64)
        .read_to_end(&mut start)?;
    Ok(Format::detect(&start))
}

/// The picture in the bytes of a file of any known format; see [`read`].
///
/// # Errors
///
/// Any [`FormatError`].
pub fn decode(bytes: &[u8]) -> Result<Picture, FormatError> {
    Ok(decode_oriented(bytes)?.picture)
}

/// The picture in the bytes of a file of any known format, and the orientation that was applied;
/// see [`read_oriented`].
///
/// # Errors
///
/// Any [`FormatError`].
pub fn decode_oriented(bytes: &[u8]) -> Result<Oriented, FormatError> {
    match Format::detect(bytes) {
        Some(Format::Png) => png::decode_oriented(bytes),
        Some(Format::Jpeg) => jpeg::decode_oriented(bytes),
        Some(format @ (Format::Tiff | Format::Bmp | Format::WebP)) => {
            decoder::decode(format, bytes)
        }
        Some(Format::Pnm) => pnm::decode(bytes).map(Oriented::upright),
        Some(Format::Pfm) => pfm::decode(bytes).map(Oriented::upright),
        Some(Format::Y4m) => y4m::decode_first(bytes).map(Oriented::upright),
        None => Err(FormatError::UnknownFormat {
            start: bytes[..bytes.len().min(8)].to_vec(),
        }),
    }
}

/// Writes a picture, whole or not at all, in the format that the ending of the name stands for:
/// `png`, `ppm`, `pgm` and `pnm` (binary), or `pfm` (little endian).
///
/// # Errors
///
/// Any [`FileError`].
pub fn write<'a>(
    path: impl AsRef<Path>,
    picture: impl Into<PictureView<'a>>,
) -> Result<(), FileError> {
    let path = path.as_ref();
    let ending = path.extension().map(|e| e.to_ascii_lowercase());
    let encoded = match ending.as_ref().and_then(|e| e.to_str()) {
        Some("png") => png::encode(picture),
        Some("ppm" | "pgm" | "pnm") => pnm::encode(picture),
        Some("pfm") => pfm::encode(picture, pfm::ByteOrder::Little),
        _ => {
            return Err(FileError::Unknown {
                path: path.to_path_buf(),
            });
        }
    };
    save(path, encoded)
}
