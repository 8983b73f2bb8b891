//! Odd versors: reflections, inversions and their compositions.
//!
//! The pseudoscalar I commutes with everything, so an odd versor is `V = E I` with an even E, and
//! every product with V can be computed as one with E.

use core::ops::Mul;

use super::even_versor::{from_even, image_point};
use crate::cga3::{
    DualPlane, DualSphere, Even, EvenVersor, Multivector, Odd, OddVersor, Point, RoundVector,
};
use crate::scalar::{Mask, Maybe, Optional, Real, Ring};

crate::__private::surface! { { renormalized OddVersor } }

impl<S: Real> OddVersor<S> {
    /// The reflection in a plane, `n + d ei` with a normal of length 1. `None` where the normal is
    /// zero or not finite, or the distance is not.
    ///
    /// ```
    /// use ga_runtime::cga3::{DualPlane, OddVersor, Point};
    /// let mirror = OddVersor::reflection(DualPlane::new(0.0, 0.0, 2.0, 2.0)).unwrap();
    /// let image = mirror.transform_point(Point::new(5.0, 6.0, 7.0)).unwrap();
    /// assert_eq!(image, Point::new(5.0, 6.0, -5.0));
    /// ```
    #[must_use]
    pub fn reflection(plane: DualPlane<S>) -> Maybe<Self, S> {
        Self::from_vector(plane.into())
    }

    /// The inversion in a real sphere: x goes to `c + r² (x − c)/|x − c|²`. `None` where the sphere
    /// is imaginary or a point, or not finite, or its weight is zero.
    ///
    /// The inversion in an imaginary sphere, which is the inversion in the real sphere and then the
    /// reflection in its centre, preserves handedness; it is the [`EvenVersor`] `σ I⁻¹/|σ|`.
    ///
    /// ```
    /// use ga_runtime::cga3::{DualSphere, OddVersor, Point};
    /// let sphere = DualSphere::from_centre_radius(Point::new(1.0, 0.0, 0.0), 2.0);
    /// let inversion = OddVersor::inversion(sphere).unwrap();
    /// let image = inversion.transform_point(Point::new(2.0, 0.0, 0.0)).unwrap();
    /// assert_eq!(image, Point::new(5.0, 0.0, 0.0));
    /// assert_eq!(inversion.transform_point(Point::new(1.0, 0.0, 0.0)), None);
    /// ```
    #[must_use]
    pub fn inversion(sphere: DualSphere<S>) -> Maybe<Self, S> {
        Self::from_vector(sphere.into())
    }

    /// The versor of a vector with a positive square, normalised: the inversion in the sphere or
    /// the reflection in the plane whose dual it is. `None` where the square is not positive, or a
    /// coefficient is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{DualPlane, OddVersor, RoundVector};
    /// let mirror = DualPlane::new(0.0, 0.0, 2.0, 2.0);
    /// let versor = OddVersor::from_vector(RoundVector::from(mirror));
    /// assert_eq!(versor, OddVersor::reflection(mirror));
    /// ```
    #[must_use]
    pub fn from_vector(vector: RoundVector<S>) -> Maybe<Self, S> {
        let coefficients = [vector.e1, vector.e2, vector.e3, vector.eo, vector.ei];
        let largest = coefficients
            .into_iter()
            .fold(S::zero(), |most, x| most.max(x.abs()));
        let has_size = S::zero().less_than(largest) & vector.is_finite();
        // Each coefficient is divided separately, since the reciprocal of the smallest numbers is
        // out of range.
        let [e1, e2, e3, eo, ei] = coefficients.map(|x| x / largest);
        let vector = RoundVector::new(e1, e2, e3, eo, ei);
        let square = vector.scalar_product(vector);
        let unit = vector * square.sqrt().recip();
        let is_real = S::zero().less_than(square) & unit.ei.is_finite() & unit.eo.is_finite();
        (has_size & is_real).when(from_odd(unit.into()))
    }

    /// The versor nearest to a sum of odd versors; see [`EvenVersor::normalize`]. `None` where
    /// there is none.
    #[must_use]
    pub fn normalize(sum: Odd<S>) -> Maybe<Self, S> {
        // V = E I has V ~V = −E ~E, so E is not a unit versor. The product with a reflection is
        // even.
        let mirror = Odd {
            e1: S::one(),
            ..Odd::default()
        };
        let even = EvenVersor::normalize(even_part(sum) * even_part(mirror));
        even.map(|even| even * from_odd(-mirror))
    }

    /// The image of a point; `None` where it is at infinity, as that of the centre of an inversion,
    /// or beyond the range of the scalar.
    #[must_use]
    pub fn transform_point(self, point: Point<S>) -> Maybe<Point<S>, S> {
        image_point(self.transform(point))
    }
}

/// `V I⁻¹`.
pub(super) fn even_part<S: Ring>(odd: Odd<S>) -> Even<S> {
    Multivector::from(odd).dual().extract_even()
}

pub(super) fn times_pseudoscalar<S: Ring>(even: Even<S>) -> OddVersor<S> {
    from_odd(Multivector::from(even).undual().extract_odd())
}

fn from_odd<S>(o: Odd<S>) -> OddVersor<S> {
    OddVersor::new_unchecked(
        o.e1, o.e2, o.e3, o.eo, o.ei, o.e123, o.e12o, o.e13o, o.e23o, o.e12i, o.e13i, o.e23i,
        o.e1oi, o.e2oi, o.e3oi, o.e123oi,
    )
}

impl<S: Ring> Mul for OddVersor<S> {
    type Output = EvenVersor<S>;

    /// The versor that applies the right operand first, then the left one.
    #[inline]
    fn mul(self, other: Self) -> EvenVersor<S> {
        // I² = −1
        -from_even(even_part(self.into()) * even_part(other.into()))
    }
}

impl<S: Ring> Mul<EvenVersor<S>> for OddVersor<S> {
    type Output = Self;

    /// The versor that applies the right operand first, then the left one.
    #[inline]
    fn mul(self, other: EvenVersor<S>) -> Self {
        times_pseudoscalar(even_part(self.into()) * Even::from(other))
    }
}

impl<S: Ring> Mul<OddVersor<S>> for EvenVersor<S> {
    type Output = OddVersor<S>;

    /// The versor that applies the right operand first, then the left one.
    #[inline]
    fn mul(self, other: OddVersor<S>) -> OddVersor<S> {
        times_pseudoscalar(Even::from(self) * even_part(other.into()))
    }
}
