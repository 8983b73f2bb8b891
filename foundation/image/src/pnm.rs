//! PGM and PPM, portable grey map and portable pixel map: P2 and P3 in text, P5 and P6 in bytes.

use std::fmt::Write;
use std::path::Path;

use crate::format::Format;
use crate::format_error::FormatError;
use crate::header::Header;
use crate::picture::{Picture, PictureView};
use crate::plane::{Plane, PlaneView};
use crate::png::{big_endian, bytes_of};
use crate::sample::{Pixel, Sample, spread_to_16_bits};
use crate::save::{FileError, save};
use crate::size::{check_claim, size_for};

/// The picture in the bytes of a PGM or PPM file: 8 bits for each channel where the greatest number
/// of its header is at most 255, else 16. That number becomes white; where it is not 255 or 65535,
/// the others are scaled with it and rounded.
///
/// # Errors
///
/// [`FormatError::Syntax`] with the byte that is wrong, and [`FormatError::Claim`] when the file is
/// shorter than its header states.
pub fn decode(bytes: &[u8]) -> Result<Picture, FormatError> {
    let mut header = Header::new(Format::Pnm, bytes);
    let kind = header.magic()?;
    let size = [header.number()?, header.number()?];
    let greatest = header.number()?;
    let white = match u16::try_from(greatest) {
        Ok(white) if white > 0 => white,
        _ => return Err(header.error("the greatest number is not between 1 and 65535")),
    };
    match (kind, white > 255) {
        (b'2' | b'5', false) => plane::<u8>(kind, size, white, header),
        (b'2' | b'5', true) => plane::<u16>(kind, size, white, header),
        (b'3' | b'6', false) => plane::<[u8; 3]>(kind, size, white, header),
        (b'3' | b'6', true) => plane::<[u16; 3]>(kind, size, white, header),
        _ => Err(FormatError::Unsupported {
            format: Format::Pnm,
            what: format!("P{}", char::from(kind)),
        }),
    }
}

/// The bytes of a PGM file (P5) for a picture in grey, of a PPM file (P6) for one in colour.
///
/// # Errors
///
/// [`FormatError::Kind`] for pictures of floats or with alpha, [`FormatError::Size`] when there are
/// no pixels.
///
/// # Examples
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::pnm;
///
/// let picture = Plane::filled(1, 2, [1u8, 2, 3]);
/// assert_eq!(pnm::encode(&picture)?, b"P6\n1 2\n255\n\x01\x02\x03\x01\x02\x03");
/// assert_eq!(pnm::decode(b"P3 1 2 255 1 2 3 # the second row\n1 2 3")?, picture.into());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode<'a>(picture: impl Into<PictureView<'a>>) -> Result<Vec<u8>, FormatError> {
    let picture = picture.into();
    let mut bytes = header(&picture, ['5', '6'])?.into_bytes();
    bytes.extend(match &picture {
        PictureView::Grey8(view) => bytes_of(view),
        PictureView::Rgb8(view) => bytes_of(view),
        PictureView::Grey16(view) => big_endian(view),
        PictureView::Rgb16(view) => big_endian(view),
        _ => Vec::new(),
    });
    Ok(bytes)
}

/// As [`encode`], with the numbers as text (P2 and P3).
///
/// # Errors
///
/// As [`encode`].
pub fn encode_text<'a>(picture: impl Into<PictureView<'a>>) -> Result<String, FormatError> {
    let picture = picture.into();
    let mut text = header(&picture, ['2', '3'])?;
    match &picture {
        PictureView::Grey8(view) => add_text(&mut text, view),
        PictureView::Rgb8(view) => add_text(&mut text, view),
        PictureView::Grey16(view) => add_text(&mut text, view),
        PictureView::Rgb16(view) => add_text(&mut text, view),
        _ => {}
    }
    Ok(text)
}

/// Writes a PGM or PPM file in bytes, whole or not at all.
///
/// # Errors
///
/// Any [`FileError`].
pub fn write<'a>(
    path: impl AsRef<Path>,
    picture: impl Into<PictureView<'a>>,
) -> Result<(), FileError> {
    save(path.as_ref(), encode(picture))
}

