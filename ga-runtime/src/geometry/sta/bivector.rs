//! Bivectors of spacetime: electromagnetic fields, and generators of Lorentz transformations.

use super::complex::Complex;
use super::velocity::NotSlowerThanLight;
use crate::geometry::number::are_numbers;
use crate::scalar::{Real, Ring};
use crate::sta::{Bivector, Rotor};
use crate::vga3::Vector;

impl<S: Ring> Bivector<S> {
    /// The field `F = E + I B` with the electric and magnetic fields of the observer g0: the
    /// coefficient of gk0 is `Ek` and that of `I gk0` is `Bk`, in units with c = 1.
    #[inline]
    #[must_use]
    pub fn from_fields(electric: [S; 3], magnetic: [S; 3]) -> Self {
        let ([e1, e2, e3], [b1, b2, b3]) = (electric, magnetic);
        Self::new(e1, e2, e3, b1, b2, b3)
    }

    /// The electric field E, the coefficients of g10, g20, g30.
    ///
    /// In a generator these coefficients generate boosts.
    #[inline]
    #[must_use]
    pub fn electric(self) -> [S; 3] {
        [self.g10, self.g20, self.g30]
    }

    /// The magnetic field B, the coefficients of g32, g13, g21.
    ///
    /// In a generator these coefficients generate rotations.
    #[inline]
    #[must_use]
    pub fn magnetic(self) -> [S; 3] {
        [self.g32, self.g13, self.g21]
    }

    /// The Lorentz invariants, which are the same for all observers, `E² − B²` and `E·B`:
    /// `F² = (E² − B²) + 2 (E·B) I`.
    ///
    /// ```
    /// use ga_runtime::sta::Bivector;
    /// // Both vanish for a plane wave.
    /// let wave = Bivector::from_fields([1, 0, 0], [0, 1, 0]);
    /// assert_eq!(wave.invariants(), (0, 0));
    /// ```
    #[inline]
    #[must_use]
    pub fn invariants(self) -> (S, S) {
        let [e, b] = [self.electric(), self.magnetic()].map(Vector::from);
        (e.dot(e) - b.dot(b), e.dot(b))
    }
}

impl<S: Real<Mask = bool>> Bivector<S> {
    /// The field in the frame of an observer who moves at a velocity v relative to g0, on axes
    /// parallel to those of g0: `~L F L` with the boost L by v.
    ///
    /// # Errors
    ///
    /// [`NotSlowerThanLight`] where |v| is not below 1.
    ///
    /// ```
    /// use ga_runtime::sta::Bivector;
    /// // An observer who moves across a magnetic field measures an electric field, v × B times γ.
    /// let field = Bivector::from_fields([0.0_f64; 3], [0.0, 0.0, 4.0]);
    /// let [_, y, _] = field.seen_from([0.6, 0.0, 0.0]).unwrap().electric();
    /// assert!((y + 3.0).abs() < 1e-15);
    /// ```
    pub fn seen_from(self, velocity: [S; 3]) -> Result<Self, NotSlowerThanLight<S>> {
        Ok(Rotor::from_velocity(velocity)?.reverse().transform(self))
    }

    /// The rotor `exp(F)`: `½φσ` with a unit relative vector σ boosts by the rapidity φ, `−½θ Iσ`
    /// rotates by θ about σ, and every other F combines both in commuting planes, or is null.
    /// `None` where a number is not finite, or the boost beyond the range of the scalar.
    ///
    /// F² is a complex number `a + b I`, so that `exp(F) = cosh z + (sinh z/z) F` with `z² = F²`.
    /// For a null F, whose square is subject to cancellation, the error grows with |F|².
    ///
    /// ```
    /// use ga_runtime::sta::Bivector;
    /// let boost = Bivector::from_fields([0.5, 0.0, 0.0], [0.0; 3]).exp().unwrap();
    /// let [x, _, _]: [f64; 3] = boost.velocity();
    /// assert!((x - 1.0_f64.tanh()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn exp(self) -> Option<Rotor<S>> {
        let root = self.square().root();
        let (cosine, ratio) = (root.cosh(), root.sinh_ratio());
        assemble(cosine, self.times(ratio))
    }

    /// F² as a complex number.
    pub(super) fn square(self) -> Complex<S> {
        let (scalar, product) = self.invariants();
        Complex::new(scalar, product + product)
    }

    /// `(a + b I) F`; multiplication by I maps E to B and B to −E.
    pub(super) fn times(self, number: Complex<S>) -> Self {
        let (a, b) = (number.real, number.imaginary);
        let (e, m) = (self.electric(), self.magnetic());
        Self::from_fields(
            [0, 1, 2].map(|k| e[k] * a - m[k] * b),
            [0, 1, 2].map(|k| m[k] * a + e[k] * b),
        )
    }
}

/// The rotor of a complex number `a + b I` and a bivector; `None` where a coefficient is not
/// finite.
fn assemble<S: Real<Mask = bool>>(number: Complex<S>, bivector: Bivector<S>) -> Option<Rotor<S>> {
    let ([x, y, z], [u, v, w]) = (bivector.electric(), bivector.magnetic());
    let usable = are_numbers([x, y, z])
        && are_numbers([u, v, w])
        && are_numbers([number.real, number.imaginary, S::zero()]);
    usable.then(|| Rotor::new_unchecked(number.real, x, y, z, u, v, w, number.imaginary))
}
