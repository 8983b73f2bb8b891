//! PFM, portable float map: grey or RGB as 32-bit floats, rows from the bottom upwards.

use std::path::Path;

use crate::format::Format;
use crate::format_error::FormatError;
use crate::header::Header;
use crate::picture::{Picture, PictureView};
use crate::plane::Plane;
use crate::sample::Pixel;
use crate::save::{FileError, save};
use crate::size::{check_claim, size_for};

/// The order of the four bytes of a float.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ByteOrder {
    /// The lowest byte first.
    Little,
    /// The highest byte first.
    Big,
}

/// The picture in the bytes of a PFM file. Floats are returned as they are, infinities and NaN
/// included; the scale of the header is not applied, apart from its sign, which tells the order of
/// the bytes. The lines of the header may end in CR LF.
///
/// # Errors
///
/// [`FormatError::Syntax`] with the byte that is wrong, and [`FormatError::Claim`] or
/// [`FormatError::Length`] when the file is shorter or longer than its header states.
pub fn decode(bytes: &[u8]) -> Result<Picture, FormatError> {
    let mut header = Header::new(Format::Pfm, bytes);
    let colour = match header.magic()? {
        b'F' => true,
        b'f' => false,
        _ => return Err(header.error("a PFM file begins with PF or Pf")),
    };
    let width = header.number()?;
    let height = header.number()?;
    let order = match header.float()? {
        scale if scale < 0.0 => ByteOrder::Little,
        scale if scale > 0.0 => ByteOrder::Big,
        _ => return Err(header.error("the scale is neither positive nor negative")),
    };
    let size = [width, height];
    let pixels = check_claim(Format::Pfm, size, header.length(), 1.0)?;
    let expected = pixels.saturating_mul(if colour { 12 } else { 4 });
    let data = header.data_of(expected)?;
    if data.len() != expected {
        return Err(FormatError::Length {
            format: Format::Pfm,
            width,
            height,
            expected,
            found: data.len(),
        });
    }
    let floats = data.as_chunks::<4>().0.iter().map(|bytes| match order {
        ByteOrder::Little => f32::from_le_bytes(*bytes),
        ByteOrder::Big => f32::from_be_bytes(*bytes),
    });
    Ok(if colour {
        filled::<[f32; 3]>(width, height, floats).into()
    } else {
        filled::<f32>(width, height, floats).into()
    })
}

/// The bytes of a PFM file.
///
/// # Errors
///
/// [`FormatError::Kind`] unless the pixels are floats or triples of floats, and
/// [`FormatError::Size`] when there are none.
///
/// # Examples
///
/// ```
/// use ga_image::pfm::{self, ByteOrder};
/// use ga_image::plane::Plane;
///
/// let depth = Plane::from_values(1, 2, vec![0.25, f32::INFINITY])?;
/// let bytes = pfm::encode(&depth, ByteOrder::Big)?;
/// assert_eq!(bytes, b"Pf\n1 2\n1.0\n\x7f\x80\0\0\x3e\x80\0\0");
/// assert_eq!(pfm::decode(&bytes)?, depth.into());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode<'a>(
    picture: impl Into<PictureView<'a>>,
    order: ByteOrder,
) -> Result<Vec<u8>, FormatError> {
    let picture = picture.into();
    let [width, height] = size_for(Format::Pfm, [picture.width(), picture.height()])?;
    let scale = match order {
        ByteOrder::Little => "-1.0",
        ByteOrder::Big => "1.0",
    };
    let (letter, rows): (_, Vec<&[f32]>) = match &picture {
        PictureView::GreyF32(view) => ('f', view.rows().collect()),
        PictureView::RgbF32(view) => ('F', view.rows().map(<[f32; 3]>::samples).collect()),
        _ => {
            return Err(FormatError::Kind {
                format: Format::Pfm,
                kind: picture.kind(),
            });
        }
    };
    let mut bytes = format!("P{letter}\n{width} {height}\n{scale}\n").into_bytes();
    let samples: usize = rows.iter().map(|row| row.len()).sum();
    bytes.reserve_exact(samples * size_of::<f32>());
    let upwards = rows.into_iter().rev().flatten();
    bytes.extend(upwards.flat_map(|value| match order {
        ByteOrder::Little => value.to_le_bytes(),
        ByteOrder::Big => value.to_be_bytes(),
    }));
    Ok(bytes)
}

/// Writes a PFM file with the lowest byte first, whole or not at all.
///
/// # Errors
///
/// Any [`FileError`].
pub fn write<'a>(
    path: impl AsRef<Path>,
    picture: impl Into<PictureView<'a>>,
) -> Result<(), FileError> {
    save(path.as_ref(), encode(picture, ByteOrder::Little))
}

/// A plane of samples that come row by row from the bottom; their number has been checked.
fn filled<P: Pixel<Sample = f32>>(
    width: usize,
    height: usize,
    mut samples: impl Iterator<Item = f32>,
) -> Plane<P> {
    let mut plane = Plane::filled(width, height, P::default());
    for row in plane.view_mut().rows_mut().rev() {
        for (to, from) in P::samples_mut(row).iter_mut().zip(&mut samples) {
            *to = from;
        }
    }
    plane
}
