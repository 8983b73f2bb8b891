//! Lines of pga2.

use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{area, difference, dot, normalized, scaled};
use crate::pga2::{Line, Point};
use crate::scalar::{Real, Ring};

impl<S: Ring> Line<S> {
    /// The line of the points x with `n·x = d`, as `n − d e0`. With a unit normal, d is the
    /// distance from the origin.
    #[inline]
    #[must_use]
    pub fn from_normal_distance([x, y]: [S; 2], distance: S) -> Self {
        Self::new(x, y, -distance)
    }

    /// The line through a position in a direction d; its normal is d rotated by 90°
    /// counterclockwise.
    ///
    /// ```
    /// use ga_runtime::pga2::Line;
    /// let line = Line::from_point_direction([0.0, 2.0], [3.0, 0.0]);
    /// assert_eq!((line.direction(), line.normal()), ([3.0, 0.0], [0.0, 3.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_point_direction(place: [S; 2], direction: [S; 2]) -> Self {
        let [x, y] = direction;
        Self::new(-y, x, area(place, direction))
    }

    /// The line through two points, from p to q: `p ∨ q`. Zero where they coincide.
    ///
    /// ```
    /// use ga_runtime::pga2::{Line, Point};
    /// let (p, q) = (Point::from([0.0, 1.0]), Point::from([2.0, 1.0]));
    /// assert_eq!(Line::through(p, q), p & q);
    /// assert_eq!(Line::through(p, q).direction(), [2.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>) -> Self {
        p & q
    }

    /// The normal n, to the left of the direction. Its length is the line's weight.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 2] {
        [self.e1, self.e2]
    }

    /// The direction, which is the normal rotated by 90° clockwise.
    #[inline]
    #[must_use]
    pub fn direction(self) -> [S; 2] {
        [self.e2, -self.e1]
    }
}

impl<S: Real<Mask = bool>> Line<S> {
    /// The distance to a point, positive on the side of the normal, which is to the left of the
    /// direction. `None` for an ideal line or point, or beyond the range of the scalar.
    #[must_use]
    pub fn signed_distance(self, point: Point<S>) -> Option<S> {
        let line = self.normalized()?;
        let distance = dot(line.normal(), point.coordinates()?) + line.e0;
        distance.is_finite().then_some(distance)
    }

    /// The foot of the perpendicular from a point, its projection; `None` as in
    /// [`signed_distance`](Self::signed_distance).
    ///
    /// ```
    /// use ga_runtime::pga2::{Line, Point};
    /// let line = Line::from_normal_distance([0.0, 2.0], 6.0);
    /// assert_eq!(line.foot(Point::from([5.0, 7.0])).unwrap().coordinates(), Some([5.0, 3.0]));
    /// ```
    #[must_use]
    pub fn foot(self, point: Point<S>) -> Option<Point<S>> {
        let distance = self.signed_distance(point)?;
        let normal = normalized(self.normal())?;
        let foot = difference(point.coordinates()?, scaled(normal, distance));
        are_numbers(foot).then(|| Point::from_coordinates(foot))
    }

    /// The angle of the rotation from the direction of this line to that of another, in (−π, π],
    /// positive counterclockwise. `None` for ideal lines.
    #[must_use]
    pub fn angle(self, other: Self) -> Option<S> {
        let (a, b) = (normalized(self.normal())?, normalized(other.normal())?);
        Some(area(a, b).atan2(dot(a, b)))
    }
}
