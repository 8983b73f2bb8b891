//! Writing films.

use std::borrow::Borrow;
use std::path::Path;

use super::{Film, Sampling};
use crate::format::Format;
use crate::format_error::FormatError;
use crate::plane::Plane;
use crate::save::{FileError, save};
use crate::size::size_for;
use crate::ycbcr::{Range, rounded};

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
    let mut first = None;
    for (index, frame) in frames.into_iter().enumerate() {
        let frame = frame.borrow();
        let size = [frame.width(), frame.height()];
        let expected = *first.get_or_insert(size);
        if size != expected {
            return Err(FormatError::FrameSize {
                frame: index,
                size,
                first: expected,
            });
        }
        if index == 0 {
            size_for(Format::Y4m, size)?;
            bytes.extend(header(size, 8, film).bytes());
        }
        bytes.extend(b"FRAME\n");
        add_frame(&mut bytes, frame, film);
    }
    match first {
        Some(_) => Ok(bytes),
        None => Err(FormatError::Frames {
            format: Format::Y4m,
            frames: 0,
        }),
    }
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

/// The first line of a film with numbers of this depth, with its end.
pub(super) fn header([width, height]: [usize; 2], bit_depth: u32, film: Film) -> String {
    let sampling = match (film.sampling, bit_depth) {
        // "jpeg" says that the differences lie in the middle of the square.
        (Sampling::Quarter, 8) => "420jpeg",
        (Sampling::Half, 8) => "422",
        (Sampling::Full, 8) => "444",
        (Sampling::Grey, 8) => "mono",
        (Sampling::Quarter, _) => "420p10",
        (Sampling::Half, _) => "422p10",
        (Sampling::Full, _) => "444p10",
        (Sampling::Grey, _) => "mono10",
    };
    let range = match film.colours.range {
        Range::Limited => "LIMITED",
        Range::Full => "FULL",
    };
    let [numerator, denominator] = film.frames_per_second;
    format!(
        "YUV4MPEG2 W{width} H{height} F{numerator}:{denominator} Ip A1:1 C{sampling} \
         XCOLORRANGE={range}\n"
    )
}

fn add_frame(bytes: &mut Vec<u8>, frame: &Plane<[u8; 3]>, film: Film) {
    let encoded = frame.map(|rgb| film.colours.encoded(rgb.map(f32::from)));
    bytes.extend(encoded.values().iter().map(|[y, ..]| rounded(*y)));
    let size = [frame.width(), frame.height()];
    let [width, height] = film.sampling.difference_size(size);
    if width * height == 0 {
        return;
    }
    let (across, down) = (size[0].div_ceil(width), size[1].div_ceil(height));
    for channel in [1, 2] {
        for row in 0..height {
            for column in 0..width {
                // A square at the border may have fewer pixels.
                let rows = (row * down..size[1]).take(down);
                let (mut sum, mut count) = (0.0, 0.0);
                for row in rows {
                    for pixel in encoded.row(row)[column * across..].iter().take(across) {
                        sum += pixel[channel];
                        count += 1.0;
                    }
                }
                bytes.push(rounded(sum / count));
            }
        }
    }
}
