//! The size of a picture whose file of cameras does not state it.

use std::path::Path;

use image::{ImageDecoder, ImageReader, ImageResult, metadata::Orientation};

use super::error::{CameraFileError, Place};

/// Columns and rows of a picture as it is shown, of which no more than the head is read.
pub(super) fn picture_size(
    path: &Path,
    place: impl FnOnce() -> Place,
) -> Result<[usize; 2], CameraFileError> {
    of(path).map_err(|error| CameraFileError::PictureSize {
        place: place(),
        picture: path.into(),
        problem: error.to_string().replace(['\n', '\r'], " ").into(),
    })
}

fn of(path: &Path) -> ImageResult<[usize; 2]> {
    let reader = ImageReader::open(path)?.with_guessed_format()?;
    let mut decoder = reader.into_decoder()?;
    let (width, height) = decoder.dimensions();
    let is_turned = matches!(
        decoder.orientation()?,
        Orientation::Rotate90
            | Orientation::Rotate270
            | Orientation::Rotate90FlipH
            | Orientation::Rotate270FlipH
    );
    let size = [width as usize, height as usize];
    Ok(match is_turned {
        true => [size[1], size[0]],
        false => size,
    })
}
