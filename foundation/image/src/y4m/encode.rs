//! Writing films.

use std::borrow::Borrow;
use std::path::Path;

use super::Film;
use super::writer::Writer;
use crate::format::Format;
use crate::format_error::FormatError;
use crate::plane::Plane;
use crate::save::{FileError, save};

/// The bytes of a film of these frames, which may be borrowed, or made one after another by an
/// iterator.
///
/// # Errors
///
/// [`FormatError::Frames`] when there are none, [`FormatError::Size`] when they have no pixels,
/// [`FormatError::FrameSize`] when a frame differs in size from the first.
///
/// # Examples
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{self, Film, Reader};
///
/// let frames = (0..3u8).map(|i| Plane::filled(4, 2, [80 * i; 3]));
/// let bytes = y4m::encode(frames, Film::default())?;
/// assert!(bytes.starts_with(b"YUV4MPEG2 W4 H2 F25:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n"));
/// let last = Reader::new(&bytes)?.last().unwrap()?;
/// assert_eq!(last.to_rgb(Film::default().colours).get(0, 0), Some([160; 3]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode<F: Borrow<Plane<[u8; 3]>>>(
    frames: impl IntoIterator<Item = F>,
    film: Film,
) -> Result<Vec<u8>, FormatError> {
    let mut bytes = Vec::new();
    let mut frames = frames.into_iter();
    let first = frames.next().ok_or(FormatError::Frames {
        format: Format::Y4m,
        frames: 0,
    })?;
    let size = [first.borrow().width(), first.borrow().height()];
    let mut writer = Writer::new(&mut bytes, size, 8, film)?;
    writer.write_rgb(first.borrow())?;
    for frame in frames {
        writer.write_rgb(frame.borrow())?;
    }
    Ok(bytes)
}

/// Writes a film, whole or not at all.
///
/// # Errors
///
/// Any [`FileError`].
pub fn write<F: Borrow<Plane<[u8; 3]>>>(
    path: impl AsRef<Path>,
    frames: impl IntoIterator<Item = F>,
    film: Film,
) -> Result<(), FileError> {
    save(path.as_ref(), encode(frames, film))
}
