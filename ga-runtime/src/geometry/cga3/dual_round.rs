//! Spheres, circles and point pairs in dual form.

use super::round;
use crate::cga3::{DualCircle, DualPointPair, DualSphere, Point, RoundVector};
use crate::geometry::number::{are_numbers, is_number};
use crate::scalar::{Field, Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

impl<S: Field> DualSphere<S> {
    /// The dual sphere `c − ½r² ei` with a given centre, where c is the centre's conformal point.
    ///
    /// ```
    /// use ga_runtime::cga3::{DualSphere, Point};
    /// let sphere = DualSphere::from_centre_radius(Point::new(1.0, 0.0, 0.0), 2.0);
    /// // x·σ is half of r² − d² with d the distance from the centre: positive inside, zero on the
    /// // sphere.
    /// assert_eq!(
    ///     (
    ///         Point::new(3.0, 0.0, 0.0) | sphere,
    ///         Point::new(1.0, 0.0, 0.0) | sphere
    ///     ),
    ///     (0.0, 2.0)
    /// );
    /// ```
    #[inline]
    #[must_use]
    pub fn from_centre_radius(centre: Point<S>, radius: S) -> Self {
        Self::from_centre_radius_squared(centre, radius * radius)
    }

    /// The dual sphere with a given centre and squared radius, which may be negative.
    #[inline]
    #[must_use]
    pub fn from_centre_radius_squared(centre: Point<S>, radius_squared: S) -> Self {
        Self {
            weight: S::one(),
            centre,
            radius_squared,
        }
    }
}

impl<S: Real> DualSphere<S> {
    /// The centre; `None` for a sphere of weight zero, and where a number is not finite.
    #[inline]
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        self.is_round().when(self.centre)
    }

    /// The squared radius, `σ²/(ei·σ)²`: zero for a point, negative for an imaginary sphere; `None`
    /// where there is no [centre](Self::centre).
    #[inline]
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        self.is_round().when(self.radius_squared)
    }

    /// The radius; `None` where there is no [centre](Self::centre), and for an imaginary sphere.
    #[inline]
    #[must_use]
    pub fn radius(self) -> Maybe<S, S> {
        self.radius_squared().and_then(round::radius)
    }

    /// Whether the sphere has a weight, and all numbers are finite.
    #[inline(always)]
    fn is_round(self) -> S::Mask {
        let [x, y, z] = self.centre.coordinates();
        !self.weight.equals(S::zero()) & are_numbers([x, y, z, self.weight, self.radius_squared])
    }
}

impl<S: Field> RoundVector<S> {
    /// The dual sphere `c − ½r² ei` as a vector; see [`DualSphere::from_centre_radius`].
    #[inline]
    #[must_use]
    pub fn dual_sphere(centre: Point<S>, radius: S) -> Self {
        DualSphere::from_centre_radius(centre, radius).into()
    }
}

impl<S: Real> RoundVector<S> {
    /// The position of a weighted point, or the centre of a dual sphere: the coefficients of e1,
    /// e2, e3 divided by that of eo. `None` where that is zero, as in a dual plane, or the result
    /// is beyond the range of the scalar.
    #[inline]
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        let inverse = self.eo.recip();
        let (x, y, z) = (self.e1 * inverse, self.e2 * inverse, self.e3 * inverse);
        // The sum is a number only if each of them is.
        is_number(x + y + z)
            .when([x, y, z])
            .or_else_of(
                ([self.e1, self.e2, self.e3], self.eo),
                |(coordinates, weight)| {
                    let place = divided(coordinates, S::zero(), weight);
                    place.map(|[x, y, z, _]| [x, y, z])
                },
            )
            .filter(|_| !self.eo.equals(S::zero()))
            .map(Point::from)
    }

    /// The squared radius of a dual sphere, `c² − 2 ei/eo` with the centre c, as accurate as that
    /// difference is; `None` where there is no [centre](Self::centre), or where it is beyond the
    /// range of the scalar. A [`DualSphere`] keeps it.
    #[inline]
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        let numbers = divided([self.e1, self.e2, self.e3], self.ei + self.ei, self.eo);
        numbers
            .map(|[x, y, z, last]| Vector::new(x, y, z).length_squared() - last)
            .filter(|squared| !self.eo.equals(S::zero()) & is_number(*squared))
    }
}

/// Three coordinates, which must be finite, and another number, each divided by the weight. For a
/// weight whose inverse is beyond the range of the scalar, and for large coordinates.
#[cold]
#[inline(never)]
fn divided<S: Real>(coordinates: [S; 3], other: S, weight: S) -> Maybe<[S; 4], S> {
    let place @ [x, y, z] = coordinates.map(|coordinate| coordinate / weight);
    are_numbers(place).when([x, y, z, other / weight])
}

impl<S: Real> DualCircle<S> {
    /// The centre; see [`Circle::centre`](crate::cga3::Circle::centre).
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        self.undual().centre()
    }

    /// The squared radius, negative for an imaginary circle.
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        self.undual().radius_squared()
    }

    /// The radius; `None` for an imaginary circle.
    #[must_use]
    pub fn radius(self) -> Maybe<S, S> {
        self.undual().radius()
    }

    /// The normal of the circle's plane, of length 1: for `σ∧π` that of the dual plane π.
    #[must_use]
    pub fn unit_normal(self) -> Maybe<[S; 3], S> {
        self.undual().unit_normal()
    }
}

impl<S: Real> DualPointPair<S> {
    /// The midpoint of the two points; see [`PointPair::centre`](crate::cga3::PointPair::centre).
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        self.undual().centre()
    }

    /// The square of half the distance between the points; negative for an imaginary pair.
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        self.undual().radius_squared()
    }

    /// Half the distance between the points; `None` for an imaginary pair.
    #[must_use]
    pub fn radius(self) -> Maybe<S, S> {
        self.undual().radius()
    }

    /// The two points; see [`PointPair::endpoints`](crate::cga3::PointPair::endpoints).
    ///
    /// ```
    /// use ga_runtime::cga3::{DualPlane, DualSphere, Point};
    /// // A sphere and two planes through its centre meet in two points.
    /// let sphere = DualSphere::from_centre_radius(Point::new(0.0_f64, 0.0, 0.0), 2.0);
    /// let (x, y) = (DualPlane::new(1.0, 0.0, 0.0, 0.0), DualPlane::new(0.0, 1.0, 0.0, 0.0));
    /// let [p, q] = (sphere ^ x ^ y).endpoints().unwrap();
    /// assert_eq!([p.e3().abs(), q.e3().abs(), p.distance(q)], [2.0, 2.0, 4.0]);
    /// ```
    #[must_use]
    pub fn endpoints(self) -> Maybe<[Point<S>; 2], S> {
        self.undual().endpoints()
    }
}
