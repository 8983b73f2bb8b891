//! num-traits 0.2: [`Zero`] and [`One`], where the laws of these traits hold.
//!
//! - [`Zero`] is for the types whose sums stay in the type: those without constants, derived blades
//!   and facts. A sum of points is not a point, and so a [`Point`](crate::cga3::Point) does not
//!   have it.
//! - [`One`] is for the types of which 1 is a member and whose members multiply to members. In cga3
//!   these are the numbers [`Quaternion`](crate::cga3::Quaternion),
//!   [`DualQuaternion`](crate::cga3::DualQuaternion), [`Even`](crate::cga3::Even),
//!   [`Multivector`](crate::cga3::Multivector), and the groups of motions, from
//!   [`Rotor`](crate::cga3::Rotor) to [`Similarity`](crate::cga3::Similarity).
//! - The scalars [`Prime61`], [`Lanes`] and [`Dual`] have both.
//!
//! This holds for the types of your own algebras too. So these types can be passed to generic
//! functions for sums and products:
//!
//! ```
//! use ga_runtime::cga3::{Rotor, Quaternion};
//! use num_traits_02::{One, Zero};
//!
//! let sixth = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_3).unwrap();
//! let half_turn = num_traits_02::pow(sixth, 3);
//! assert!(half_turn.scalar().abs() < 1e-15 && (half_turn.e12() + 1.0).abs() < 1e-15);
//! assert!(Quaternion::<f64>::zero().is_zero() && Rotor::<f64>::one().is_one());
//! ```
//!
//! A number type of another crate becomes a scalar where it implements the traits of
//! [`scalar`](crate::scalar). A type of a third crate that implements num-traits' [`Float`] becomes
//! a scalar by the wrapper [`FromFloat`].

use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits_02::{Float, NumCast, One, Zero};

use crate::scalar::{Dual, Field, Lanes, Prime61, Real, Ring, Single};

/// Emits zero and one for a declared type.
#[doc(hidden)]
#[macro_export]
macro_rules! __count {
    (linear $name:ident $text:literal { $($field:ident $place:tt $blade:literal),* } $one:tt) => {
        impl<S: $crate::scalar::Ring> $crate::__private::num_traits::Zero for $name<S>
        where
            Self: ::core::ops::Add<Self, Output = Self>,
        {
            #[inline]
            fn zero() -> Self {
                Self { $($field: <S as $crate::scalar::Ring>::zero()),* }
            }
            #[inline]
            fn is_zero(&self) -> ::core::primitive::bool {
                $(self.$field == <S as $crate::scalar::Ring>::zero())&&*
            }
        }
        $crate::__count! { one $name $one }
    };
    (constant $($description:tt)*) => {};
    (parameters $($description:tt)*) => {};
    (one $name:ident []) => {};
    (one $name:ident [$($field:ident $value:ident),*]) => {
        impl<S: $crate::scalar::Ring> $crate::__private::num_traits::One for $name<S>
        where
            Self: ::core::ops::Mul<Self, Output = Self>,
        {
            #[inline]
            fn one() -> Self {
                Self { $($field: <S as $crate::scalar::Ring>::$value()),* }
            }
        }
    };
    ($role:ident $name:ident $text:literal $fields:tt $one:tt) => {
        $crate::__count! { one $name $one }
    };
}

macro_rules! scalars {
    ($([$($parameters:tt)*] $type:ty),*) => { $(
        impl<$($parameters)*> Zero for $type {
            #[inline]
            fn zero() -> Self {
                <Self as Ring>::zero()
            }
            #[inline]
            fn is_zero(&self) -> bool {
                *self == <Self as Ring>::zero()
            }
        }

        impl<$($parameters)*> One for $type {
            #[inline]
            fn one() -> Self {
                <Self as Ring>::one()
            }
        }
    )* };
}

scalars! {
    [] Prime61,
    [T: Ring, const N: usize] Lanes<T, N>,
    [S: Ring, const N: usize] Dual<S, N>
}

/// A floating-point number of another crate as a scalar.
///
/// It wraps any [`Float`] of num-traits, numbers of more or fewer digits for instance, and forwards
/// every operation to it. Constants are converted from `f64`, and fractions such as ½ are quotients
/// of integers. `f32` and `f64` are scalars without it.
///
/// ```
/// use ga_runtime::cga3::{Point, Rotor};
/// use ga_runtime::interop::num_traits::FromFloat;
/// let quarter = Rotor::from_axis_angle(
///     [0.0, 0.0, 1.0].map(FromFloat),
///     FromFloat(std::f64::consts::FRAC_PI_2),
/// )
/// .unwrap();
/// let [x, y, _] = quarter
///     .transform(Point::from([1.0, 0.0, 0.0].map(FromFloat)))
///     .coordinates();
/// assert!(x.0.abs() < 1e-15 && (y.0 - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct FromFloat<T>(pub T);

/// The nearest number; NaN for one that the type cannot hold.
fn nearest<T: Float>(value: impl num_traits_02::ToPrimitive) -> FromFloat<T> {
    FromFloat(<T as NumCast>::from(value).unwrap_or_else(T::nan))
}

macro_rules! operators {
    ($($Operator:ident $operate:ident, $Assign:ident $assign:ident);*) => { $(
        impl<T: Float> $Operator for FromFloat<T> {
            type Output = Self;
            #[inline]
            fn $operate(self, other: Self) -> Self {
                Self(self.0.$operate(other.0))
            }
        }

        impl<T: Float> $Assign for FromFloat<T> {
            #[inline]
            fn $assign(&mut self, other: Self) {
                self.0 = self.0.$operate(other.0);
            }
        }
    )* };
}

operators! { Add add, AddAssign add_assign; Sub sub, SubAssign sub_assign; Mul mul, MulAssign mul_assign }

impl<T: Float> Div for FromFloat<T> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl<T: Float> Neg for FromFloat<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Float + core::fmt::Debug> Ring for FromFloat<T> {
    #[inline]
    fn zero() -> Self {
        Self(T::zero())
    }
    #[inline]
    fn one() -> Self {
        Self(T::one())
    }
    #[inline]
    fn from_integer(value: i64) -> Self {
        nearest(value)
    }
}

impl<T: Float + core::fmt::Debug> Field for FromFloat<T> {
    #[inline]
    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Self::from_integer(numerator) / Self::from_integer(denominator)
    }
}

impl<T: Float> Single for FromFloat<T> {}

impl<T: Float + core::fmt::Debug> Real for FromFloat<T> {
    #[inline]
    fn from_f64(value: f64) -> Self {
        nearest(value)
    }
    #[inline]
    fn epsilon() -> Self {
        Self(T::epsilon())
    }
    #[inline]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
    #[inline]
    fn exp(self) -> Self {
        Self(self.0.exp())
    }
    #[inline]
    fn ln(self) -> Self {
        Self(self.0.ln())
    }
    #[inline]
    fn sinh(self) -> Self {
        Self(self.0.sinh())
    }
    #[inline]
    fn cosh(self) -> Self {
        Self(self.0.cosh())
    }
    #[inline]
    fn tanh(self) -> Self {
        Self(self.0.tanh())
    }
    #[inline]
    fn hypot(self, other: Self) -> Self {
        Self(self.0.hypot(other.0))
    }
    #[inline]
    fn less_than(self, other: Self) -> bool {
        self.0 < other.0
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    #[inline]
    fn is_zero(self) -> bool {
        self.0.is_zero()
    }
}
