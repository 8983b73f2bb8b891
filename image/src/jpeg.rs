//! JPEG files, read by the crate `zune-jpeg`.

use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

use crate::file::{DecodeError, Format, check_claim};
use crate::picture::Picture;
use crate::plane::Plane;

/// A block of 8 × 8 pixels takes at least one bit, in a progressive picture whose blocks are all
/// alike.
const PIXELS_FROM_ONE_BYTE: f64 = 512.0;

/// The picture in the bytes of a JPEG file, baseline or progressive: grey where it has one
/// component, else red, green and blue. The orientation that a camera noted is not applied, nor are
/// colour profiles.
///
/// # Errors
///
/// [`DecodeError::Jpeg`] with what is wrong, and [`DecodeError::Claim`] when the header states more
/// pixels than the bytes can hold.
pub fn decode(bytes: &[u8]) -> Result<Picture, DecodeError> {
    let options = DecoderOptions::new_safe()
        .set_strict_mode(true)
        .set_max_width(usize::from(u16::MAX))
        .set_max_height(usize::from(u16::MAX));
    let mut headers = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    headers.decode_headers()?;
    let (Some((width, height)), Some(colours)) = (headers.dimensions(), headers.input_colorspace())
    else {
        return Err(DecodeError::Syntax {
            format: Format::Jpeg,
            offset: 0,
            problem: "there is no frame header",
        });
    };
    check_claim(
        Format::Jpeg,
        [width, height],
        bytes.len(),
        PIXELS_FROM_ONE_BYTE,
    )?;
    let wanted = if colours == ColorSpace::Luma {
        ColorSpace::Luma
    } else {
        ColorSpace::RGB
    };
    let options = options.jpeg_set_out_colorspace(wanted);
    let data = JpegDecoder::new_with_options(ZCursor::new(bytes), options).decode()?;
    let picture = if wanted == ColorSpace::Luma {
        Plane::from_values(width, height, data).map(Picture::from)
    } else {
        Plane::from_values(width, height, data.as_chunks::<3>().0.to_vec()).map(Picture::from)
    };
    picture.map_err(|_| DecodeError::Syntax {
        format: Format::Jpeg,
        offset: 0,
        problem: "the decoded pixels do not fill the picture",
    })
}
