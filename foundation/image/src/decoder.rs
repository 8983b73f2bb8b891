//! TIFF, BMP and WebP files, read by the crate `image`.

use std::io::Cursor;

use image::codecs::bmp::BmpDecoder;
use image::codecs::tiff::TiffDecoder;
use image::codecs::webp::WebPDecoder;
use image::{DynamicImage, ImageDecoder, ImageError, Limits};

use crate::format::Format;
use crate::format_error::FormatError;
use crate::oriented::Oriented;
use crate::picture::Picture;
use crate::plane::Plane;

/// No picture takes more bytes than this: a few bytes of these formats may stand for any number of
/// pixels of one colour, so that the length of a file does not bound it.
const MOST_BYTES: u64 = 1 << 30;

/// The picture in the bytes of a file of one of these formats.
pub(crate) fn decode(format: Format, bytes: &[u8]) -> Result<Oriented, FormatError> {
    let source = || Cursor::new(bytes);
    let problem = |problem| FormatError::Decode { format, problem };
    match format {
        Format::Tiff => picture(format, TiffDecoder::new(source()).map_err(problem)?),
        Format::Bmp => picture(format, BmpDecoder::new(source()).map_err(problem)?),
        Format::WebP => picture(format, WebPDecoder::new(source()).map_err(problem)?),
        _ => Err(FormatError::UnknownFormat {
            start: bytes[..bytes.len().min(8)].to_vec(),
        }),
    }
}

fn picture(format: Format, mut decoder: impl ImageDecoder) -> Result<Oriented, FormatError> {
    let (width, height) = decoder.dimensions();
    let size = [width as usize, height as usize];
    if size.contains(&0) {
        return Err(FormatError::Size {
            format,
            width: size[0],
            height: size[1],
        });
    }
    let too_large = FormatError::TooLarge {
        format,
        width: size[0],
        height: size[1],
        most: MOST_BYTES,
    };
    if decoder.total_bytes() > MOST_BYTES {
        return Err(too_large);
    }
    let problem = |problem| match problem {
        ImageError::Limits(_) => None,
        problem => Some(FormatError::Decode { format, problem }),
    };
    let mut limits = Limits::default();
    // The picture, and what the decoder needs besides.
    limits.max_alloc = Some(2 * MOST_BYTES);
    let decoded = decoder.set_limits(limits).and_then(|()| {
        let orientation = decoder.orientation()?;
        Ok((DynamicImage::from_decoder(decoder)?, orientation))
    });
    let (decoded, orientation) = match decoded.map_err(problem) {
        Ok(decoded) => decoded,
        Err(problem) => return Err(problem.unwrap_or(too_large)),
    };
    let kind = decoded.color();
    let stored = of_dynamic(size, decoded).ok_or_else(|| FormatError::Unsupported {
        format,
        what: format!("{kind:?}"),
    })?;
    Ok(Oriented::new(stored, orientation))
}

/// A picture of the crate `image` with the same numbers; `None` for floats with alpha.
fn of_dynamic([width, height]: [usize; 2], decoded: DynamicImage) -> Option<Picture> {
    fn plane<T: Copy, const N: usize>(
        [width, height]: [usize; 2],
        samples: &[T],
    ) -> Option<Plane<[T; N]>> {
        Plane::from_values(width, height, samples.as_chunks::<N>().0.to_vec()).ok()
    }
    let size = [width, height];
    Some(match decoded {
        DynamicImage::ImageLuma8(grey) => Plane::from_values(width, height, grey.into_raw())
            .ok()?
            .into(),
        DynamicImage::ImageLuma16(grey) => Plane::from_values(width, height, grey.into_raw())
            .ok()?
            .into(),
        DynamicImage::ImageLumaA8(image) => plane::<_, 2>(size, image.as_raw())?.into(),
        DynamicImage::ImageRgb8(image) => plane::<_, 3>(size, image.as_raw())?.into(),
        DynamicImage::ImageRgba8(image) => plane::<_, 4>(size, image.as_raw())?.into(),
        DynamicImage::ImageLumaA16(image) => plane::<_, 2>(size, image.as_raw())?.into(),
        DynamicImage::ImageRgb16(image) => plane::<_, 3>(size, image.as_raw())?.into(),
        DynamicImage::ImageRgba16(image) => plane::<_, 4>(size, image.as_raw())?.into(),
        DynamicImage::ImageRgb32F(image) => plane::<_, 3>(size, image.as_raw())?.into(),
        _ => return None,
    })
}
