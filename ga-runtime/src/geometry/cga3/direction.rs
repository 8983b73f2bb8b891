//! Directions: free vectors and free bivectors.

use crate::cga3::{Direction, DualDirection};
use crate::scalar::Ring;

impl<S: Ring> Direction<S> {
    /// The free vector v as `v∧ei`.
    #[inline]
    #[must_use]
    pub fn from_vector([x, y, z]: [S; 3]) -> Self {
        Self::new(x, y, z)
    }

    /// The free vector v of `v∧ei`.
    #[inline]
    #[must_use]
    pub fn vector(self) -> [S; 3] {
        [self.e1i, self.e2i, self.e3i]
    }
}

impl<S: Ring> DualDirection<S> {
    /// The free bivector `B∧ei` perpendicular to a normal n: `B = n1 e23 − n2 e13 + n3 e12`, so
    /// that B is counterclockwise as seen from the tip of n.
    ///
    /// ```
    /// use ga_runtime::cga3::{Direction, DualDirection};
    /// let attitude = DualDirection::from_normal([1.0, 2.0, 3.0]);
    /// assert_eq!(attitude.normal(), [1.0, 2.0, 3.0]);
    /// assert_eq!(attitude.undual(), Direction::from_vector([-1.0, -2.0, -3.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_normal([x, y, z]: [S; 3]) -> Self {
        Self::new(z, -y, x)
    }

    /// The normal n of `B∧ei`. Its length is the weight.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 3] {
        [self.e23i, -self.e13i, self.e12i]
    }
}
