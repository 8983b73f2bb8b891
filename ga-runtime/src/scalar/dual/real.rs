//! Elementary functions of dual numbers.

use super::Dual;
use crate::scalar::{Real, Ring, Select, half_angle};

impl<S: Select + Ring, const N: usize> Select for Dual<S, N> {
    type Mask = S::Mask;

    #[inline(always)]
    fn select(mask: S::Mask, if_true: Self, if_false: Self) -> Self {
        Self::with(S::select(mask, if_true.value, if_false.value), |k| {
            S::select(mask, if_true.derivatives[k], if_false.derivatives[k])
        })
    }
}

impl<S: Real, const N: usize> Real for Dual<S, N> {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::constant(S::from_f64(value))
    }
    #[inline(always)]
    fn epsilon() -> Self {
        Self::constant(S::epsilon())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        // Without the sign of √−0, which is −0.
        self.chain(root, (root + root).abs().recip())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        let x = self.value;
        let one = S::one();
        // What is neither positive nor negative is zero or NaN, and so is its product with zero.
        let slope = S::select(S::zero().less_than(x), one, x * S::zero());
        let slope = S::select(x.less_than(S::zero()), -one, slope);
        self.chain(x.abs(), slope)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }
    // The derivatives of the polynomials approximate those of the functions as well.
    #[inline(always)]
    fn sine_by_angle(self) -> (Self, Self, Self) {
        let (cosine, ratio, slope) = self.value.sine_by_angle();
        let (a, b, c) = half_angle::sine_by_angle(self);
        (a.at_value(cosine), b.at_value(ratio), c.at_value(slope))
    }
    #[inline(always)]
    fn angle_by_sine(self) -> (Self, Self) {
        let (ratio, slope) = self.value.angle_by_sine();
        let (a, b) = half_angle::angle_by_sine(self);
        (a.at_value(ratio), b.at_value(slope))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let y = self;
        // Relative to the sum of magnitudes, so that squares do not overflow.
        let size = y.value.abs() + x.value.abs();
        let (sine, cosine) = (y.value / size, x.value / size);
        let is_regular = S::zero().less_than(size) & size.is_finite();
        let divisor = (sine * sine + cosine * cosine) * size;
        let slope = S::select(is_regular, divisor, size).recip();
        Self::with(y.value.atan2(x.value), |k| {
            let (dy, dx) = (y.derivatives[k], x.derivatives[k]);
            let rate = S::select(is_regular, cosine * dy - sine * dx, dy.abs() + dx.abs());
            moved(slope, rate)
        })
    }
    #[inline(always)]
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        let value = self.value.ln();
        let slope = self.value.abs().recip();
        // The logarithm of a negative number is NaN, and so is its slope.
        self.chain(
            value,
            S::select(self.value.less_than(S::zero()), value, slope),
        )
    }
    #[inline(always)]
    fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }
    #[inline(always)]
    fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        // 1/cosh² x = 4 e⁻²ˣ/(1 + e⁻²ˣ)² for x ≥ 0, without overflow.
        let half = (-self.value.abs()).exp();
        let slope = (half + half) / (S::one() + half * half);
        self.chain(self.value.tanh(), slope * slope)
    }
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        let (x, y) = (self, other);
        // The direction, from quotients that do not overflow. At the origin there is none, and the
        // slope is zero as that of |x| is; the same is taken at infinity.
        let size = x.value.abs().max(y.value.abs());
        let is_regular = S::zero().less_than(size) & size.is_finite();
        let divisor = S::select(is_regular, size, S::one());
        let leg = |value: S| S::select(is_regular, value / divisor, S::zero());
        let (cosine, sine) = (leg(x.value), leg(y.value));
        let ratio = S::select(is_regular, cosine.hypot(sine), S::one());
        let (cosine, sine) = (cosine / ratio, sine / ratio);
        Self::with(x.value.hypot(y.value), |k| {
            moved(cosine, x.derivatives[k]) + moved(sine, y.derivatives[k])
        })
    }
    #[inline(always)]
    fn less_than(self, other: Self) -> S::Mask {
        self.value.less_than(other.value)
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> S::Mask {
        self.value.less_or_equal(other.value)
    }
    #[inline(always)]
    fn equals(self, other: Self) -> S::Mask {
        self.value.equals(other.value)
    }
    #[inline(always)]
    fn is_finite(self) -> S::Mask {
        self.derivatives
            .iter()
            .fold(self.value.is_finite(), |all, rate| all & rate.is_finite())
    }
    #[inline(always)]
    fn is_zero(self) -> S::Mask {
        self.derivatives
            .iter()
            .fold(self.value.is_zero(), |all, rate| all & rate.is_zero())
    }
}

impl<S: Real, const N: usize> Dual<S, N> {
    /// The same derivatives with a value that was rounded in another way.
    #[inline(always)]
    fn at_value(self, value: S) -> Self {
        Self::with(value, |k| self.derivatives[k])
    }

    /// A function of this number, given its value and its slope here.
    #[inline(always)]
    fn chain(self, value: S, slope: S) -> Self {
        Self::with(value, |k| moved(slope, self.derivatives[k]))
    }
}

/// `slope · rate`, and zero where the rate is zero, even if the slope is infinite.
#[inline(always)]
fn moved<S: Real>(slope: S, rate: S) -> S {
    S::select(rate.is_zero(), S::zero(), slope * rate)
}
