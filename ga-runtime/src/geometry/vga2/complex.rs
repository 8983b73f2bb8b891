//! Complex numbers of vga2: products of two vectors.

use crate::geometry::number::are_numbers;
use crate::geometry::vector2::length;
use crate::scalar::{Real, Ring};
use crate::vga2::{Complex, Vector};

impl<S: Ring> Complex<S> {
    /// The real part.
    #[inline]
    #[must_use]
    pub fn real(self) -> S {
        self.scalar
    }

    /// The imaginary part, the coefficient of e12.
    #[inline]
    #[must_use]
    pub fn imaginary(self) -> S {
        self.e12
    }

    /// The vector `x e1 + y e2 = e1 z` of the number `x + y e12`.
    #[inline]
    #[must_use]
    pub fn to_vector(self) -> Vector<S> {
        Vector::new(self.scalar, self.e12)
    }
}

impl<S: Real<Mask = bool>> Complex<S> {
    /// The number `r (cos φ + sin φ e12)`; `None` where a number is not finite.
    ///
    /// ```
    /// use ga_runtime::vga2::Complex;
    /// let i = Complex::from_polar(1.0, std::f64::consts::FRAC_PI_2).unwrap();
    /// assert!(i.real().abs() < 1e-15 && i.imaginary() == 1.0);
    /// ```
    #[must_use]
    pub fn from_polar(modulus: S, argument: S) -> Option<Self> {
        let (sine, cosine) = argument.sin_cos();
        let parts = [modulus * cosine, modulus * sine];
        are_numbers(parts).then(|| Self::new(parts[0], parts[1]))
    }

    /// The modulus `|z|`, without intermediate overflow or underflow.
    #[inline]
    #[must_use]
    pub fn modulus(self) -> S {
        length([self.scalar, self.e12])
    }

    /// The argument in (−π, π]; `None` for zero and for numbers that are not finite.
    #[must_use]
    pub fn argument(self) -> Option<S> {
        let modulus = self.modulus();
        let usable = S::zero().less_than(modulus) && modulus.is_finite();
        usable.then(|| self.e12.atan2(self.scalar))
    }
}
