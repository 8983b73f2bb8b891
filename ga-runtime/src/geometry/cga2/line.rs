//! Lines of cga2, direct and dual.

use crate::cga2::{DualLine, Line, Point};
use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{area, difference, dot, normalized, scaled};
use crate::scalar::{Real, Ring};

impl<S: Ring> DualLine<S> {
    /// The line of the points x with `n·x = d`, as `n + d ei`.
    #[inline]
    #[must_use]
    pub fn from_normal_distance([x, y]: [S; 2], distance: S) -> Self {
        Self::new(x, y, distance)
    }

    /// The normal n. Its length is the line's weight.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 2] {
        [self.e1, self.e2]
    }
}

impl<S: Ring> Line<S> {
    /// The line through two points, from the first to the second: `p∧q∧ei`. Zero where they
    /// coincide.
    ///
    /// ```
    /// use ga_runtime::cga2::{Infinity, Line, Point};
    /// let (p, q) = (Point::new(0.0, 1.0), Point::new(2.0, 1.0));
    /// let line = Line::through(p, q);
    /// assert_eq!(line, p ^ q ^ Infinity);
    /// assert_eq!((line.direction(), line.normal()), ([2.0, 0.0], [0.0, 2.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>) -> Self {
        Self::from_point_direction(p, difference(q.coordinates(), p.coordinates()))
    }

    /// The line through a point in a direction d: `p∧d∧ei`. Zero where d is zero.
    #[inline]
    #[must_use]
    pub fn from_point_direction(point: Point<S>, direction: [S; 2]) -> Self {
        let [x, y] = direction;
        Self::new(area(point.coordinates(), direction), -x, -y)
    }

    /// The direction d. Its length is the line's weight.
    #[inline]
    #[must_use]
    pub fn direction(self) -> [S; 2] {
        [-self.e1oi, -self.e2oi]
    }

    /// The normal, which is the direction rotated by 90° counterclockwise: that of the dual line
    /// `n + d ei`.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 2] {
        [self.e2oi, -self.e1oi]
    }

    /// The moment `p∧d` about the origin, for any point p of the line: its coefficient of e12.
    #[inline]
    #[must_use]
    pub fn moment(self) -> S {
        self.e12i
    }
}

impl<S: Real<Mask = bool>> Line<S> {
    /// The distance to a point, positive on the side of the normal, which is to the left of the
    /// direction. `None` for weight zero, or beyond the range of the scalar.
    #[must_use]
    pub fn signed_distance(self, point: Point<S>) -> Option<S> {
        let line = self.normalized()?;
        let distance = dot(line.normal(), point.coordinates()) + line.moment();
        distance.is_finite().then_some(distance)
    }

    /// The foot of the perpendicular from a point; `None` as in
    /// [`signed_distance`](Self::signed_distance).
    #[must_use]
    pub fn foot(self, point: Point<S>) -> Option<Point<S>> {
        let distance = self.signed_distance(point)?;
        let normal = normalized(self.normal())?;
        let foot = difference(point.coordinates(), scaled(normal, distance));
        are_numbers(foot).then(|| Point::from(foot))
    }
}
