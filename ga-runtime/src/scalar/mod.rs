//! The traits of coefficients, in three levels, and the scalar types.
//!
//! | trait | adds | sufficient for |
//! | --- | --- | --- |
//! | [`Ring`] | `+ - *`, integers | products of multivectors with stored blades |
//! | [`Field`] | `/`, fractions | derived blades (`x²/2`), inverses, duals in any metric |
//! | [`Real`] | roots, angles, ordering by masks | lengths, rotors from angles, exponentials |
//!
//! Generic code requires the weakest trait that it needs, so that products run over integers and
//! over a prime field as well as over floating point, and tests can require exact equality.
//!
//! | scalar | is | implements |
//! | --- | --- | --- |
//! | `f32`, `f64` | floating point | [`Real`] |
//! | `i64` | integers | [`Ring`] |
//! | [`Prime61`] | the prime field modulo 2⁶¹ − 1, exact | [`Field`] |
//! | [`Lanes<T, N>`](Lanes) | N scalars side by side, one vector register | what T does |
//! | [`Dual<S, N>`](Dual) | a value with N derivatives | what S does |
//! | `f32x4`, `f32x8`, `f64x2`, `f64x4` of `wide` | vector registers (feature `wide`) | [`Real`] |
//!
//! Scalars nest: `Dual<Lanes<f64, 4>, 3>` carries the gradients of four numbers, `Dual<Dual<f64>>`
//! second derivatives.

mod arc;
mod dual;
mod float;
mod half_angle;
mod hyperbolic;
mod hypotenuse;
mod integer;
mod lanes;
mod mask;
mod maybe;
mod prime;
mod select;
mod step;
mod versor;
#[cfg(feature = "wide")]
mod wide;

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::cga3::Motor;

#[cfg(feature = "wide")]
pub use self::wide::WideMask;
pub use arc::ArcFactors;
pub use dual::Dual;
pub use lanes::Lanes;
pub use mask::{LaneMask, Mask};
pub use maybe::{Masked, Maybe, Optional};
pub use prime::Prime61;
pub use select::{Select, Single};
pub use step::smooth_step;
pub use versor::{versor_exponential, versor_logarithm};

/// A commutative ring with one: the minimum that a coefficient must implement.
///
/// ```
/// use ga_runtime::scalar::Ring;
/// fn square<S: Ring>(x: S) -> S {
///     x * x
/// }
/// assert_eq!(square(3_i64), 9);
/// assert_eq!(square(0.5_f32), 0.25);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a scalar",
    note = "`*` with a scalar scales; a versor moves an element by `versor.transform(element)`",
    note = "products that an algebra does not declare are written in `ga!`, or take `Multivector`s"
)]
pub trait Ring:
    Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// The neutral element of addition.
    fn zero() -> Self;
    /// The neutral element of multiplication.
    fn one() -> Self;
    /// The integer as a scalar.
    fn from_integer(value: i64) -> Self;

    /// `self · factor + summand`, in one rounding only where the target has the instruction for it.
    #[inline]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }

    /// `self · factor − subtrahend`, rounded like [`mul_add`](Self::mul_add).
    #[inline]
    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
        self * factor - subtrahend
    }

    /// `summand − self · factor`, rounded like [`mul_add`](Self::mul_add).
    #[inline]
    fn neg_mul_add(self, factor: Self, summand: Self) -> Self {
        summand - self * factor
    }
}

/// A ring whose zero and one are constants, so that there are constants of its elements such as
/// `Motor::IDENTITY`. All scalars here implement it except foreign types that come by way of
/// num-traits.
///
/// ```
/// use ga_runtime::cga3::Motor;
/// const START: Motor<f32> = Motor::IDENTITY;
/// assert_eq!(START, Motor::default());
/// ```
pub trait ConstRing: Ring {
    /// The neutral element of addition.
    const ZERO: Self;
    /// The neutral element of multiplication.
    const ONE: Self;
}

/// A ring with division, in which almost every element has an inverse.
///
/// In a field in the strict sense, every element except zero has an inverse. Lanes and dual numbers
/// have further elements without one, so code that guards a division calls [`Field::is_invertible`]
/// instead of comparing with zero.
///
/// ```
/// use ga_runtime::scalar::Field;
/// assert_eq!(f64::from_ratio(1, 4), 0.25);
/// ```
pub trait Field: Ring + Div<Output = Self> {
    /// The fraction `numerator / denominator`. The denominator must not be zero.
    fn from_ratio(numerator: i64, denominator: i64) -> Self;

    /// `1 / self`.
    #[inline]
    fn recip(self) -> Self {
        Self::one() / self
    }

