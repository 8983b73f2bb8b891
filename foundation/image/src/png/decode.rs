//! The bytes of a PNG file as a picture.

use std::io::Cursor;

use png::{BitDepth, ColorType, Decoder, Transformations};

use crate::format::Format;
use crate::format_error::FormatError;
use crate::oriented::Oriented;
use crate::picture::Picture;
use crate::plane::Plane;
use crate::size::check_claim;

/// Deflate makes at most 258 bytes of two bits, so at most 1,032 bytes of one.
const BYTES_FROM_ONE: f64 = 1032.0;

/// The picture in the bytes of a PNG file. Palettes become colours, depths below 8 bits become 8
/// bits, a transparent colour becomes an alpha channel. Of an animation it is the default image.
/// The orientation that its Exif metadata note is applied; gamma and colour profiles are not.
///
/// # Errors
///
/// [`FormatError::PngDecode`] with what is wrong, and [`FormatError::Claim`] when the header states
/// more pixels than the bytes can hold.
pub fn decode(bytes: &[u8]) -> Result<Picture, FormatError> {
    Ok(decode_oriented(bytes)?.picture)
}

/// The picture, and the orientation that was applied.
pub(crate) fn decode_oriented(bytes: &[u8]) -> Result<Oriented, FormatError> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let header = decoder.read_header_info()?;
    let size = [header.width as usize, header.height as usize];
    let bits = header.color_type.samples() * header.bit_depth as usize;
    check_claim(
        Format::Png,
        size,
        bytes.len(),
        BYTES_FROM_ONE * 8.0 / bits as f64,
    )?;
    let mut reader = decoder.read_info()?;
    let (colour, depth) = reader.output_color_type();
    let length = reader.output_buffer_size().ok_or(FormatError::Claim {
        format: Format::Png,
        width: size[0],
        height: size[1],
        length: bytes.len(),
    })?;
    let mut data = vec![0; length];
    let frame = reader.next_frame(&mut data)?;
    data.truncate(frame.buffer_size());
    // The metadata may follow the pixels. What is wrong behind the pixels does not change them.
    let _ = reader.finish();
    let exif = reader.info().exif_metadata.clone();
    let stored = match (colour, depth) {
        (ColorType::Grayscale, BitDepth::Eight) => picture(size, data),
        (ColorType::GrayscaleAlpha, BitDepth::Eight) => picture(size, pixels::<_, 2>(&data)),
        (ColorType::Rgb, BitDepth::Eight) => picture(size, pixels::<_, 3>(&data)),
        (ColorType::Rgba, BitDepth::Eight) => picture(size, pixels::<_, 4>(&data)),
        (ColorType::Grayscale, BitDepth::Sixteen) => picture(size, words(&data)),
        (ColorType::GrayscaleAlpha, BitDepth::Sixteen) => {
            picture(size, pixels::<_, 2>(&words(&data)))
        }
        (ColorType::Rgb, BitDepth::Sixteen) => picture(size, pixels::<_, 3>(&words(&data))),
        (ColorType::Rgba, BitDepth::Sixteen) => picture(size, pixels::<_, 4>(&words(&data))),
        _ => Err(FormatError::Unsupported {
            format: Format::Png,
            what: format!("{colour:?} with {depth:?} bits"),
        }),
    };
    Ok(Oriented::by_exif(stored?, exif.as_deref()))
}

fn picture<P: Copy>([width, height]: [usize; 2], values: Vec<P>) -> Result<Picture, FormatError>
where
    Picture: From<Plane<P>>,
{
    // The decoder fills the whole picture or fails.
    Plane::from_values(width, height, values)
        .map(Picture::from)
        .map_err(|_| FormatError::Syntax {
            format: Format::Png,
            offset: 0,
            problem: "the default image does not fill the picture",
        })
}

fn pixels<T: Copy, const N: usize>(samples: &[T]) -> Vec<[T; N]> {
    samples.as_chunks().0.to_vec()
}

fn words(bytes: &[u8]) -> Vec<u16> {
    let (words, _) = bytes.as_chunks();
    words.iter().copied().map(u16::from_be_bytes).collect()
}
