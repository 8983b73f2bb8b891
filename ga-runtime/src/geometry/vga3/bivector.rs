//! Bivectors of vga3.

use crate::cga3::MotorGenerator;
use crate::scalar::{Real, Ring};
use crate::vga3::{Bivector, Rotor, Vector};

impl<S: Ring> Bivector<S> {
    /// The bivector with a given normal by the right-hand rule, whose area is the length of the
    /// normal: `n I = n1 e23 − n2 e13 + n3 e12`.
    #[inline]
    #[must_use]
    pub fn from_normal([n1, n2, n3]: [S; 3]) -> Self {
        Self::new(n3, -n2, n1)
    }

    /// The normal by the right-hand rule, `dual(B) = −B I`.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 3] {
        [self.e23, -self.e13, self.e12]
    }
}

impl<S: Real<Mask = bool>> Bivector<S> {
    /// The area, `√−B²`, without intermediate overflow or underflow.
    #[inline]
    #[must_use]
    pub fn area(self) -> S {
        Vector::from(self.normal()).length()
    }

    /// The part of a vector in the plane of the bivector, `(a·B) B⁻¹`; `None` where B is zero or a
    /// number is not finite.
    #[must_use]
    pub fn project(self, vector: Vector<S>) -> Option<Vector<S>> {
        vector.reject(self.normal().into())
    }

    /// The rotor `exp(B) = cos |B| + sin |B| B/|B|`: for `B = −½θb` with a unit bivector b, a
    /// rotation by θ in its sense. NaN stays NaN.
    ///
    /// ```
    /// use ga_runtime::vga3::{Bivector, Vector};
    /// let quarter = Bivector::new(-0.25 * std::f64::consts::PI, 0.0, 0.0).exp();
    /// let [x, y, z] = quarter.transform(Vector::new(1.0, 0.0, 3.0)).coordinates();
    /// assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 3.0);
    /// ```
    #[must_use]
    pub fn exp(self) -> Rotor<S> {
        let zero = S::zero();
        MotorGenerator::new(self.e12, self.e13, self.e23, zero, zero, zero)
            .exp()
            .rotor()
            .into()
    }
}
