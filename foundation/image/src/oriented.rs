//! Upright pictures, as files are read.

use crate::orientation::Orientation;
use crate::picture::Picture;

/// A picture that is upright, and what was done to the pixels of its file for that.
#[derive(Clone, Debug, PartialEq)]
pub struct Oriented {
    /// The picture.
    pub picture: Picture,
    /// What was applied: the orientation of Exif's tag 274, which is also that of TIFF.
    pub applied: Orientation,
}

impl Oriented {
    /// A picture whose file notes no orientation.
    pub(crate) fn upright(picture: Picture) -> Self {
        Self {
            picture,
            applied: Orientation::NoTransforms,
        }
    }

    /// Applies an orientation to the pixels of a file.
    pub(crate) fn new(stored: Picture, orientation: Orientation) -> Self {
        Self {
            picture: match orientation {
                Orientation::NoTransforms => stored,
                _ => stored.oriented(orientation),
            },
            applied: orientation,
        }
    }

    /// Applies the orientation that Exif metadata note, where there are any.
    pub(crate) fn by_exif(stored: Picture, exif: Option<&[u8]>) -> Self {
        let noted = exif.and_then(Orientation::from_exif_chunk);
        Self::new(stored, noted.unwrap_or(Orientation::NoTransforms))
    }

    /// What was done to the pixels of the file, in words, such as `rotated by 90° clockwise`;
    /// `None` for nothing.
    #[must_use]
    pub fn change(&self) -> Option<&'static str> {
        match self.applied {
            Orientation::NoTransforms => None,
            Orientation::Rotate90 => Some("rotated by 90° clockwise"),
            Orientation::Rotate180 => Some("rotated by 180°"),
            Orientation::Rotate270 => Some("rotated by 90° anticlockwise"),
            Orientation::FlipHorizontal => Some("mirrored, left for right"),
            Orientation::FlipVertical => Some("mirrored, top for bottom"),
            Orientation::Rotate90FlipH => Some("mirrored, rows for columns"),
            Orientation::Rotate270FlipH => Some("mirrored, rows for columns, and rotated by 180°"),
        }
    }
}
