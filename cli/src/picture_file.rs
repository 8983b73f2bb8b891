//! Picture files in which a command measures, and the sizes of pictures.

use std::path::Path;

use anyhow::Result;
use ga_image::file;
use ga_image::picture::Picture;

use crate::frame::{Warning, warn};

/// Reads a picture. Where its file notes how the camera was held, the pixels are not those of the
/// sensor in their order, which the user is told: the parameters of a camera must be for the same
/// orientation.
pub(crate) fn read(path: &Path) -> Result<Picture> {
    let read = file::read_oriented(path)?;
    if let Some(change) = read.change() {
        let [width, height] = [read.picture.width(), read.picture.height()];
        let message = format!(
            "the picture is {change}, as the orientation in its metadata says: {width} × {height} \
             pixels; a camera that is used with it must be for pictures in this orientation"
        );
        warn(Warning::new("orientation_applied", message).in_file(path));
    }
    Ok(read.picture)
}

/// The width and height of pictures, such as `800x600`.
pub(crate) fn picture_size(text: &str) -> Result<[usize; 2], String> {
    let side = |word: &str| word.trim().parse::<u16>().ok().filter(|&side| side > 0);
    let sides = text.split_once(['x', 'X', '×']);
    let sides = sides.and_then(|(width, height)| Some([side(width)?, side(height)?]));
    let sides = sides.ok_or("a size is two numbers from 1 to 65535, such as 1280x720");
    Ok(sides?.map(usize::from))
}

#[cfg(test)]
mod tests {
    use super::picture_size;

    #[test]
    fn sizes_are_two_numbers() {
        for text in ["1280x720", "1280X720", "1280×720", " 1280 x 720 "] {
            assert_eq!(picture_size(text), Ok([1280, 720]), "{text}");
        }
        assert_eq!(picture_size("1x65535"), Ok([1, 65535]));
        for wrong in [
            "", "80", "x", "0x5", "5x0", "-5x5", "1.5x2", "65536x1", "2x3x4",
        ] {
            assert!(picture_size(wrong).is_err(), "{wrong}");
        }
    }
}
