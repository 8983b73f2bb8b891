//! Vector registers of the `wide` crate.

use core::ops::{BitAnd, BitOr, Not};

use wide::{f32x4, f32x8, f64x2, f64x4};

use super::{ConstRing, Field, Mask, Masked, Real, Ring, Select};

/// The outcome of a comparison of vectors of the `wide` crate, with feature `wide`.
///
/// `wide` chooses its instructions by the target features of the whole build, also inside a
/// function that enables more of them; there [`Lanes`](super::Lanes) are the better choice.
///
/// Elementary functions are the polynomials of `wide`. Where those fail, for angles beyond 10³ in
/// `f32` and 10⁵ in `f64` and for logarithms of numbers that are not positive, normal and finite,
/// all lanes go through the scalar functions instead. The polynomials are within 4 units in the
/// last place of the scalar functions, sine and cosine within 2 ε absolutely. All other operations
/// give, bit for bit, the results of a single number.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_runtime::scalar::{Mask, Real};
/// use wide::f64x4;
///
/// let p = Point::new(f64x4::from([0.0, 3.0, 6.0, 9.0]), f64x4::splat(0.0), f64x4::splat(0.0));
/// let q = Point::new(f64x4::splat(0.0), f64x4::from([0.0, 4.0, 8.0, 12.0]), f64x4::splat(0.0));
/// let distance = p.distance_squared(q).sqrt();
/// assert_eq!(distance, f64x4::from([0.0, 5.0, 10.0, 15.0]));
/// assert!(distance.less_than(f64x4::splat(20.0)).all());
/// ```
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct WideMask<V>(V);

macro_rules! implement_field {
    ($type:ident of $scalar:ident) => {
        impl Ring for $type {
            #[inline(always)]
            fn zero() -> Self {
                Self::ZERO
            }
            #[inline(always)]
            fn one() -> Self {
                Self::ONE
            }
            #[inline(always)]
            fn from_integer(value: i64) -> Self {
                Self::splat(value as $scalar)
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                Self::mul_add(self, factor, summand)
            }
            #[inline(always)]
            fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
                Self::mul_sub(self, factor, subtrahend)
            }
            #[inline(always)]
            fn neg_mul_add(self, factor: Self, summand: Self) -> Self {
                Self::mul_neg_add(self, factor, summand)
            }
        }

        impl ConstRing for $type {
            const ZERO: Self = Self::ZERO;
            const ONE: Self = Self::ONE;
        }

        impl Field for $type {
            #[inline(always)]
            fn from_ratio(numerator: i64, denominator: i64) -> Self {
                Self::splat(numerator as $scalar / denominator as $scalar)
            }
            // The reciprocal of `wide` itself is accurate to twelve bits only.
            #[inline(always)]
            fn recip(self) -> Self {
                Self::ONE / self
            }
            #[inline(always)]
            fn recip_or_zero(self) -> Self {
                self.simd_eq(Self::ZERO)
                    .select(Self::ZERO, Self::ONE / self)
            }
            #[inline(always)]
            fn div_or_zero(self, divisor: Self) -> Self {
                let quotient = self / divisor;
                divisor.simd_eq(Self::ZERO).select(Self::ZERO, quotient)
            }
            #[inline(always)]
            fn is_invertible(self) -> bool {
                !self.simd_eq(Self::ZERO).any()
            }
        }
    };
}

macro_rules! implement_real {
    ($type:ident of $scalar:ident, largest angle $angle:literal) => {
        impl Select for $type {
            type Mask = WideMask<Self>;

            #[inline(always)]
            fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self {
                mask.0.select(if_true, if_false)
            }
        }

        impl Real for $type {
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                Self::splat(value as $scalar)
            }
            #[inline(always)]
            fn epsilon() -> Self {
                Self::splat($scalar::EPSILON)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self::sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self::abs(self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                if self.abs().simd_le(Self::splat($angle)).all() {
                    return Self::sin_cos(self);
                }
                let (mut sine, mut cosine) = (self.to_array(), self.to_array());
                for (sine, cosine) in sine.iter_mut().zip(&mut cosine) {
                    (*sine, *cosine) = Real::sin_cos(*sine);
                }
                (Self::new(sine), Self::new(cosine))
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                Self::atan2(self, x)
            }
            #[inline]
            fn exp(self) -> Self {
                Self::exp(self)
            }
            #[inline]
            fn ln(self) -> Self {
                let is_normal = self.simd_ge(Self::splat($scalar::MIN_POSITIVE));
                if (is_normal & Self::is_finite(self)).all() {
                    return Self::ln(self);
                }
                Self::new(self.to_array().map(Real::ln))
            }
            #[inline]
            fn sinh(self) -> Self {
                Self::new(self.to_array().map(Real::sinh))
            }
            #[inline]
            fn cosh(self) -> Self {
                Self::new(self.to_array().map(Real::cosh))
            }
            #[inline]
            fn tanh(self) -> Self {
                Self::new(self.to_array().map(Real::tanh))
            }
            #[inline]
            fn hypot(self, other: Self) -> Self {
                let (mut lengths, others) = (self.to_array(), other.to_array());
                for (length, other) in lengths.iter_mut().zip(others) {
                    *length = Real::hypot(*length, other);
                }
                Self::new(lengths)
            }
            #[inline(always)]
            fn less_than(self, other: Self) -> Self::Mask {
                WideMask(self.simd_lt(other))
            }
            #[inline(always)]
            fn less_or_equal(self, other: Self) -> Self::Mask {
                WideMask(self.simd_le(other))
            }
            #[inline(always)]
            fn equals(self, other: Self) -> Self::Mask {
                WideMask(self.simd_eq(other))
            }
            #[inline(always)]
            fn is_finite(self) -> Self::Mask {
                WideMask(Self::is_finite(self))
            }
            #[inline(always)]
            fn is_zero(self) -> Self::Mask {
                WideMask(self.simd_eq(Self::ZERO))
            }
        }
    };
}

macro_rules! implement_mask {
    ($type:ident of $scalar:ident) => {
        impl Mask for WideMask<$type> {
            type Maybe<T> = Masked<T, Self>;

            #[inline(always)]
            fn splat(value: bool) -> Self {
                let bits = if value { !0 } else { 0 };
                Self($type::splat($scalar::from_bits(bits)))
            }
            #[inline(always)]
            fn any(self) -> bool {
                self.0.any()
            }
            #[inline(always)]
            fn all(self) -> bool {
                self.0.all()
            }
            #[inline(always)]
            fn lane(self, lane: usize) -> bool {
                self.0.to_array()[lane].to_bits() != 0
            }
            #[inline(always)]
            fn when<T>(self, value: T) -> Masked<T, Self> {
                Masked::new(self, value)
            }
        }

        impl BitAnd for WideMask<$type> {
            type Output = Self;
            #[inline(always)]
            fn bitand(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
        }

        impl BitOr for WideMask<$type> {
            type Output = Self;
            #[inline(always)]
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }

        impl Not for WideMask<$type> {
            type Output = Self;
            #[inline(always)]
            fn not(self) -> Self {
                Self(!self.0)
            }
        }
    };
}

macro_rules! implement_wide {
    ($($type:ident of $scalar:ident, largest angle $angle:literal;)*) => { $(
        implement_field!($type of $scalar);
        implement_real!($type of $scalar, largest angle $angle);
        implement_mask!($type of $scalar);
    )* };
}

implement_wide! {
    f32x4 of f32, largest angle 1e3;
    f32x8 of f32, largest angle 1e3;
    f64x2 of f64, largest angle 1e5;
    f64x4 of f64, largest angle 1e5;
}
