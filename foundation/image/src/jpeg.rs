//! JPEG files, read by the crate `zune-jpeg` and written by the crate `image`.

use image::ExtendedColorType;
use image::codecs::jpeg::JpegEncoder;
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

use crate::format::Format;
use crate::format_error::FormatError;
use crate::oriented::Oriented;
use crate::picture::Picture;
use crate::plane::{Plane, PlaneView};
use crate::size::{check_claim, size_for};

/// A block of 8 × 8 pixels takes at least one bit, in a progressive picture whose blocks are all
/// alike.
const PIXELS_FROM_ONE_BYTE: f64 = 512.0;

/// The picture in the bytes of a JPEG file, baseline or progressive: grey where it has one
/// component, else red, green and blue. The orientation that its Exif metadata note is applied;
/// colour profiles are not.
///
/// # Errors
///
/// [`FormatError::JpegDecode`] with what is wrong, and [`FormatError::Claim`] when the header
/// states more pixels than the bytes can hold.
pub fn decode(bytes: &[u8]) -> Result<Picture, FormatError> {
    Ok(decode_oriented(bytes)?.picture)
}

/// The picture, and the orientation that was applied.
pub(crate) fn decode_oriented(bytes: &[u8]) -> Result<Oriented, FormatError> {
    let options = DecoderOptions::new_safe()
        .set_strict_mode(true)
        .set_max_width(usize::from(u16::MAX))
        .set_max_height(usize::from(u16::MAX));
    let mut headers = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    headers.decode_headers()?;
    let (Some((width, height)), Some(colours)) = (headers.dimensions(), headers.input_colorspace())
    else {
        return Err(FormatError::Syntax {
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
    let picture = picture.map_err(|_| FormatError::Syntax {
        format: Format::Jpeg,
        offset: 0,
        problem: "the decoded pixels do not fill the picture",
    })?;
    Ok(Oriented::by_exif(
        picture,
        headers.exif().map(Vec::as_slice),
    ))
}

/// The bytes of a baseline JPEG file. The quality, from 1 to 100, is that of the tables of the
/// Independent JPEG Group. Colours change, so that this is for pictures that people look at.
///
/// ```
/// use ga_image::jpeg;
/// use ga_image::plane::Plane;
///
/// let even = Plane::filled(20, 10, [200u8, 100, 50]);
/// let read = jpeg::decode(&jpeg::encode(&even, 90)?)?.to_rgb::<u8>();
/// let close = |[a, b]: [u8; 2]| a.abs_diff(b) <= 3;
/// let pixels = read.values().iter().zip(even.values());
/// assert!(pixels.flat_map(|(a, b)| [0, 1, 2].map(|k| [a[k], b[k]])).all(close));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`FormatError::Size`] when there are no pixels, or more than 65535 columns or rows.
pub fn encode<'a>(
    picture: impl Into<PlaneView<'a, [u8; 3]>>,
    quality: u8,
) -> Result<Vec<u8>, FormatError> {
    encode_view(picture.into(), quality)
}

/// Beside [`encode`], which is compiled where it is called, so that this is compiled once.
fn encode_view(picture: PlaneView<'_, [u8; 3]>, quality: u8) -> Result<Vec<u8>, FormatError> {
    let [width, height] = [picture.width(), picture.height()];
    if width.max(height) > usize::from(u16::MAX) {
        return Err(FormatError::Size {
            format: Format::Jpeg,
            width,
            height,
        });
    }
    let [width, height] = size_for(Format::Jpeg, [width, height])?;
    let pixels = picture.to_plane();
    let mut bytes = Vec::new();
    JpegEncoder::new_with_quality(&mut bytes, quality.clamp(1, 100)).encode(
        pixels.values().as_flattened(),
        width,
        height,
        ExtendedColorType::Rgb8,
    )?;
    Ok(bytes)
}
