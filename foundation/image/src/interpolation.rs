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
/// # Ok::<(), ga_image::plane::PlaneError>(())
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

/// The weights of four neighbouring pixels at a part `t` from 0 to 1 of the way from the second to
/// the third, by cubic convolution: the splines of E. Catmull and R. Rom (1974), which R. G. Keys
/// found to be exact for polynomials of the second degree ("Cubic convolution interpolation for
/// digital image processing", 1981). Their sum is 1. In contrast to linear interpolation, fine
/// detail keeps most of its contrast.
///
/// ```
/// use ga_image::interpolation::cubic_weights;
///
/// assert_eq!(cubic_weights(0.5), [-0.0625, 0.5625, 0.5625, -0.0625]);
/// assert_eq!(cubic_weights(0.0), [0.0, 1.0, 0.0, 0.0]);
/// ```
#[must_use]
#[inline]
pub fn cubic_weights(t: f64) -> [f64; 4] {
    [
        ((2.0 - t) * t - 1.0) * t / 2.0,
        ((3.0 * t - 5.0) * t * t + 2.0) / 2.0,
        ((4.0 - 3.0 * t) * t + 1.0) * t / 2.0,
        (t - 1.0) * t * t / 2.0,
    ]
}

/// The weights of six neighbouring pixels at a part `t` from 0 to 1 of the way from the third to
/// the fourth, by Keys's cubic convolution of the fourth order, which is exact for polynomials of
/// the third degree. Their sum is 1. It keeps more of the finest detail than [`cubic_weights`].
///
/// ```
/// use ga_image::interpolation::six_cubic_weights;
///
/// // The cubes of −2 to 3, halfway from 0 to 1.
/// let cubes = [-8.0, -1.0, 0.0, 1.0, 8.0, 27.0];
/// let terms = six_cubic_weights(0.5).into_iter().zip(cubes).map(|(w, cube)| w * cube);
/// assert!((terms.sum::<f64>() - 0.125).abs() < 1e-12);
/// assert_eq!(six_cubic_weights(0.0), [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
/// ```
#[must_use]
#[inline]
pub fn six_cubic_weights(t: f64) -> [f64; 6] {
    // At distances up to one, two and three pixels, counted from the lower end of each.
    let near = |s: f64| (4.0 * s - 7.0) * s * s / 3.0 + 1.0;
    let middle = |s: f64| s * ((15.0 - 7.0 * s) * s - 8.0) / 12.0;
    let far = |s: f64| s * ((s - 2.0) * s + 1.0) / 12.0;
    let u = 1.0 - t;
    [far(t), middle(t), near(t), near(u), middle(u), far(u)]
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
