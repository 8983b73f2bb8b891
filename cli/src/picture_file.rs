//! Picture files in which a command measures.

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