fn header(picture: &PictureView<'_>, [grey, colour]: [char; 2]) -> Result<String, FormatError> {
    let [width, height] = size_for(Format::Pnm, [picture.width(), picture.height()])?;
    let (digit, white) = match picture {
        PictureView::Grey8(_) => (grey, 255),
        PictureView::Rgb8(_) => (colour, 255),
        PictureView::Grey16(_) => (grey, 65535),
        PictureView::Rgb16(_) => (colour, 65535),
        _ => {
            return Err(FormatError::Kind {
                format: Format::Pnm,
                kind: picture.kind(),
            });
        }
    };
    Ok(format!("P{digit}\n{width} {height}\n{white}\n"))
}

/// The format allows lines of 70 characters.
fn add_text<P: Pixel<Sample: std::fmt::Display>>(text: &mut String, view: &PlaneView<'_, P>) {
    for row in view.rows() {
        for samples in P::samples(row).chunks(11) {
            for sample in samples {
                // Writing to a string does not fail.
                let _ = write!(text, "{sample} ");
            }
            text.pop();
            text.push('\n');
        }
    }
}

/// An integer sample, from bytes and from text.
trait Stored: Sample {
    const BYTES: usize;

    /// The sample of its bytes, of which there are `BYTES`.
    fn of_bytes(bytes: &[u8]) -> u16;

    /// The sample at `value` of `white`.
    fn scaled(value: u16, white: u16) -> Self;
}

impl Stored for u8 {
    const BYTES: usize = 1;

    fn of_bytes(bytes: &[u8]) -> u16 {
        bytes.first().map_or(0, |byte| u16::from(*byte))
    }

    fn scaled(value: u16, white: u16) -> Self {
        ((u32::from(value) * 255 + u32::from(white) / 2) / u32::from(white)) as Self
    }
}

impl Stored for u16 {
    const BYTES: usize = 2;

    fn of_bytes(bytes: &[u8]) -> u16 {
        bytes
            .first_chunk()
            .map_or(0, |pair| Self::from_be_bytes(*pair))
    }

    fn scaled(value: u16, white: u16) -> Self {
        spread_to_16_bits(value, white)
    }
}

fn plane<P: Pixel<Sample: Stored>>(
    kind: u8,
    [width, height]: [usize; 2],
    white: u16,
    mut header: Header<'_>,
) -> Result<Picture, FormatError>
where
    Picture: From<Plane<P>>,
{
    let is_text = matches!(kind, b'2' | b'3');
    let data = header.data()?;
    // In text a sample takes a digit and, but for the last, a white space.
    let (length, bytes_a_sample) = if is_text {
        (data.len() + 1, 2)
    } else {
        (data.len(), P::Sample::BYTES)
    };
    let pixels_per_byte = 1.0 / (bytes_a_sample * P::CHANNELS) as f64;
    check_claim(Format::Pnm, [width, height], length, pixels_per_byte).map_err(|_| {
        FormatError::Claim {
            format: Format::Pnm,
            width,
            height,
            length: header.length(),
        }
    })?;
    let mut plane = Plane::filled(width, height, P::default());
    let samples = P::samples_mut(plane.values_mut());
    if is_text {
        for sample in samples {
            let value = u16::try_from(header.number()?).ok();
            let value = value.filter(|value| *value <= white);
            *sample = P::Sample::scaled(value.ok_or_else(|| too_large(&header))?, white);
        }
    } else {
        for (sample, bytes) in samples.iter_mut().zip(data.chunks_exact(P::Sample::BYTES)) {
            let value = P::Sample::of_bytes(bytes);
            if value > white {
                return Err(too_large(&header));
            }
            *sample = P::Sample::scaled(value, white);
        }
    }
    Ok(plane.into())
}

fn too_large(header: &Header<'_>) -> FormatError {
    header.error("a sample is greater than the greatest number of the header")
}
