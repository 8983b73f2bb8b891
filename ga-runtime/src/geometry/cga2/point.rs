//! Points, flat points and directions of cga2.

use crate::cga2::{Direction, FlatPoint, Point};
use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{difference, dot, length};
use crate::scalar::{Field, Real, Ring};

impl<S: Ring> Point<S> {
    /// The coordinates `[x, y]`.
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 2] {
        [self.e1(), self.e2()]
    }

    /// The squared distance between two points, `−2 P·Q`, computed from differences of coordinates.
    #[inline]
    #[must_use]
    pub fn distance_squared(self, other: Self) -> S {
        let between = difference(self.coordinates(), other.coordinates());
        dot(between, between)
    }
}

impl<S: Real<Mask = bool>> Point<S> {
    /// The distance between two points, `√(−2 P·Q)`.
    ///
    /// ```
    /// use ga_runtime::cga2::Point;
    /// assert_eq!(Point::new(1.0, 1.0).distance(Point::new(1.0, 6.0)), 5.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn distance(self, other: Self) -> S {
        length(difference(self.coordinates(), other.coordinates()))
    }
}

impl<S> From<[S; 2]> for Point<S> {
    #[inline]
    fn from([x, y]: [S; 2]) -> Self {
        Self::new(x, y)
    }
}

impl<S: Field> FlatPoint<S> {
    /// The point p of `p∧ei`; `None` for a direction, which is the meet of parallel lines, or
    /// beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga2::{Line, Point};
    /// let (a, b) = (
    ///     Line::from_point_direction(Point::new(1.0, 0.0), [0.0, 1.0]),
    ///     Line::from_point_direction(Point::new(0.0, 2.0), [1.0, 0.0]),
    /// );
    /// assert_eq!((a & b).to_point(), Some(Point::new(1.0, 2.0)));
    /// assert_eq!((a & a).to_point(), None);
    /// ```
    #[must_use]
    pub fn to_point(self) -> Option<Point<S>> {
        if !self.eoi.is_invertible() {
            return None;
        }
        let place = [self.e1i / self.eoi, self.e2i / self.eoi];
        are_numbers(place).then(|| Point::from(place))
    }
}

impl<S: Ring> Direction<S> {
    /// The free vector v as `v∧ei`.
    #[inline]
    #[must_use]
    pub fn from_vector([x, y]: [S; 2]) -> Self {
        Self::new(x, y)
    }

    /// The free vector v of `v∧ei`.
    #[inline]
    #[must_use]
    pub fn vector(self) -> [S; 2] {
        [self.e1i, self.e2i]
    }
}
