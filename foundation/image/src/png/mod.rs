//! PNG files: pictures with 8 or 16 bits for each channel, palettes, animations.

mod animation;
mod decode;
mod encode;

use std::path::Path;

pub(crate) use animation::AnimationWriter;
pub use animation::{Animation, encode_animation};
pub use decode::decode;
pub(crate) use decode::decode_oriented;
pub(crate) use encode::{big_endian, bytes_of};
pub use encode::{encode, encode_indexed};

use crate::picture::PictureView;
use crate::save::{FileError, save};

/// Writes a PNG file, whole or not at all.
///
/// # Errors
///
/// Any [`FileError`].
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
pub fn write<'a>(
    path: impl AsRef<Path>,
    picture: impl Into<PictureView<'a>>,
) -> Result<(), FileError> {
    save(path.as_ref(), encode(picture))
}
