//! Pictures as PNG files.

use std::io::Cursor;
use std::path::Path;

use ga_files::WriteError;
use image::{ImageError, ImageFormat, RgbImage};

/// A picture that could not be written.
#[derive(Debug, thiserror::Error)]
pub enum PngError {
    /// The picture has no PNG form, for instance because it has no pixels.
    #[error("cannot encode the picture as PNG: {0}")]
    Encode(#[from] ImageError),
    /// The file could not be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// The bytes of a PNG file.
///
/// # Errors
///
/// [`PngError::Encode`].
pub fn encode(picture: &RgbImage) -> Result<Vec<u8>, PngError> {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png)?;
    Ok(bytes.into_inner())
}

/// Writes a PNG file, whole or not at all.
///
/// # Errors
///
/// Any [`PngError`].
///
/// # Examples
///
/// ```
/// use image::{Rgb, RgbImage};
///
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("red.png");
/// ga_image::png::write(&path, &RgbImage::from_pixel(3, 2, Rgb([255, 0, 0])))?;
/// assert_eq!(image::image_dimensions(&path)?, (3, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(path: impl AsRef<Path>, picture: &RgbImage) -> Result<(), PngError> {
    Ok(ga_files::write(path, &encode(picture)?)?)
}
