//! Points.

use crate::cga3::Point;
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

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

    /// The vector from this point to another, `other − self`.
    ///
    /// ```
    /// use ga_runtime::{cga3::Point, vga3::Vector};
    /// let (p, q) = (Point::new(1, 2, 3), Point::new(5, 5, 5));
    /// assert_eq!(p.vector_to(q), Vector::new(4, 3, 2));
    /// ```
    #[inline]
    #[must_use]
    pub fn vector_to(self, other: Self) -> Vector<S> {
        Vector::from(other) - Vector::from(self)
    }

    /// The squared distance between two points, `−2 P·Q`, computed from differences of coordinates,
    /// which avoids cancellation far from the origin.
    #[inline]
    #[must_use]
    pub fn distance_squared(self, other: Self) -> S {
        other.vector_to(self).length_squared()
    }
}

impl<S: Real<Mask = bool>> Point<S> {
    /// The distance between two points, `√(−2 P·Q)` (Cui, eq. 32, corrected). For other primitives:
    /// [`distance_to`](Self::distance_to).
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
        other.vector_to(self).length()
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
