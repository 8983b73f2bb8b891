//! Planes of pga3.

use crate::geometry::number::are_numbers;
use crate::pga3::{Line, Plane, Point};
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

impl<S: Ring> Plane<S> {
    /// The plane of the points x with `n·x = d`, as `n − d e0`. With a unit normal, d is the
    /// distance from the origin.
    ///
    /// ```
    /// use ga_runtime::pga3::{Plane, Point};
    /// let plane = Plane::from_normal_distance([0.0, 0.0, 1.0], 2.0);
    /// assert_eq!(plane.signed_distance(Point::from_coordinates([5.0, 5.0, 3.0])), Some(1.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_normal_distance([x, y, z]: [S; 3], distance: S) -> Self {
        Self::new(x, y, z, -distance)
    }

    /// The plane through a position with a given normal.
    #[inline]
    #[must_use]
    pub fn from_point_normal(place: [S; 3], normal: [S; 3]) -> Self {
        Self::from_normal_distance(normal, Vector::from(normal).dot(place.into()))
    }

    /// The plane through three points, `p∨q∨r`: its normal is `(q − p) × (r − p)`, so that p, q, r
    /// are in counterclockwise order as seen from its tip. Zero where the points are collinear.
    ///
    /// ```
    /// use ga_runtime::pga3::{Plane, Point};
    /// let [p, q, r] = [[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [0.0, 1.0, 2.0]].map(Point::from);
    /// assert_eq!(Plane::through(p, q, r), Plane::from_normal_distance([0.0, 0.0, 1.0], 2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>, r: Point<S>) -> Self {
        p & q & r
    }

    /// The normal n. Its length is the plane's weight.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 3] {
        [self.e1, self.e2, self.e3]
    }
}

impl<S: Real<Mask = bool>> Plane<S> {
    /// The normal with length 1; `None` where it is zero, as that of the ideal plane e0, or not
    /// finite.
    #[inline]
    #[must_use]
    pub fn unit_normal(self) -> Option<[S; 3]> {
        Vector::from(self.normal())
            .normalized()
            .map(Vector::coordinates)
    }

    /// The distance to a point, positive on the side of the normal: `(p ∨ Π)` for both of weight 1.
    /// `None` for an ideal point or plane, or beyond the range of the scalar.
    #[must_use]
    pub fn signed_distance(self, point: Point<S>) -> Option<S> {
        let plane = self.normalized()?;
        let distance = Vector::from(plane.normal()).dot(point.coordinates()?.into()) + plane.e0;
        distance.is_finite().then_some(distance)
    }

    /// The foot of the perpendicular from a point, its projection; `None` as in
    /// [`signed_distance`](Self::signed_distance).
    ///
    /// ```
    /// use ga_runtime::pga3::{Plane, Point};
    /// let plane = Plane::from_normal_distance([0.0, 0.0, 4.0], 8.0);
    /// let foot = plane.foot(Point::from([5.0, 6.0, 3.0])).unwrap();
    /// assert_eq!(foot.coordinates(), Some([5.0, 6.0, 2.0]));
    /// ```
    #[must_use]
    pub fn foot(self, point: Point<S>) -> Option<Point<S>> {
        let distance = self.signed_distance(point)?;
        let normal = Vector::from(self.unit_normal()?);
        let foot = Vector::from(point.coordinates()?) - normal * distance;
        foot.is_finite()
            .then(|| Point::from_coordinates(foot.into()))
    }

    /// The projection of a line, whose weight is multiplied by the cosine of the angle between
    /// both; `None` where the line is perpendicular to the plane within 8 ε, so that its projection
    /// is a point, or where one of them is ideal.
    #[must_use]
    pub fn project(self, line: Line<S>) -> Option<Line<S>> {
        let normal = self.unit_normal()?;
        let direction = Vector::from(line.direction());
        let within = direction.across(normal.into());
        // The projection of a perpendicular direction is only rounding error.
        let least = S::from_integer(8) * S::epsilon() * direction.length();
        if !least.less_than(within.length()) {
            return None;
        }
        let foot = self.foot(line.support()?)?.coordinates()?;
        let projection = Line::from_point_direction(foot, within.into());
        are_numbers(projection.moment()).then_some(projection)
    }

    /// The angle between the normals, in [0, π]; `None` where one is zero or not finite.
    #[must_use]
    pub fn angle(self, other: Self) -> Option<S> {
        let [a, b] = [self.unit_normal()?, other.unit_normal()?].map(Vector::from);
        Some(a.cross(b).length().atan2(a.dot(b)))
    }
}
