//! Flat points.

use crate::cga3::{FlatPoint, Infinity, Point};
use crate::geometry::number::are_numbers;
use crate::scalar::{Mask, Maybe, Real, Ring};

impl<S: Ring> From<Point<S>> for FlatPoint<S> {
    /// The flat point `p∧ei`.
    #[inline]
    fn from(point: Point<S>) -> Self {
        point ^ Infinity
    }
}

impl<S: Real> FlatPoint<S> {
    /// The point of `p∧ei`; `None` for a direction, whose weight eoi is zero, or beyond the range
    /// of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Infinity, Point};
    /// let p = Point::new(1.0, 2.0, 3.0);
    /// assert_eq!((p ^ Infinity).to_point(), Some(p));
    /// ```
    #[inline]
    #[must_use]
    pub fn to_point(self) -> Maybe<Point<S>, S> {
        let place = [self.e1i, self.e2i, self.e3i].map(|x| x / self.eoi);
        (!self.eoi.equals(S::zero()) & are_numbers(place)).when(Point::from(place))
    }
}
