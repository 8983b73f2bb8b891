//! Circles.

use super::round;
use crate::cga3::{Circle, Direction, DualDirection, Infinity, Line, Plane, Point, Sphere};
use crate::scalar::{Field, Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

crate::ga! {
    crate::cga3;

    // As one formula, since the centre of the pair `p∧q` would be rounded.
    fn through(p: Point, q: Point, r: Point) -> Circle { p ^ q ^ r }
}

impl<S: Field> Circle<S> {
    /// The circle through three points, `p∧q∧r`. Its normal is zero where they are collinear, so
    /// that it has no [centre](Self::centre); [`Line::through`] joins them.
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Point};
    /// let [p, q, r] = [[2.0, 0.0, 1.0], [0.0, 2.0, 1.0], [-2.0, 0.0, 1.0]].map(Point::from);
    /// let circle = Circle::through(p, q, r);
    /// assert_eq!(circle.centre().unwrap().coordinates(), [0.0, 0.0, 1.0]);
    /// assert_eq!(circle.radius(), Some(2.0));
    /// // Counterclockwise as seen from the tip of the normal.
    /// assert_eq!(circle.unit_normal(), Some([0.0, 0.0, 1.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>, r: Point<S>) -> Self {
        through(p, q, r)
    }

    /// The plane of the circle, `C∧ei`.
    #[inline]
    #[must_use]
    pub fn carrier(self) -> Plane<S> {
        self ^ Infinity
    }

    /// The attitude `B∧ei`, where B is the bivector of the circle's plane.
    #[inline]
    #[must_use]
    pub fn attitude(self) -> DualDirection<S> {
        self.carrier().attitude()
    }
}

impl<S: Real> Circle<S> {
    /// The circle with a given centre in the plane perpendicular to a normal, which need not have
    /// length 1. `None` where the normal is zero or not finite, or a coefficient of the circle
    /// would not be finite.
    #[inline]
    #[must_use]
    pub fn from_centre_normal_radius(
        centre: Point<S>,
        normal: [S; 3],
        radius: S,
    ) -> Maybe<Self, S> {
        Self::from_centre_normal_radius_squared(centre, normal, radius * radius)
    }

    /// The same, given the squared radius, which may be zero, for a [tangent](Self::tangent), or
    /// negative, for an imaginary circle: `undual(σ∧π)`, where σ is the dual sphere `c − ½r² ei`
    /// and π the dual plane `n + (n·c) ei` with n of length 1.
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Point};
    /// let normal = [0.0, 0.0, 5.0];
    /// let circle =
    ///     Circle::from_centre_normal_radius_squared(Point::new(1.0, 0.0, 2.0), normal, -4.0)
    ///         .unwrap();
    /// assert_eq!(
    ///     (circle.radius_squared(), circle.radius()),
    ///     (Some(-4.0), None)
    /// );
    /// ```
    #[inline]
    #[must_use]
    pub fn from_centre_normal_radius_squared(
        centre: Point<S>,
        normal: [S; 3],
        radius_squared: S,
    ) -> Maybe<Self, S> {
        round::unit_axis(normal).and_then(|axis| Self::around(centre.into(), axis, radius_squared))
    }

    /// The same with a normal of length 1.
    #[inline]
    pub(super) fn around(
        centre: Vector<S>,
        normal: Vector<S>,
        radius_squared: S,
    ) -> Maybe<Self, S> {
        let (centre, normal) = (Point::from(centre), Direction::from_vector(normal.into()));
        round::is_round(centre, normal, radius_squared).when(Self {
            centre,
            normal,
            radius_squared,
        })
    }

    /// The tangent element at a point, in the plane perpendicular to a normal: a circle of radius
    /// zero, that is a point with a plane through it. `None` where the normal is zero, or a number
    /// is not finite.
    #[inline]
    #[must_use]
    pub fn tangent(point: Point<S>, normal: [S; 3]) -> Maybe<Self, S> {
        Self::from_centre_normal_radius_squared(point, normal, S::zero())
    }

    /// The normal of the circle's plane, of length 1; `None` for a circle of weight zero.
    #[inline]
    #[must_use]
    pub fn unit_normal(self) -> Maybe<[S; 3], S> {
        round::unit_axis(self.normal.vector()).map(Vector::coordinates)
    }

    /// The centre; `None` for a circle of weight zero, such as that through three points on a line,
    /// and where a number is not finite.
    #[inline(always)]
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        self.is_round().when(self.centre)
    }

    /// The squared radius, negative for an imaginary circle; `None` where there is no
    /// [centre](Self::centre).
    #[inline(always)]
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        self.is_round().when(self.radius_squared)
    }

    /// The radius; `None` where there is no [centre](Self::centre), and for an imaginary circle.
    #[inline(always)]
    #[must_use]
    pub fn radius(self) -> Maybe<S, S> {
        self.radius_squared().and_then(round::radius)
    }

    /// The line through the centre along the normal of the circle's plane; `None` where there is no
    /// [centre](Self::centre).
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Line, Point};
    /// let centre = Point::new(1.0, 2.0, 0.0);
    /// let circle = Circle::from_centre_normal_radius(centre, [0.0, 0.0, 1.0], 3.0).unwrap();
    /// assert_eq!(circle.axis(), Some(Line::from_point_direction(centre, [0.0, 0.0, 1.0])));
    /// ```
    #[inline]
    #[must_use]
    pub fn axis(self) -> Maybe<Line<S>, S> {
        let normal = self.unit_normal();
        normal
            .zip(self.centre())
            .map(|(normal, centre)| Line::from_point_direction(centre, normal))
    }

    /// The smallest sphere that contains the circle, with the same centre and the same squared
    /// radius. `None` where there is no [centre](Self::centre).
    #[inline]
    #[must_use]
    pub fn container(self) -> Maybe<Sphere<S>, S> {
        let centre = self.centre();
        centre.map(|centre| Sphere::from_centre_radius_squared(centre, self.radius_squared))
    }

    /// Whether the circle has a weight, and all numbers are finite.
    #[inline(always)]
    fn is_round(self) -> S::Mask {
        round::is_round(self.centre, self.normal, self.radius_squared)
    }
}
