//! Values between the centres of pixels.

use std::ops::{Add, Mul, Sub};

use crate::plane::PlaneView;

/// The value at a place between the centres of four pixels, interpolated linearly along both axes:
/// with parts *s* and *t* of the way to the next column and row, it is
/// `(1 − t) ((1 − s) a + s b) + t ((1 − s) c + s d)`.
///
/// Coordinates count from the centre of the first pixel, so that those of the pixel in column *c*
/// and row *r* are (*c*, *r*). `None` outside the rectangle through the outermost centres, and
/// where a coordinate is not a number. A pixel of weight 0 has no influence, whatever its value.
///
/// ```
/// use ga_image::interpolation::bilinear;
/// use ga_image::plane::Plane;
///
/// let picture = Plane::from_values(2, 2, vec![1.0_f32, 3.0, 5.0, 11.0])?;
/// assert_eq!(bilinear(&picture, [0.5, 0.0]), Some(2.0));
/// assert_eq!(bilinear(&picture, [0.5, 0.5]), Some(5.0));
/// assert_eq!(bilinear(&picture, [1.0, 1.0]), Some(11.0));
/// assert_eq!(bilinear(&picture, [1.1, 1.0]), None);
/// # Ok::<(), ga_image::plane::SizeError>(())
/// ```
#[must_use]
pub fn bilinear<'a>(picture: impl Into<PlaneView<'a, f32>>, [x, y]: [f64; 2]) -> Option<f64> {
    let picture = picture.into();
    let [last_column, last_row] = [picture.width(), picture.height()].map(|n| n.checked_sub(1));
    let (last_column, last_row) = (last_column?, last_row?);
    if !(x >= 0.0 && y >= 0.0 && x <= last_column as f64 && y <= last_row as f64) {
        return None;
    }
    let (column, row) = (x as usize, y as usize);
    let (right, below) = ((column + 1).min(last_column), (row + 1).min(last_row));
    let (upper, lower) = (picture.row(row), picture.row(below));
    let corners = [upper[column], upper[right], lower[column], lower[right]].map(f64::from);
    Some(mixed(corners, [x - column as f64, y - row as f64]))
}

/// The value between those of four pixels, by rows, at parts of the way to the right and down.
#[inline]
pub(crate) fn mixed<T>([a, b, c, d]: [T; 4], [right, down]: [T; 2]) -> T
where
    T: Copy + Default + PartialEq + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    // A pixel that has no part may be infinite.
    let between = |from: T, to: T, part: T| {
        if part == T::default() {
            from
        } else {
            from + (to - from) * part
        }
    };
    between(between(a, b, right), between(c, d, right), down)
}
