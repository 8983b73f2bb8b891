//! Dilators.

use crate::cga3::Dilator;
use crate::scalar::Real;

impl<S: Real<Mask = bool>> Dilator<S> {
    /// The scaling by s about the origin, `D = exp(½ ln s · eo∧ei) = cosh(½ ln s) + sinh(½ ln s) eo∧ei`. `None` where s is
    /// not positive and finite. The image of a point has weight 1/s.
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

    /// The factor s, `(cosh + sinh)²` or `1/(cosh − sinh)²`, whichever does not cancel.
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