    /// `1 / self`, and zero where that is not invertible: the pseudoinverse of a number. Lanes are
    /// told apart; of a dual number its value decides.
    ///
    /// ```
    /// use ga_runtime::scalar::{Field, Lanes};
    /// assert_eq!((4.0.recip_or_zero(), 0.0.recip_or_zero()), (0.25, 0.0));
    /// let lanes = Lanes::from_array([2.0, 0.0]);
    /// assert_eq!(lanes.recip_or_zero().to_array(), [0.5, 0.0]);
    /// ```
    #[inline]
    fn recip_or_zero(self) -> Self {
        if self.is_invertible() {
            self.recip()
        } else {
            Self::zero()
        }
    }

    /// `self / divisor`, and zero where the divisor is not invertible, as for
    /// [`recip_or_zero`](Self::recip_or_zero).
    ///
    /// ```
    /// use ga_runtime::scalar::Field;
    /// assert_eq!((3.0.div_or_zero(4.0), 3.0.div_or_zero(0.0)), (0.75, 0.0));
    /// ```
    #[inline]
    fn div_or_zero(self, divisor: Self) -> Self {
        if divisor.is_invertible() {
            self / divisor
        } else {
            Self::zero()
        }
    }

    /// Whether the number has an inverse: a single number if it is not zero, lanes if none of them
    /// is zero, a dual number if its value has an inverse.
    ///
    /// ```
    /// use ga_runtime::scalar::{Field, Lanes};
    /// assert!(2.0.is_invertible() && !0.0.is_invertible());
    /// assert!(!Lanes::from_array([2.0, 0.0]).is_invertible());
    /// ```
    #[inline]
    fn is_invertible(self) -> bool {
        self != Self::zero()
    }
}

