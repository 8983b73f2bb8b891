//! Rings and fields: what coefficients must implement.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

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
