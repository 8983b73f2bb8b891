//! Pictures as the bytes of a PNG file.

use png::{BitDepth, ColorType, Encoder, Filter};

use crate::format::Format;
use crate::format_error::FormatError;
use crate::picture::PictureView;
use crate::plane::PlaneView;
use crate::sample::Pixel;
use crate::size::size_for;

/// The bytes of a PNG file.
///
/// # Errors
///
/// [`FormatError::Kind`] for pictures of floats, [`FormatError::Size`] when there are no pixels.
///
/// # Examples
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::png;
///
/// let deep = Plane::from_fn(300, 200, |column, row| [(200 * column) as u16, row as u16, 9]);
/// assert_eq!(png::decode(&png::encode(&deep)?)?, deep.into());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode<'a>(picture: impl Into<PictureView<'a>>) -> Result<Vec<u8>, FormatError> {
    encode_view(&picture.into())
}

/// Beside [`encode`], which is compiled where it is called, so that this is compiled once.
fn encode_view(picture: &PictureView<'_>) -> Result<Vec<u8>, FormatError> {
    let (colour, depth) = kind(picture)?;
    let [width, height] = size_for(Format::Png, [picture.width(), picture.height()])?;
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    encoder.set_filter(Filter::Adaptive);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&raw(picture))?;
    writer.finish()?;
    Ok(bytes)
}

/// The bytes of a PNG file with a palette: each pixel is the index of a colour.
///
/// # Errors
///
/// [`FormatError::Palette`] when there are not 1 to 256 colours or a pixel names none of them,
/// [`FormatError::Size`] when there are no pixels.
///
/// # Examples
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::png;
///
/// let indices = Plane::from_fn(4, 4, |column, row| ((column + row) % 2) as u8);
/// let bytes = png::encode_indexed(&indices, &[[255, 0, 0], [0, 0, 128]])?;
/// assert_eq!(png::decode(&bytes)?.to_rgb().get(1, 0), Some([0u8, 0, 128]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode_indexed<'a>(
    indices: impl Into<PlaneView<'a, u8>>,
    palette: &[[u8; 3]],
) -> Result<Vec<u8>, FormatError> {
    let indices = indices.into();
    let [width, height] = size_for(Format::Png, [indices.width(), indices.height()])?;
    let index = indices.rows().flatten().copied().max().unwrap_or(0);
    if usize::from(index) >= palette.len() || palette.len() > 256 {
        return Err(FormatError::Palette {
            index,
            colours: palette.len(),
        });
    }
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(ColorType::Indexed);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_palette(palette.as_flattened());
    // Neighbouring indices are not neighbouring colours.
    encoder.set_filter(Filter::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&indices.rows().collect::<Vec<_>>().concat())?;
    writer.finish()?;
    Ok(bytes)
}

/// How PNG names a kind of pixel.
pub(super) fn kind(picture: &PictureView<'_>) -> Result<(ColorType, BitDepth), FormatError> {
    Ok(match picture {
        PictureView::Grey8(_) => (ColorType::Grayscale, BitDepth::Eight),
        PictureView::GreyAlpha8(_) => (ColorType::GrayscaleAlpha, BitDepth::Eight),
        PictureView::Rgb8(_) => (ColorType::Rgb, BitDepth::Eight),
        PictureView::Rgba8(_) => (ColorType::Rgba, BitDepth::Eight),
        PictureView::Grey16(_) => (ColorType::Grayscale, BitDepth::Sixteen),
        PictureView::GreyAlpha16(_) => (ColorType::GrayscaleAlpha, BitDepth::Sixteen),
        PictureView::Rgb16(_) => (ColorType::Rgb, BitDepth::Sixteen),
        PictureView::Rgba16(_) => (ColorType::Rgba, BitDepth::Sixteen),
        PictureView::GreyF32(_) | PictureView::RgbF32(_) => {
            return Err(FormatError::Kind {
                format: Format::Png,
                kind: picture.kind(),
            });
        }
    })
}

/// The samples as PNG orders them: rows without gaps, 16 bits with the high byte first.
pub(super) fn raw(picture: &PictureView<'_>) -> Vec<u8> {
    match picture {
        PictureView::Grey8(view) => bytes_of(view),
        PictureView::GreyAlpha8(view) => bytes_of(view),
        PictureView::Rgb8(view) => bytes_of(view),
        PictureView::Rgba8(view) => bytes_of(view),
        PictureView::Grey16(view) => big_endian(view),
        PictureView::GreyAlpha16(view) => big_endian(view),
        PictureView::Rgb16(view) => big_endian(view),
        PictureView::Rgba16(view) => big_endian(view),
        PictureView::GreyF32(_) | PictureView::RgbF32(_) => Vec::new(),
    }
}

/// The samples, row by row.
pub(crate) fn bytes_of<P: Pixel<Sample = u8>>(view: &PlaneView<'_, P>) -> Vec<u8> {
    let rows: Vec<&[u8]> = view.rows().map(P::samples).collect();
    rows.concat()
}

/// The samples, row by row, each with its high byte first.
pub(crate) fn big_endian<P: Pixel<Sample = u16>>(view: &PlaneView<'_, P>) -> Vec<u8> {
    let samples = view.rows().flat_map(P::samples);
    samples.flat_map(|sample| sample.to_be_bytes()).collect()
}
