//! Dilators.

use crate::cga3::{Dilator, Point};
use crate::scalar::{Real, versor_exponential, versor_logarithm};

impl<S: Real<Mask = bool>> Dilator<S> {
    /// The scaling by s about the origin, `D = exp(½ ln s · eo∧ei) = cosh(½ ln s) + sinh(½ ln s)
    /// eo∧ei`. `None` where s is not positive and finite. The image of a point has weight 1/s.
    ///
    /// ```
    /// use ga_runtime::cga3::{Dilator, Point};
    /// let double = Dilator::from_factor(2.0_f64).unwrap();
    /// let image = double.transform(Point::new(1.0, 2.0, 3.0));
    /// let [x, y, z] = image.centre().unwrap().coordinates();
    /// assert!((x - 2.0).abs() < 1e-14 && (y - 4.0).abs() < 1e-14 && (z - 6.0).abs() < 1e-14);
    /// assert!((image.eo - 0.5).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn from_factor(factor: S) -> Option<Self> {
        if !S::zero().less_than(factor) || !factor.is_finite() {
            return None;
        }
        let root = factor.sqrt();
        let (half, inverse) = (S::from_ratio(1, 2), root.recip());
        Some(Self::new_unchecked(
            (root + inverse) * half,
            (root - inverse) * half,
        ))
    }

    /// The factor s, `(cosh + sinh)²` or `1/(cosh − sinh)²`, whichever is computed without
    /// cancellation.
    #[inline]
    #[must_use]
    pub fn factor(self) -> S {
        let root = self.scalar() + self.eoi().abs();
        let squared = root * root;
        if self.eoi().less_than(S::zero()) {
            squared.recip()
        } else {
            squared
        }
    }

    /// The scaling `exp(a eo∧ei) = cosh a + sinh a eo∧ei` by `e²ᵃ`. `None` where a is not finite,
    /// or so large that the coefficients are not: beyond about 710 in `f64` and 89 in `f32`.
    ///
    /// ```
    /// use ga_runtime::cga3::Dilator;
    /// let double = Dilator::exp(0.5 * 2.0_f64.ln()).unwrap();
    /// assert!((double.factor() - 2.0).abs() < 1e-15);
    /// assert!((double.log() - 0.5 * 2.0_f64.ln()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn exp(a: S) -> Option<Self> {
        let (cosine, ratio, _) = versor_exponential(a * a);
        let sine = ratio * a;
        let is_finite = cosine.is_finite() && sine.is_finite();
        is_finite.then(|| Self::new_unchecked(cosine, sine))
    }

    /// The coefficient a of `log D = a eo∧ei`, half of the logarithm of the factor. A dilator and
    /// its negative are the same scaling; for the negative, which is not an exponential, a is that
    /// of the dilator.
    #[must_use]
    pub fn log(self) -> S {
        let sine = self.eoi();
        let (ratio, _) = versor_logarithm(self.scalar().abs(), sine * sine);
        let upright = S::select(self.scalar().less_than(S::zero()), -sine, sine);
        upright * ratio
    }

    /// The scaling by `sᵗ`. `None` where that is beyond the range of the coefficients, as for
    /// [`exp`](Self::exp), or t is not finite.
    #[must_use]
    pub fn powf(self, t: S) -> Option<Self> {
        Self::exp(self.log() * t)
    }

    /// The scaling by √s, `(1 + D)/|1 + D|`. For the negative of a dilator, which is the same
    /// scaling and has no root, the root of the dilator.
    ///
    /// ```
    /// use ga_runtime::cga3::Dilator;
    /// let nine = Dilator::from_factor(9.0_f64).unwrap();
    /// assert!((nine.sqrt().factor() - 3.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn sqrt(self) -> Self {
        let half = S::from_ratio(1, 2);
        let cosine = (half * self.scalar().abs() + half).sqrt();
        let sine = half * self.eoi() / cosine;
        let is_negative = self.scalar().less_than(S::zero());
        Self::new_unchecked(cosine, S::select(is_negative, -sine, sine))
    }

    /// The image of a point, divided by its weight: `s x`.
    #[inline]
    #[must_use]
    pub fn transform_point(self, point: Point<S>) -> Point<S> {
        let factor = self.factor();
        Point::from(point.coordinates().map(|x| x * factor))
    }
}
