//! Point pairs.

use super::round;
use crate::cga3::{Direction, Infinity, Line, Point, PointPair, Sphere};
use crate::geometry::number::are_numbers;
use crate::scalar::{Field, Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

impl<S: Field> PointPair<S> {
    /// The pair of two points, `p∧q`. Zero where they coincide; [`tangent`](Self::tangent) gives
    /// the limit with a direction.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, PointPair};
    /// let (p, q) = (Point::new(1.0_f64, 0.0, 2.0), Point::new(5.0, 0.0, 2.0));
    /// let pair = PointPair::through(p, q);
    /// assert_eq!(pair.endpoints().unwrap(), [p, q]);
    /// assert_eq!(pair.centre().unwrap().coordinates(), [3.0, 0.0, 2.0]);
    /// assert_eq!(pair.radius_squared(), Some(4.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>) -> Self {
        p ^ q
    }

    /// The line through the pair, `P∧ei`, from the first point to the second.
    #[inline]
    #[must_use]
    pub fn carrier(self) -> Line<S> {
        self ^ Infinity
    }

    /// The attitude `v∧ei`: for `p∧q` the free vector `v = q − p`.
    #[inline]
    #[must_use]
    pub fn attitude(self) -> Direction<S> {
        self.direction
    }

    /// `P²`: for `p∧q` it is `(p·q)²`, a quarter of the fourth power of the distance. It is
    /// positive for a real pair, zero for a tangent and negative for an imaginary pair.
    #[inline]
    #[must_use]
    pub fn square(self) -> S {
        self.scalar_product(self)
    }
}

impl<S: Real> PointPair<S> {
    /// The two points at a distance r from a centre, in the direction of an axis and opposite to
    /// it: `(c + eo + ½(c² + r²) ei) ∧ (d + (c·d) ei)` with the unit vector d. The argument is r²,
    /// which may be zero, for a [tangent](Self::tangent), or negative, for an imaginary pair. The
    /// axis need not have length 1; `None` where it is zero, or a number is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, PointPair};
    /// let pair = PointPair::from_centre_axis_radius_squared(
    ///     Point::new(1.0, 0.0, 0.0),
    ///     [0.0, 2.0, 0.0],
    ///     9.0,
    /// )
    /// .unwrap();
    /// assert_eq!(
    ///     pair.endpoints().unwrap().map(|p| p.coordinates()),
    ///     [[1.0, -3.0, 0.0], [1.0, 3.0, 0.0]]
    /// );
    /// ```
    #[inline]
    #[must_use]
    pub fn from_centre_axis_radius_squared(
        centre: Point<S>,
        axis: [S; 3],
        radius_squared: S,
    ) -> Maybe<Self, S> {
        round::unit_axis(axis).and_then(|axis| Self::around(centre.into(), axis, radius_squared))
    }

    /// The same with an axis of length 1.
    #[inline]
    pub(super) fn around(centre: Vector<S>, axis: Vector<S>, radius_squared: S) -> Maybe<Self, S> {
        let (centre, direction) = (Point::from(centre), Direction::from_vector(axis.into()));
        round::is_round(centre, direction, radius_squared).when(Self {
            centre,
            direction,
            radius_squared,
        })
    }

    /// The tangent element at a point p in a direction: the limit of two points that approach each
    /// other along that direction. Its square is zero. `None` where the direction is zero, or a
    /// number is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, PointPair};
    /// use ga_runtime::geometry::Kind;
    /// let tangent = PointPair::tangent(Point::new(1.0_f64, 2.0, 0.0), [0.0, 3.0, 4.0]).unwrap();
    /// assert_eq!(tangent.kind(1e-12), Kind::Tangent);
    /// let [_, y, z] = tangent.unit_direction().unwrap();
    /// assert!((y - 0.6).abs() < 1e-15 && (z - 0.8).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn tangent(point: Point<S>, direction: [S; 3]) -> Maybe<Self, S> {
        Self::from_centre_axis_radius_squared(point, direction, S::zero())
    }

    /// The direction from the first point to the second, with length 1; `None` for a pair of weight
    /// zero.
    #[inline]
    #[must_use]
    pub fn unit_direction(self) -> Maybe<[S; 3], S> {
        round::unit_axis(self.direction.vector()).map(Vector::coordinates)
    }

    /// The midpoint of the two points; `None` for a pair of weight zero, and where a number is not
    /// finite.
    #[inline(always)]
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        self.is_round().when(self.centre)
    }

    /// The square of half the distance between the points, `P²/(ei⌋P)²`: zero for a tangent,
    /// negative for an imaginary pair; `None` where there is no [centre](Self::centre).
    #[inline(always)]
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        self.is_round().when(self.radius_squared)
    }

    /// Half the distance between the points; `None` for an imaginary pair and for one of weight
    /// zero.
    #[inline(always)]
    #[must_use]
    pub fn radius(self) -> Maybe<S, S> {
        self.radius_squared().and_then(round::radius)
    }

    /// The two points, in the order of `p∧q`: `k p∧q` gives `[p, q]` for a positive factor k and
    /// `[q, p]` for a negative one. `None` for an imaginary pair and for one of weight zero.
    ///
    /// For the meet `line & sphere` with a sphere of
    /// [`from_centre_radius`](Sphere::from_centre_radius), that is the order against the direction
    /// of the line: `-(line & sphere)` begins where the line enters the sphere.
    /// [`Ray::entry_and_exit`](crate::geometry::ray::Ray::entry_and_exit) has that order for a
    /// sphere of any weight.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Point, Sphere};
    /// let unit = Sphere::from_centre_radius(Point::new(0.0, 0.0, 0.0), 1.0);
    /// let line = Line::from_point_direction(Point::new(5.0, 0.0, 0.0), [1.0, 0.0, 0.0]);
    /// let ends = (-(line & unit)).endpoints().unwrap();
    /// assert_eq!(ends, [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]].map(Point::from));
    /// ```
    ///
    /// The squared radius decides which it is, however small: near a tangent the rounding of what
    /// it was computed from may. [`Kind`](crate::geometry::Kind) recognises a tangent with a
    /// tolerance of your choice, and [`meet`](crate::geometry::relation::meet) by distances in
    /// space.
    #[inline(always)]
    #[must_use]
    pub fn endpoints(self) -> Maybe<[Point<S>; 2], S> {
        let is_real = !self.radius_squared.less_than(S::zero());
        let reach = || round::of_length(self.direction, self.radius_squared);
        is_real.when(()).and_then(|()| reach()).and_then(|reach| {
            let centre = Vector::from(self.centre);
            let (first, second) = (centre - reach, centre + reach);
            let is_finite = are_numbers([
                first.e1, first.e2, first.e3, second.e1, second.e2, second.e3,
            ]);
            is_finite.when([Point::from(first), Point::from(second)])
        })
    }

    /// The smallest sphere that contains the pair, with the same centre and the same squared
    /// radius: the dual sphere `P (P∧ei)⁻¹` up to scale. `None` where there is no
    /// [centre](Self::centre).
    #[inline]
    #[must_use]
    pub fn container(self) -> Maybe<Sphere<S>, S> {
        let centre = self.centre();
        centre.map(|centre| Sphere::from_centre_radius_squared(centre, self.radius_squared))
    }

    /// Whether the pair has a weight, and all numbers are finite.
    #[inline(always)]
    fn is_round(self) -> S::Mask {
        round::is_round(self.centre, self.direction, self.radius_squared)
    }
}
