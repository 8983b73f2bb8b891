//! Vectors perpendicular to a given one.

use crate::scalar::Real;
use crate::vga3::Vector;

impl<S: Real<Mask = bool>> Vector<S> {
    /// A unit vector perpendicular to this one; `None` where this one is zero or not finite.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let v = Vector::new(1.0_f64, 2.0, 3.0);
    /// let u = v.any_perpendicular().unwrap();
    /// assert!(v.dot(u).abs() < 1e-15 && (u.length() - 1.0).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn any_perpendicular(self) -> Option<Self> {
        let [u, _] = self.normalized()?.orthonormal_pair();
        Some(u)
    }

    /// Two unit vectors u, v that form a right-handed orthonormal basis with this vector n, which
    /// must have length 1: `u × v = n`.
    ///
    /// The choice is deterministic: u is perpendicular to the coordinate axis that makes the
    /// largest angle with n, the first of several.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let n = Vector::new(0.6_f64, 0.0, 0.8);
    /// let [u, v] = n.orthonormal_pair();
    /// assert!(u.cross(v).distance(n) < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn orthonormal_pair(self) -> [Self; 2] {
        let [x, y, z] = self.abs().coordinates();
        let (zero, one) = (S::zero(), S::one());
        let axis = if !y.less_than(x) && !z.less_than(x) {
            Self::new(one, zero, zero)
        } else if !z.less_than(y) {
            Self::new(zero, one, zero)
        } else {
            Self::new(zero, zero, one)
        };
        let u = axis.cross(self).normalized().unwrap_or(axis);
        [u, self.cross(u)]
    }

    /// The [`orthonormal_pair`](Self::orthonormal_pair) u, v of this unit vector n for which u is
    /// horizontal, that is perpendicular to `up`: `u = up × n / |up × n|`, so that v lies on the
    /// side of `up`. Where `up` is zero, or parallel to n within √ε, it is any such pair.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let pair = Vector::new(0.0, -1.0, 0.0).orthonormal_pair_with_up(Vector::new(0.0, 0.0, 2.0));
    /// assert_eq!(pair, [Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 0.0, 1.0)]);
    /// ```
    #[must_use]
    pub fn orthonormal_pair_with_up(self, up: Self) -> [Self; 2] {
        let horizontal = up.normalized().and_then(|up| {
            let across = up.cross(self);
            let is_across = S::epsilon().sqrt().less_than(across.length());
            is_across.then(|| across.normalized())?
        });
        match horizontal {
            Some(u) => [u, self.cross(u)],
            None => self.orthonormal_pair(),
        }
    }
}
