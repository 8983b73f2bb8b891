//! How views lie to each other.

use super::super::geometry::Geometry;

/// By how many rows points are lower in the right view than in the left one, over the picture.
///
/// At a place that is x columns right of the middle and y rows below it, the difference is
/// `shift − x tan(rotation) + y zoom / 100` where pixels are square.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Alignment {
    /// In the middle, in rows.
    pub shift_px: f64,
    /// The angle by which the right view is rotated counter-clockwise, in degrees.
    pub rotation_degrees: f64,
    /// By how many per cent the right view is larger.
    pub zoom_percent: f64,
}

impl From<&Geometry> for Alignment {
    fn from(geometry: &Geometry) -> Self {
        Self {
            shift_px: geometry.shift_px,
            rotation_degrees: geometry.rotation_degrees,
            zoom_percent: geometry.zoom_percent,
        }
    }
}

impl Alignment {
    /// What is seen of it by rows and columns of pixels that are this many times as high as wide:
    /// the lines that a rotation leans then lean by another angle.
    pub(in crate::comfort) fn in_pixels(self, pixel_height: f64) -> Self {
        let slope = self.rotation_degrees.to_radians().tan() / pixel_height;
        Self {
            rotation_degrees: slope.atan().to_degrees(),
            ..self
        }
    }

    pub(super) fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// The difference of heights at a place relative to the middle, in pixels.
    pub(super) fn difference(&self, [x, y]: [f64; 2]) -> f64 {
        self.shift_px - x * self.rotation_degrees.to_radians().tan() + 0.01 * y * self.zoom_percent
    }
}
