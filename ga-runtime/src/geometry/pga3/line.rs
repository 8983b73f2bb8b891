//! Lines of pga3.

use crate::pga3::{Line, Motor, Plane, Point};
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

impl<S: Ring> Line<S> {
    /// The line through two points, from p to q: `q ∨ p`, so that a rotation about it is
    /// right-handed about `q − p`. Zero where the points coincide. q may be the ideal point of a
    /// [`Direction`](crate::pga3::Direction).
    ///
    /// ```
    /// use ga_runtime::pga3::{Line, Point};
    /// let (p, q) = (Point::from([0.0, 1.0, 0.0]), Point::from([2.0, 1.0, 0.0]));
    /// let line = Line::through(p, q);
    /// assert_eq!(line, q & p);
    /// assert_eq!((line.direction(), line.moment()), ([2.0, 0.0, 0.0], [0.0, 0.0, -2.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>) -> Self {
        q & p
    }

    /// The line with direction d and moment m, `d1 e23 − d2 e13 + d3 e12 − m∧e0`. It is a line if
    /// `d·m = 0`; other bivectors are generators of screws, see [`Line::exp`].
    #[inline]
    #[must_use]
    pub fn from_direction_moment([d1, d2, d3]: [S; 3], [m1, m2, m3]: [S; 3]) -> Self {
        Self::new(d3, -d2, d1, -m1, -m2, -m3)
    }

    /// The line through a position in a direction.
    #[inline]
    #[must_use]
    pub fn from_point_direction(place: [S; 3], direction: [S; 3]) -> Self {
        let moment = Vector::from(place).cross(direction.into());
        Self::from_direction_moment(direction, moment.into())
    }

    /// The direction d, whose length is the line's weight: the coefficients of e23, −e13, e12. For
    /// a meet `Π∧Ρ` of planes it is the cross product of their normals.
    #[inline]
    #[must_use]
    pub fn direction(self) -> [S; 3] {
        [self.e23, -self.e13, self.e12]
    }

    /// The moment `p × d` about the origin, for any point p of the line: minus the coefficients of
    /// e10, e20, e30.
    #[inline]
    #[must_use]
    pub fn moment(self) -> [S; 3] {
        [-self.e10, -self.e20, -self.e30]
    }
}

impl<S: Real<Mask = bool>> Line<S> {
    /// The direction with length 1; `None` for an ideal line, or where it is not finite.
    #[inline]
    #[must_use]
    pub fn unit_direction(self) -> Option<[S; 3]> {
        Vector::from(self.direction())
            .normalized()
            .map(Vector::coordinates)
    }

    /// The point of the line nearest to the origin, `d × m / d²`; `None` for an ideal line.
    #[must_use]
    pub fn support(self) -> Option<Point<S>> {
        let line = self.normalized()?;
        let place = Vector::from(line.direction()).cross(line.moment().into());
        place
            .is_finite()
            .then(|| Point::from_coordinates(place.into()))
    }

    /// The foot of the perpendicular from a point, its projection; `None` for an ideal line or
    /// point.
    ///
    /// ```
    /// use ga_runtime::pga3::{Line, Point};
    /// let line = Line::from_point_direction([0.0, 1.0, 0.0], [3.0, 0.0, 0.0]);
    /// let foot = line.foot(Point::from([3.0, 7.0, 0.0])).unwrap();
    /// assert_eq!(foot.coordinates(), Some([3.0, 1.0, 0.0]));
    /// ```
    #[must_use]
    pub fn foot(self, point: Point<S>) -> Option<Point<S>> {
        let direction = Vector::from(self.unit_direction()?);
        let [support, place] =
            [self.support()?.coordinates()?, point.coordinates()?].map(Vector::from);
        let foot = support + direction * (place - support).dot(direction);
        foot.is_finite()
            .then(|| Point::from_coordinates(foot.into()))
    }

    /// The distance to a point; `None` for an ideal line or point.
    #[must_use]
    pub fn distance(self, point: Point<S>) -> Option<S> {
        self.foot(point)?.distance(point)
    }

    /// The distance between two lines, `|d1·m2 + d2·m1| / |d1 × d2|` for skew lines. If the angle
    /// between them is below √ε, they are treated as parallel, and the distance is that of the
    /// other line's point nearest to the origin. `None` where one is ideal.
    #[must_use]
    pub fn distance_to_line(self, other: Self) -> Option<S> {
        let (a, b) = (self.normalized()?, other.normalized()?);
        let [u, v] = [a.direction(), b.direction()].map(Vector::from);
        let across = u.cross(v).length();
        if across.less_than(S::epsilon().sqrt()) {
            return a.distance(b.support()?);
        }
        let distance = (u.dot(b.moment().into()) + v.dot(a.moment().into())).abs() / across;
        distance.is_finite().then_some(distance)
    }

    /// The angle between the directions of two lines, in [0, π]; `None` where one is ideal.
    #[must_use]
    pub fn angle(self, other: Self) -> Option<S> {
        let [a, b] = [self.unit_direction()?, other.unit_direction()?].map(Vector::from);
        Some(a.cross(b).length().atan2(a.dot(b)))
    }

    /// The angle between the line and a plane, in [−½π, ½π]: positive where the direction of the
    /// line points to the side of the normal. `None` where one is ideal.
    #[must_use]
    pub fn angle_to_plane(self, plane: Plane<S>) -> Option<S> {
        let [direction, normal] = [self.unit_direction()?, plane.unit_normal()?].map(Vector::from);
        Some(
            direction
                .dot(normal)
                .atan2(direction.cross(normal).length()),
        )
    }

    /// The motor `exp(B)` of any bivector: `B = −½θL` rotates by θ about the unit line L,
    /// right-handed about its direction; `B = ½ t∧e0` translates by t; a sum of both with t along L
    /// gives a screw.
    ///
    /// Accurate to rounding for arbitrarily small angles. NaN stays NaN.
    ///
    /// ```
    /// use ga_runtime::pga3::{Line, Point};
    /// let axis = Line::from_point_direction([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    /// let quarter = (axis * (-0.25 * std::f64::consts::PI)).exp();
    /// let [x, y, z] = quarter.transform(Point::from([2.0, 0.0, 5.0])).coordinates().unwrap();
    /// assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 5.0);
    /// ```
    #[must_use]
    pub fn exp(self) -> Motor<S> {
        crate::cga3::MotorGenerator::from(self).exp().into()
    }
}
