//! `f32` and `f64`.

use core::ops::Mul;

use super::real::angle_by_sine_one_by_one;
use super::{ArcFactors, ConstRing, Field, Lanes, Real, Ring, Single, arc, half_angle};
use crate::cga3::Motor;
use crate::geometry::composition::compose_single;

/// Elementary functions, from the library that the features select.
#[cfg(feature = "std")]
macro_rules! elementary {
    ($type:ty, $standard:ident, $free:ident, $($argument:expr),+) => {
        <$type>::$standard($($argument),+)
    };
}
#[cfg(all(not(feature = "std"), feature = "libm"))]
macro_rules! elementary {
    ($type:ty, $standard:ident, $free:ident, $($argument:expr),+) => {
        libm::$free($($argument),+)
    };
}
// Without either feature, lib.rs reports one error; this definition avoids further ones.
#[cfg(not(any(feature = "std", feature = "libm")))]
macro_rules! elementary {
    ($type:ty, $standard:ident, $free:ident, $($argument:expr),+) => {{
        $(let _ = $argument;)+
        <$type>::NAN
    }};
}

macro_rules! implement_field {
    ($type:ident) => {
        impl Ring for $type {
            #[inline]
            fn zero() -> Self {
                0.0
            }
            #[inline]
            fn one() -> Self {
                1.0
            }
            #[inline]
            fn from_integer(value: i64) -> Self {
                value as $type
            }
            #[inline]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                // Without the instruction the fused form is a slow library call.
                #[cfg(all(feature = "std", target_feature = "fma"))]
                {
                    <$type>::mul_add(self, factor, summand)
                }
                #[cfg(not(all(feature = "std", target_feature = "fma")))]
                {
                    self * factor + summand
                }
            }
            #[inline]
            fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
                Ring::mul_add(self, factor, -subtrahend)
            }
            #[inline]
            fn neg_mul_add(self, factor: Self, summand: Self) -> Self {
                Ring::mul_add(-self, factor, summand)
            }
        }

        impl ConstRing for $type {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
        }

        impl Field for $type {
            #[inline]
            fn from_ratio(numerator: i64, denominator: i64) -> Self {
                numerator as $type / denominator as $type
            }
        }
    };
}

macro_rules! implement_real {
    (
        $type:ident, by $sine_by_angle:ident, $angle_by_sine:ident, $arc_factors:ident,
        $angle_in_lanes:path, $compose:path,
        $sqrt:ident, $fabs:ident, $sin:ident, $cos:ident, $atan2:ident, $exp:ident, $log:ident,
        $sinh:ident, $cosh:ident, $tanh:ident, $hypot:ident
    ) => {
        impl Single for $type {}

        impl Real for $type {
            #[inline]
            fn from_f64(value: f64) -> Self {
                value as $type
            }
            #[inline]
            fn epsilon() -> Self {
                <$type>::EPSILON
            }
            #[inline]
            fn sqrt(self) -> Self {
                elementary!($type, sqrt, $sqrt, self)
            }
            #[inline]
            fn abs(self) -> Self {
                elementary!($type, abs, $fabs, self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                (
                    elementary!($type, sin, $sin, self),
                    elementary!($type, cos, $cos, self),
                )
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                elementary!($type, atan2, $atan2, self, x)
            }
            #[inline(always)]
            fn sine_by_angle(self) -> (Self, Self, Self) {
                let (cosine, ratio, slope) = half_angle::$sine_by_angle(f64::from(self));
                (cosine as Self, ratio as Self, slope as Self)
            }
            #[inline(always)]
            fn angle_by_sine(self) -> (Self, Self) {
                let (ratio, slope) = half_angle::$angle_by_sine(f64::from(self));
                (ratio as Self, slope as Self)
            }
            #[inline(always)]
            fn angle_by_sine_in_lanes<const N: usize>(
                lanes: Lanes<Self, N>,
            ) -> (Lanes<Self, N>, Lanes<Self, N>) {
                $angle_in_lanes(lanes)
            }
            #[inline(always)]
            fn arc_factors(self, t: Self) -> ArcFactors<Self> {
                let factors = arc::$arc_factors(f64::from(self), f64::from(t));
                ArcFactors {
                    first: factors.first as Self,
                    second: factors.second as Self,
                    first_slope: factors.first_slope as Self,
                    second_slope: factors.second_slope as Self,
                }
            }
            #[inline(always)]
            fn compose_motors(left: Motor<Self>, right: Motor<Self>) -> Motor<Self> {
                $compose(left, right)
            }
            #[inline]
            fn exp(self) -> Self {
                elementary!($type, exp, $exp, self)
            }
            #[inline]
            fn ln(self) -> Self {
                elementary!($type, ln, $log, self)
            }
            #[inline]
            fn sinh(self) -> Self {
                elementary!($type, sinh, $sinh, self)
            }
            #[inline]
            fn cosh(self) -> Self {
                elementary!($type, cosh, $cosh, self)
            }
            #[inline]
            fn tanh(self) -> Self {
                elementary!($type, tanh, $tanh, self)
            }
            #[inline]
            fn hypot(self, other: Self) -> Self {
                elementary!($type, hypot, $hypot, self, other)
            }
            #[inline]
            fn less_than(self, other: Self) -> bool {
                self < other
            }
            #[inline]
            fn less_or_equal(self, other: Self) -> bool {
                self <= other
            }
            #[inline]
            #[allow(clippy::float_cmp, reason = "this is the exact comparison")]
            fn equals(self, other: Self) -> bool {
                self == other
            }
            #[inline]
            fn is_finite(self) -> bool {
                <$type>::is_finite(self)
            }
            #[inline]
            fn is_zero(self) -> bool {
                self == 0.0
            }
        }
    };
}

implement_field!(f32);
implement_field!(f64);
implement_real!(
    f32, by sine_by_angle_single, angle_by_sine_single, arc_factors_single,
    angle_by_sine_one_by_one, compose_single,
    sqrtf, fabsf, sinf, cosf, atan2f, expf, logf, sinhf, coshf, tanhf, hypotf
);
implement_real!(
    f64, by sine_by_angle, angle_by_sine, arc_factors,
    half_angle::angle_by_sine, Mul::mul,
    sqrt, fabs, sin, cos, atan2, exp, log, sinh, cosh, tanh, hypot
);
