//! Even versors: normalisation, roots, powers and interpolation.

use core::ops::Mul;

use super::conformal_exponential::{coefficients, is_finite};
use super::conformal_logarithm::parts;
use crate::cga3::{Even, EvenVersor, Point, RoundVector};
use crate::scalar::{Mask, Maybe, Real, Ring};

crate::__private::surface! { { renormalized EvenVersor } }

impl<S: Real> EvenVersor<S> {
    /// The versor `N^(−½) X` nearest to a sum of even versors, with `N = X ~X`, a scalar and a
    /// 4-vector (the polar decomposition of Dorst and Valkenburg, 2011). A positive multiple of a
    /// versor gives that versor.
    ///
    /// `None` where N has no such root: X is zero, not finite, or not invertible within rounding;
    /// or it reverses orientation, `X ~X < 0`. Such an X is the pseudoscalar times an
    /// [`OddVersor`](crate::cga3::OddVersor).
    ///
    /// ```
    /// use ga_runtime::cga3::{Even, EvenVersor, Transversor};
    /// let a = Even::from(Transversor::from_vector([0.0_f64, 0.2, 0.0]));
    /// let middle = EvenVersor::normalize(a + Even::from(EvenVersor::default())).unwrap();
    /// assert!((middle.e2o() + 0.1).abs() < 1e-15);
    /// assert_eq!(
    ///     EvenVersor::normalize(Even::default() - a),
    ///     EvenVersor::normalize(a).map(|v| -v)
    /// );
    /// ```
    #[must_use]
    pub fn normalize(sum: Even<S>) -> Maybe<Self, S> {
        let largest = coefficients(sum)
            .into_iter()
            .fold(S::zero(), |most, x| most.max(x.abs()));
        let has_size = is_finite(sum) & S::zero().less_than(largest);
        let sum = sum / largest;
        let norm = sum * sum.reverse();
        let (scalar, rest) = (norm.scalar, norm.extract_quadvector());
        let square = rest.scalar_product(rest);
        let root_squared = scalar * scalar - square;
        let root = root_squared.max(S::zero()).sqrt();
        // scalar + root, computed without cancellation for a negative scalar.
        let mut divisor = scalar + root;
        let is_negative = scalar.less_than(S::zero());
        if is_negative.any() {
            divisor = S::select(is_negative, -square / (root - scalar), divisor);
        }
        let size = coefficients(sum)
            .into_iter()
            .fold(S::zero(), |total, x| total + x * x);
        let least = S::epsilon() * size;
        let is_invertible = least.less_than(root) & least.less_than(divisor);
        // N^(−½) = (scalar + root − rest)/(root √(2 (scalar + root)))
        let factor = (root * (divisor + divisor).sqrt()).recip();
        let inverse_root = Even {
            scalar: divisor * factor,
            ..Even::from(rest * -factor)
        };
        let versor = from_even(inverse_root * sum);
        (has_size & is_invertible & is_finite(versor.into())).when(versor)
    }

    /// The image of a point; `None` where it is at infinity, or beyond the range of the scalar.
    #[must_use]
    pub fn transform_point(self, point: Point<S>) -> Maybe<Point<S>, S> {
        image_point(self.transform(point))
    }
}

impl<S: Real<Mask = bool>> EvenVersor<S> {
    /// The versor R with `R R = V` and half the logarithm. It is `1 + V`, normalised, where that is
    /// well away from zero. `None` only where V is not finite, or so large that the root cannot be
    /// computed.
    #[must_use]
    pub fn sqrt(self) -> Option<Self> {
        let (scalar, _, rest) = parts(self);
        let square = rest.scalar_product(rest);
        let least = S::one() + scalar - square.max(S::zero()).sqrt();
        if S::from_ratio(1, 2).less_than(least) {
            let even = Even::from(self);
            return Self::normalize(Even {
                scalar: even.scalar + S::one(),
                ..even
            });
        }
        self.powf(S::from_ratio(1, 2))
    }

    /// The power `exp(t log V)`. `None` where t or V is not finite, or the power is beyond the
    /// range of the scalar.
    #[must_use]
    pub fn powf(self, t: S) -> Option<Self> {
        (self.log() * t).exp()
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1: `V exp(t log(~V W))`, with W or
    /// −W, whichever gives the smaller rotation. `None` as for [`powf`](Self::powf).
    ///
    /// ```
    /// use ga_runtime::cga3::{EvenVersor, Transversor};
    /// let [a, b] = [[1.0_f64, 0.0, 0.0], [3.0, 2.0, 0.0]]
    ///     .map(|k| EvenVersor::from(Transversor::from_vector(k)));
    /// let middle = a.interpolate(b, 0.5).unwrap();
    /// assert!((middle.e1o() + 2.0).abs() < 1e-15 && (middle.e2o() + 1.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Option<Self> {
        let between = self.reverse() * other;
        let between = if between.scalar().less_than(S::zero()) {
            -between
        } else {
            between
        };
        Some(self * between.powf(t)?)
    }
}

/// The point that a null vector represents.
pub(super) fn image_point<S: Real>(image: RoundVector<S>) -> Maybe<Point<S>, S> {
    let [x, y, z] = [image.e1, image.e2, image.e3].map(|x| x / image.eo);
    let is_place = x.is_finite() & y.is_finite() & z.is_finite();
    is_place.when(Point::new(x, y, z))
}

pub(super) fn from_even<S: Ring>(e: Even<S>) -> EvenVersor<S> {
    EvenVersor::new_unchecked(
        e.scalar, e.e12, e.e13, e.e23, e.e1o, e.e2o, e.e3o, e.e1i, e.e2i, e.e3i, e.eoi, e.e123o,
        e.e123i, e.e12oi, e.e13oi, e.e23oi,
    )
}

impl<S: Ring> Mul for EvenVersor<S> {
    type Output = Self;

    /// The versor that applies the right operand first, then the left one.
    #[inline]
    fn mul(self, other: Self) -> Self {
        from_even(Even::from(self) * Even::from(other))
    }
}
