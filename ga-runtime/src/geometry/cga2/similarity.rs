//! Dilators and similarities of cga2.

use crate::cga2::{Dilator, Similarity};
use crate::geometry::vector2::dot;
use crate::scalar::Real;

impl<S: Real<Mask = bool>> Dilator<S> {
    /// The scaling by s about the origin, `D = exp(½ ln s · eo∧ei)`; `None` where s is not positive
    /// and finite.
    ///
    /// ```
    /// use ga_runtime::cga2::{Dilator, Point};
    /// let image = Dilator::from_factor(4.0).unwrap().transform(Point::new(1.0, 2.0));
    /// assert_eq!(image.centre(), Some(Point::new(4.0, 8.0)));
    /// // Its weight is 1/s.
    /// assert_eq!(image.eo, 0.25);
    /// ```
    #[must_use]
    pub fn from_factor(factor: S) -> Option<Self> {
        if !S::zero().less_than(factor) || !factor.is_finite() {
            return None;
        }
        let root = factor.sqrt();
        let (inverse, half) = (root.recip(), S::from_ratio(1, 2));
        Some(Self::new_unchecked(
            half * (root + inverse),
            half * (root - inverse),
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
}

impl<S: Real<Mask = bool>> Similarity<S> {
    /// The factor s by which all lengths are multiplied.
    ///
    /// ```
    /// use ga_runtime::cga2::{Dilator, Rotor, Translator};
    /// let motor = Translator::from_displacement([1.0, 2.0]) * Rotor::from_angle(0.5).unwrap();
    /// let similarity = motor * Dilator::from_factor(4.0).unwrap();
    /// assert!((similarity.factor() - 4.0_f64).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn factor(self) -> S {
        // (scalar, e12) is a rotor times cosh, (eoi, e12oi) the same times sinh.
        let (c, s) = ([self.scalar(), self.e12()], [self.eoi(), self.e12oi()]);
        let cross = dot(c, s);
        let squared = dot(c, c) + dot(s, s) + (cross.abs() + cross.abs());
        if cross.less_than(S::zero()) {
            squared.recip()
        } else {
            squared
        }
    }
}
