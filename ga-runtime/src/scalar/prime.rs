//! The prime field modulo 2⁶¹ − 1.

use core::fmt;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::{ConstRing, Field, Ring};

/// A number modulo the Mersenne prime p = 2⁶¹ − 1: the exact scalar of the tests.
///
/// Arithmetic is exact and never overflows, and every element except zero has an inverse, so
/// halves, duals and inverses of versors exist as they do over the rationals. Two polynomial
/// formulas of degree d that differ agree at a random point with probability of at most d / p
/// (Schwartz–Zippel), so that one equality here is stronger evidence than any number of comparisons
/// within a tolerance.
///
/// The field has no order, and so no lengths and angles. Half of its elements are squares; see
/// [`Prime61::square_root`].
///
/// Division by zero gives zero: 0⁻¹ is defined as 0, so that no operation panics.
///
/// [`Display`](fmt::Display) and [`Debug`](fmt::Debug) write the representative of least magnitude,
/// so −1 reads `-1`.
///
/// ```
/// use ga_runtime::scalar::{Field, Prime61, Ring};
/// let half = Prime61::from_ratio(1, 2);
/// assert_eq!(half + half, Prime61::one());
/// assert_eq!(Prime61::from(-3).to_string(), "-3");
/// ```
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Prime61(u64);

impl Prime61 {
    /// The number of elements of the field, 2⁶¹ − 1.
    pub const MODULUS: u64 = (1 << 61) - 1;

    /// The residue of a natural number.
    #[inline]
    pub const fn new(value: u64) -> Self {
        Self::canonical((value & Self::MODULUS) + (value >> 61))
    }

    /// The representative in 0 ≤ value < 2⁶¹ − 1.
    #[inline]
    pub const fn value(self) -> u64 {
        self.0
    }

    /// The power with a natural exponent; the zeroth power is one, also that of zero.
    pub fn power(self, exponent: u64) -> Self {
        let mut result = Self(1);
        for bit in (0..u64::BITS - exponent.leading_zeros()).rev() {
            result *= result;
            if exponent >> bit & 1 == 1 {
                result *= self;
            }
        }
        result
    }

    /// The multiplicative inverse, by Fermat's little theorem x⁻¹ = xᵖ⁻². That of zero is defined
    /// as zero.
    pub fn inverse(self) -> Self {
        self.power(Self::MODULUS - 2)
    }

    /// One of the two square roots, or `None` if the number is not a square. The other root is its
    /// negative.
    ///
    /// As p ≡ 3 modulo 4, a square x has the root x^((p + 1) / 4).
    ///
    /// ```
    /// use ga_runtime::scalar::Prime61;
    /// let root = Prime61::from(2).square_root().expect("p is 7 modulo 8, so 2 is a square");
    /// assert_eq!(root * root, Prime61::from(2));
    /// assert_eq!(Prime61::from(-1).square_root(), None);
    /// ```
    pub fn square_root(self) -> Option<Self> {
        let root = self.power((Self::MODULUS + 1) / 4);
        (root * root == self).then_some(root)
    }

    /// The residue of a number below 2 p.
    #[inline]
    const fn canonical(value: u64) -> Self {
        if value >= Self::MODULUS {
            Self(value - Self::MODULUS)
        } else {
            Self(value)
        }
    }
}

// Sums and products are not inlined: the largest products of multivectors have thousands of them,
// and LLVM takes minutes for a function with that many comparisons.

impl Add for Prime61 {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        Self::canonical(self.0 + other.0)
    }
}

impl Sub for Prime61 {
    type Output = Self;
    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        Self::canonical(self.0 + Self::MODULUS - other.0)
    }
}

impl Mul for Prime61 {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        // 2⁶¹ ≡ 1, so the high digit of the product in base 2⁶¹ is added to the low one.
        let product = u128::from(self.0) * u128::from(other.0);
        Self::canonical((product as u64 & Self::MODULUS) + (product >> 61) as u64)
    }
}

impl Div for Prime61 {
    type Output = Self;
    /// The quotient; zero if the divisor is zero.
    #[inline]
    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "a quotient is a product with the inverse"
    )]
    fn div(self, other: Self) -> Self {
        self * other.inverse()
    }
}

impl Neg for Prime61 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::canonical(Self::MODULUS - self.0)
    }
}

macro_rules! implement_assignment {
    ($($trait:ident $method:ident $operator:tt),+) => {$(
        impl $trait for Prime61 {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )+};
}
implement_assignment!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl From<i64> for Prime61 {
    #[inline]
    fn from(value: i64) -> Self {
        let magnitude = Self::new(value.unsigned_abs());
        if value < 0 { -magnitude } else { magnitude }
    }
}

impl ConstRing for Prime61 {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(1);
}

impl Ring for Prime61 {
    #[inline]
    fn zero() -> Self {
        Self(0)
    }
    #[inline]
    fn one() -> Self {
        Self(1)
    }
    #[inline]
    fn from_integer(value: i64) -> Self {
        Self::from(value)
    }
}

impl Field for Prime61 {
    #[inline]
    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Self::from(numerator) / Self::from(denominator)
    }
}

impl fmt::Display for Prime61 {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Both branches fit: each magnitude is below 2⁶⁰.
        let signed = if self.0 > Self::MODULUS / 2 {
            self.0 as i64 - Self::MODULUS as i64
        } else {
            self.0 as i64
        };
        fmt::Display::fmt(&signed, formatter)
    }
}

impl fmt::Debug for Prime61 {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}
