//! Points.

use super::vector3::{are_numbers, difference, dot, length};
use crate::cga3::{FlatPoint, Point};
use crate::scalar::{Field, Real, Ring};

impl<S: Ring> Point<S> {
    /// The coordinates `[x, y, z]`.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// assert_eq!(Point::new(1.0, 2.0, 3.0).coordinates(), [1.0, 2.0, 3.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 3] {
        [self.e1(), self.e2(), self.e3()]
    }

    /// The squared distance of two points, `−2 P·Q`, worked out from differences of coordinates so that nothing
    /// cancels far from the origin.
    #[inline]
    #[must_use]
    pub fn distance_squared(self, other: Self) -> S {
        let between = difference(self.coordinates(), other.coordinates());
        dot(between, between)
    }
}

impl<S: Real<Mask = bool>> Point<S> {
    /// The distance of two points, `√(−2 P·Q)` (the paper's eq. 32, corrected).
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// let (p, q) = (Point::new(1.0_f64, 1.0, 0.0), Point::new(4.0, 5.0, 0.0));
    /// assert_eq!(p.distance(q), 5.0);
    /// assert_eq!((-2.0 * (p | q)).sqrt(), 5.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn distance(self, other: Self) -> S {
        length(difference(self.coordinates(), other.coordinates()))
    }
}

impl<S> From<[S; 3]> for Point<S> {
    #[inline]
    fn from([x, y, z]: [S; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<S: Ring> From<Point<S>> for [S; 3] {
    #[inline]
    fn from(point: Point<S>) -> Self {
        point.coordinates()
    }
}

impl<S: Field> FlatPoint<S> {
    /// The point of `p∧ei`; `None` for a direction, whose weight eoi is zero, or beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Infinity, Point};
    /// let p = Point::new(1.0, 2.0, 3.0);
    /// assert_eq!((p ^ Infinity).to_point(), Some(p));
    /// ```
    #[inline]
    #[must_use]
    pub fn to_point(self) -> Option<Point<S>> {
        let place = [self.e1i, self.e2i, self.e3i];
        if !self.eoi.is_invertible() {
            return None;
        }
        let place = place.map(|x| x / self.eoi);
        are_numbers(place).then(|| Point::from(place))
    }
}