/// A field with roots, angles and an order: floating-point numbers, single, in lanes or with
/// derivatives.
///
/// Comparisons return a [`Mask`](Select::Mask), and [`select`](Select::select) chooses by it, so
/// that the same code runs on one number and on lanes. A result that may not exist is a [`Maybe`].
///
/// ```
/// use ga_runtime::scalar::Real;
/// fn clamp_below<S: Real>(x: S, least: S) -> S {
///     S::select(x.less_than(least), least, x)
/// }
/// assert_eq!(clamp_below(-1.0, 0.0), 0.0);
/// ```
pub trait Real: Field + Select {
    /// The constant as a scalar, rounded.
    fn from_f64(value: f64) -> Self;
    /// The distance from 1 to the next larger number.
    fn epsilon() -> Self;
    /// `√self`.
    fn sqrt(self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The angle in radians, in (−π, π], of the point (`x`, `self`).
    fn atan2(self, x: Self) -> Self;
    /// The exponential function.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// Whether `self < other`; false where either is NaN.
    fn less_than(self, other: Self) -> Self::Mask;
    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> Self::Mask;
    /// Whether the number is zero, and all its derivatives if it has any.
    fn is_zero(self) -> Self::Mask;

    /// Whether `self ≤ other`; false where either is NaN.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// assert!(2.0.less_or_equal(2.0) && !3.0_f64.less_or_equal(2.0));
    /// assert!(!f64::NAN.less_or_equal(f64::NAN));
    /// ```
    #[inline]
    fn less_or_equal(self, other: Self) -> Self::Mask {
        self.less_than(other) | self.equals(other)
    }
    /// Whether `self = other`, without regard to derivatives; false where either is NaN.
    ///
    /// ```
    /// use ga_runtime::scalar::{Dual, Real};
    /// assert!(0.0.equals(-0.0) && f64::INFINITY.equals(f64::INFINITY));
    /// assert!(!f64::NAN.equals(f64::NAN));
    /// assert!(Dual::<f64>::variable(2.0).equals(Dual::constant(2.0)));
    /// ```
    #[inline]
    fn equals(self, other: Self) -> Self::Mask {
        // A number that is not NaN is below 1 or above 0.
        let is_number = |x: Self| x.less_than(Self::one()) | Self::zero().less_than(x);
        let differs = self.less_than(other) | other.less_than(self);
        !differs & is_number(self) & is_number(other)
    }
    /// Sine of an angle in radians.
    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    /// Cosine of an angle in radians.
    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    /// The hyperbolic sine, accurate near zero too.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// assert_eq!(Real::sinh(1e-20_f64), 1e-20);
    /// ```
    #[inline]
    fn sinh(self) -> Self {
        hyperbolic::sinh(self)
    }
    /// The hyperbolic cosine.
    #[inline]
    fn cosh(self) -> Self {
        hyperbolic::cosh(self)
    }
    /// The hyperbolic tangent, accurate near zero too; ±1 where sine and cosine are infinite.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// assert_eq!(Real::tanh(1e3_f64), 1.0);
    /// ```
    #[inline]
    fn tanh(self) -> Self {
        hyperbolic::tanh(self)
    }
    /// `√(self² + other²)`, without overflow or underflow in the squares.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// let length = Real::hypot(3e200_f64, 4e200);
    /// assert!((length / 5e200 - 1.0).abs() < 1e-15);
    /// ```
    #[inline]
    fn hypot(self, other: Self) -> Self {
        hypotenuse::hypot(self, other)
    }
    /// `cos φ`, `A = sin φ/φ` and `B = (cos φ − A)/φ²` for `φ² = self` from 0 to 9.95, that is φ up
    /// to a little more than π; outside of that range the results have no meaning. Errors are below
    /// 2 ε. There is no special case at φ = 0, where the results are 1, 1 and −⅓.
    ///
    /// They give the exponential of a rotation by 2φ. B is twice the derivative of A with respect
    /// to φ².
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// let angle = 0.75_f64;
    /// let (cosine, ratio, slope) = (angle * angle).sine_by_angle();
    /// assert!((cosine - angle.cos()).abs() < 2e-16);
    /// assert!((ratio - angle.sin() / angle).abs() < 2e-16);
    /// assert!((slope - (cosine - ratio) / angle.powi(2)).abs() < 1e-15);
    /// ```
    #[inline]
    fn sine_by_angle(self) -> (Self, Self, Self) {
        half_angle::sine_by_angle(self)
    }
    /// `A = φ/sin φ` and `B = (cos φ − A)/sin² φ` for `cos φ = self` from 0 to 1, that is φ up to
    /// π/2; outside of that range the results are inaccurate. Errors are below 2 ε.
    ///
    /// They give the logarithm of a rotation by 2φ. At φ = 0 they are 1 and −2/3.
    /// `−B cos φ = 1 + dA/d(cos φ)`.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// let angle = 0.75_f64;
    /// let (ratio, slope) = angle.cos().angle_by_sine();
    /// assert!((ratio - angle / angle.sin()).abs() < 4e-16);
    /// assert!((slope - (angle.cos() - ratio) / angle.sin().powi(2)).abs() < 1e-15);
    /// assert_eq!(1.0_f64.angle_by_sine().0, 1.0);
    /// ```
    #[inline]
    fn angle_by_sine(self) -> (Self, Self) {
        half_angle::angle_by_sine(self)
    }
    /// [`angle_by_sine`](Self::angle_by_sine) of each lane, with the same result as of one number.
    #[doc(hidden)]
    #[inline(always)]
    fn angle_by_sine_in_lanes<const N: usize>(
        lanes: Lanes<Self, N>,
    ) -> (Lanes<Self, N>, Lanes<Self, N>) {
        half_angle::angle_by_sine_one_by_one(lanes)
    }
    /// The factors `A = sin (1 − t)φ/sin φ` and `B = sin tφ/sin φ` of spherical linear
    /// interpolation with their derivatives, for `cos φ = self` from 0 to 1, that is φ up to π/2,
    /// and t from −1 to 1; outside of that range the results have no meaning. There is no special
    /// case at φ = 0, where A is 1 − t and B is t. Errors of A and B are below 4 ε for t from 0 to
    /// 1.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// let (angle, t) = (0.75_f64, 0.25);
    /// let factors = angle.cos().arc_factors(t);
    /// assert!((factors.first - (0.75 * angle).sin() / angle.sin()).abs() < 5e-16);
    /// assert!((factors.second - (0.25 * angle).sin() / angle.sin()).abs() < 5e-16);
    /// assert!((1.0.arc_factors(t).second - 0.25).abs() < 5e-16);
    /// ```
    #[inline]
    fn arc_factors(self, t: Self) -> ArcFactors<Self> {
        arc::arc_factors(self, t)
    }
    /// See [`Motor::compose`].
    #[doc(hidden)]
    #[inline(always)]
    fn compose_motors(left: Motor<Self>, right: Motor<Self>) -> Motor<Self> {
        left * right
    }
    /// The larger of two numbers; `self` where they are equal or one is NaN.
    #[inline]
    fn max(self, other: Self) -> Self {
        Self::select(self.less_than(other), other, self)
    }
    /// The smaller of two numbers; `self` where they are equal or one is NaN.
    #[inline]
    fn min(self, other: Self) -> Self {
        Self::select(other.less_than(self), other, self)
    }
}
