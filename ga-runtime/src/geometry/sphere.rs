//! Spheres, direct and dual.

use super::vector3::{are_numbers, dot, is_number};
use crate::cga3::{Point, RoundVector, Sphere};
use crate::scalar::{Field, Real};

impl<S: Field> RoundVector<S> {
    /// The dual sphere `c − ½r² ei` about a centre, c being its conformal point.
    #[inline]
    #[must_use]
    pub fn dual_sphere(centre: Point<S>, radius: S) -> Self {
        let mut vector = Self::from(centre);
        vector.ei -= radius * radius * S::from_ratio(1, 2);
        vector
    }

    /// The centre of a dual sphere; `None` for a dual plane, whose weight eo is zero, or beyond the range of the scalar.
    #[inline]
    #[must_use]
    pub fn centre(self) -> Option<Point<S>> {
        let place = [self.e1, self.e2, self.e3];
        if !self.eo.is_invertible() {
            return None;
        }
        let place = place.map(|x| x / self.eo);
        are_numbers(place).then(|| Point::from(place))
    }

    /// The squared radius, `σ²/(ei·σ)²`: zero for a point, negative for an imaginary sphere; `None` for a dual plane, or
    /// beyond the range of the scalar.
    #[inline]
    #[must_use]
    pub fn radius_squared(self) -> Option<S> {
        let centre = self.centre()?.coordinates();
        let twice = self.ei + self.ei;
        let squared = dot(centre, centre) - twice / self.eo;
        is_number(squared).then_some(squared)
    }
}

impl<S: Field> Sphere<S> {
    /// The sphere through four points, `p∧q∧r∧s`; a plane where they are in one plane, zero where they are on one circle.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Sphere};
    /// let [p, q, r, s] =
    ///     [[3.0, 0.0, 0.0], [1.0, 2.0, 0.0], [1.0, 0.0, 2.0], [-1.0, 0.0, 0.0]].map(Point::from);
    /// let sphere = Sphere::through(p, q, r, s);
    /// assert_eq!(sphere.centre().unwrap().coordinates(), [1.0, 0.0, 0.0]);
    /// assert_eq!(sphere.radius(), Some(2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>, r: Point<S>, s: Point<S>) -> Self {
        p ^ q ^ r ^ s
    }

    /// The sphere about a centre.
    #[inline]
    #[must_use]
    pub fn from_centre_radius(centre: Point<S>, radius: S) -> Self {
        RoundVector::dual_sphere(centre, radius).undual()
    }

    /// The centre; `None` for a plane.
    #[inline]
    #[must_use]
    pub fn centre(self) -> Option<Point<S>> {
        self.dual().centre()
    }

    /// The squared radius, negative for an imaginary sphere; `None` for a plane.
    #[inline]
    #[must_use]
    pub fn radius_squared(self) -> Option<S> {
        self.dual().radius_squared()
    }
}

impl<S: Real<Mask = bool>> Sphere<S> {
    /// The radius; `None` for a plane and for an imaginary sphere.
    #[inline]
    #[must_use]
    pub fn radius(self) -> Option<S> {
        let squared = self.radius_squared()?;
        let is_real = squared.is_finite() && !squared.less_than(S::zero());
        is_real.then(|| squared.sqrt())
    }
}
