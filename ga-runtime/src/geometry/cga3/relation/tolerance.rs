//! Tolerances for comparing primitives.

use crate::scalar::{Mask, Optional, Real};
use crate::vga3::Vector;

/// The deviations that are ignored in comparisons: a distance in the units of the coordinates and
/// an angle in radians, both bounds included.
///
/// Results of a few operations on coordinates of size 1 have an error of some ε, the spacing of the
/// scalar at 1. The default allows 1024 ε of distance and of angle, which is 2.3·10⁻¹³ in `f64` and
/// 1.2·10⁻⁴ in `f32`. For coordinates of another size use [`for_size`](Self::for_size). With a
/// bound that is negative or NaN every comparison fails.
///
/// ```
/// use ga_runtime::cga3::{Line, Point};
/// use ga_runtime::geometry::relation::Tolerance;
///
/// let axis = Line::from_point_direction(Point::default(), [1.0, 0.0, 0.0]);
/// let p = Point::new(5.0, 0.0, 1e-6);
/// assert!(!p.is_on(axis, Tolerance::default()));
/// assert!(p.is_on(axis, Tolerance::new(1e-5, 1e-9)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance<S> {
    /// The largest distance that is treated as zero, in the units of the coordinates.
    pub distance: S,
    /// The largest angle that is treated as zero, in radians.
    pub angle: S,
}

impl<S> Tolerance<S> {
    /// A tolerance of this distance, in the units of the coordinates, and this angle, in radians.
    #[inline]
    #[must_use]
    pub const fn new(distance: S, angle: S) -> Self {
        Self { distance, angle }
    }
}

impl<S: Real> Tolerance<S> {
    /// The default for coordinates up to a size: 1024 ε times the size as distance, 1024 ε as
    /// angle.
    ///
    /// ```
    /// use ga_runtime::geometry::relation::Tolerance;
    /// assert_eq!(Tolerance::for_size(100.0_f64).distance, 102_400.0 * f64::EPSILON);
    /// ```
    #[inline]
    #[must_use]
    pub fn for_size(size: S) -> Self {
        let angle = S::epsilon() * S::from_integer(1024);
        Self::new(angle * size, angle)
    }
}

impl<S: Real> Default for Tolerance<S> {
    /// 1024 ε of distance and of angle.
    #[inline]
    fn default() -> Self {
        Self::for_size(S::one())
    }
}

/// Whether a number is at most as large as a bound; false where either is NaN.
#[inline]
pub(super) fn within<S: Real>(x: S, bound: S) -> S::Mask {
    x.abs().less_or_equal(bound)
}

/// Whether the angle with a sine and a cosine, both not negative, is at most as large as a bound.
/// No angle is smaller than its sine, which decides most cases.
#[inline]
pub(super) fn angle_within<S: Real>(sine: S, cosine: S, bound: S) -> S::Mask {
    let may_be = (!bound.less_than(sine)).when(());
    may_be.is_some_and(|()| small_angle_within(sine, cosine, bound))
}

#[cold]
#[inline(never)]
fn small_angle_within<S: Real>(sine: S, cosine: S, bound: S) -> S::Mask {
    within(sine.atan2(cosine), bound)
}

/// The length that, times ε, bounds the rounding of a radius and a centre.
pub(super) fn rounding<S: Real>(centre: Vector<S>, radius: S) -> S {
    radius + centre.length()
}
