//! Numbers with the size of the terms of which they are the sum.

use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::scalar::{Field, Real, Ring, Single};

/// A number with its size before cancellation: the sum of the absolute values of all products that
/// were added to obtain it.
///
/// Over this scalar the check of a unit versor measures each defect relative to the terms that have
/// cancelled in it: [`Real::abs`] divides by half the size, where that is above 1.
#[derive(Clone, Copy, Debug)]
pub struct Relative<S> {
    value: S,
    size: S,
}

impl<S: Real<Mask = bool>> Relative<S> {
    /// A number that is not a sum of others.
    #[inline]
    #[must_use]
    pub fn new(value: S) -> Self {
        let size = value.abs();
        Self { value, size }
    }
}

impl<S: PartialEq> PartialEq for Relative<S> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<S: Real<Mask = bool>> Add for Relative<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            size: self.size + other.size,
        }
    }
}

impl<S: Real<Mask = bool>> Sub for Relative<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<S: Real<Mask = bool>> Mul for Relative<S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            size: self.size * other.size,
        }
    }
}

impl<S: Real<Mask = bool>> Div for Relative<S> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        Self {
            value: self.value / other.value,
            size: self.size / other.value.abs(),
        }
    }
}

impl<S: Real<Mask = bool>> Neg for Relative<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            size: self.size,
        }
    }
}

impl<S: Real<Mask = bool>> AddAssign for Relative<S> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Real<Mask = bool>> SubAssign for Relative<S> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<S: Real<Mask = bool>> MulAssign for Relative<S> {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<S: Real<Mask = bool>> Ring for Relative<S> {
    #[inline]
    fn zero() -> Self {
        Self::new(S::zero())
    }
    #[inline]
    fn one() -> Self {
        Self::new(S::one())
    }
    #[inline]
    fn from_integer(value: i64) -> Self {
        Self::new(S::from_integer(value))
    }
}

impl<S: Real<Mask = bool>> Field for Relative<S> {
    #[inline]
    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Self::new(S::from_ratio(numerator, denominator))
    }
}

impl<S> Single for Relative<S> {}

/// All operations except sums and products reset the size to that of the result.
impl<S: Real<Mask = bool>> Real for Relative<S> {
    #[inline]
    fn from_f64(value: f64) -> Self {
        Self::new(S::from_f64(value))
    }
    #[inline]
    fn epsilon() -> Self {
        Self::new(S::epsilon())
    }
    #[inline]
    fn sqrt(self) -> Self {
        Self::new(self.value.sqrt())
    }
    /// The absolute value, relative to half the size where that is above 1.
    #[inline]
    fn abs(self) -> Self {
        Self {
            value: self.value.abs() / (self.size * S::from_ratio(1, 2)).max(S::one()),
            size: self.size,
        }
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (Self::new(sine), Self::new(cosine))
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        Self::new(self.value.atan2(x.value))
    }
    #[inline]
    fn exp(self) -> Self {
        Self::new(self.value.exp())
    }
    #[inline]
    fn ln(self) -> Self {
        Self::new(self.value.ln())
    }
    #[inline]
    fn less_than(self, other: Self) -> bool {
        self.value.less_than(other.value)
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.size.is_finite()
    }
    #[inline]
    fn is_zero(self) -> bool {
        self.value.is_zero()
    }
}
