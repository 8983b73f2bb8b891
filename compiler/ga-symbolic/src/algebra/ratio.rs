//! Exact fractions: the constants of an algebra and of its expressions.

use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An exact fraction in lowest terms with a positive denominator.
///
/// A number that needs more than 128 bits is [out of range](Self::is_out_of_range), and so is every
/// result that depends on it, except for its product with zero. So no number is ever wrong, and
/// code that needs a number out of range is refused.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Ratio {
    numerator: i128,
    denominator: i128,
}

impl Ratio {
    /// Zero.
    pub const ZERO: Self = Self::integer(0);
    /// One.
    pub const ONE: Self = Self::integer(1);
    const OUT_OF_RANGE: Self = Self::integer(i128::MAX);

    /// A whole number.
    #[must_use]
    pub const fn integer(value: i128) -> Self {
        Self {
            numerator: value,
            denominator: 1,
        }
    }

    /// The fraction `numerator / denominator`, or `None` where the denominator is zero.
    #[must_use]
    pub fn new(numerator: i128, denominator: i128) -> Option<Self> {
        if denominator == 0 {
            return None;
        }
        if is_limit(numerator) || is_limit(denominator) {
            return Some(Self::OUT_OF_RANGE);
        }
        if denominator == 1 {
            return Some(Self::integer(numerator));
        }
        let divisor = greatest_common_divisor(numerator, denominator).max(1) * denominator.signum();
        Some(Self {
            numerator: numerator / divisor,
            denominator: denominator / divisor,
        })
    }

    /// Whether this stands for a number that 128 bits do not hold.
    #[must_use]
    pub const fn is_out_of_range(self) -> bool {
        is_limit(self.numerator)
    }

    /// The numerator, which carries the sign.
    #[must_use]
    pub const fn numerator(self) -> i128 {
        self.numerator
    }

    /// The positive denominator.
    #[must_use]
    pub const fn denominator(self) -> i128 {
        self.denominator
    }

    /// Whether the value is zero.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// Whether the value is below zero.
    #[must_use]
    pub const fn is_negative(self) -> bool {
        self.numerator < 0
    }

    /// Whether the denominator is one.
    #[must_use]
    pub const fn is_integer(self) -> bool {
        self.denominator == 1
    }

    /// The absolute value.
    #[must_use]
    pub const fn abs(self) -> Self {
        Self {
            numerator: self.numerator.saturating_abs(),
            denominator: self.denominator,
        }
    }

    /// The root, where it is a fraction too.
    #[must_use]
    pub fn square_root(self) -> Option<Self> {
        let root = |square: i128| {
            let root = square.checked_isqrt()?;
            (root * root == square).then_some(root)
        };
        if self.is_out_of_range() {
            return None;
        }
        Self::new(root(self.numerator)?, root(self.denominator)?)
    }

    /// Whether this is zero or a positive fraction that consists of primes up to 83, which are
    /// squares among the residues.
    #[must_use]
    pub fn is_of_small_primes(self) -> bool {
        self.is_zero() || (self * self).root_factor() == self
    }

    /// The largest fraction r that consists of primes up to 83 and whose square divides this: what
    /// may stand before a root, since those primes are squares among the residues.
    #[must_use]
    pub fn root_factor(self) -> Self {
        let of = |mut rest: i128| {
            let mut root = 1_i128;
            for prime in (2..=83_i128).filter(|n| (2..*n).all(|d| n % d != 0)) {
                while rest != 0 && rest % (prime * prime) == 0 {
                    rest /= prime * prime;
                    root *= prime;
                }
            }
            root
        };
        if self.is_out_of_range() || self == Self::ONE {
            return Self::ONE;
        }
        Self::new(of(self.numerator), of(self.denominator)).unwrap_or(Self::ONE)
    }

    /// The nearest floating-point number.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        let (mantissa, exponent) = self.nearest_double();
        mantissa as f64 * 2.0_f64.powi(exponent)
    }

    /// The nearest number m · 2ᵉ with an m of at most 53 bits, as in double precision, ties to an
    /// even m.
    #[must_use]
    pub fn nearest_double(self) -> (i64, i32) {
        const BITS: u32 = 53;
        let divisor = self.denominator.unsigned_abs();
        let size = self.numerator.unsigned_abs();
        let (mut quotient, mut rest) = (size / divisor, size % divisor);
        let mut exponent = 0;
        // One bit more than there is room for, to round by.
        while quotient < 1 << BITS && (rest != 0 || quotient == 0) && size != 0 {
            (quotient, rest, exponent) = (2 * quotient, 2 * rest, exponent - 1);
            if rest >= divisor {
                (quotient, rest) = (quotient + 1, rest - divisor);
            }
        }
        while quotient >= 1 << BITS {
            let is_half = quotient & 1 == 1;
            let is_last = quotient < 1 << (BITS + 1);
            quotient >>= 1;
            exponent += 1;
            if is_last {
                quotient += u128::from(is_half && (rest != 0 || quotient & 1 == 1));
            } else {
                rest |= u128::from(is_half);
            }
        }
        let mantissa = i64::try_from(quotient).unwrap_or(i64::MAX);
        (
            mantissa * i64::from(self.numerator.signum() as i8),
            exponent,
        )
    }

    /// The larger of numerator and denominator.
    #[must_use]
    pub fn height(self) -> i128 {
        self.numerator.saturating_abs().max(self.denominator)
    }

    /// The largest fraction of which all of these are whole multiples: the greatest common divisor
    /// of the numerators over the least common multiple of the denominators. `None` where that
    /// multiple is out of range, or all are zero.
    #[must_use]
    pub fn content(values: impl IntoIterator<Item = Self>) -> Option<Self> {
        let (mut numerator, mut denominator) = (0, 1_i128);
        for value in values {
            numerator = greatest_common_divisor(numerator, value.numerator);
            let shared = greatest_common_divisor(denominator, value.denominator);
            denominator = (denominator / shared).checked_mul(value.denominator)?;
        }
        let content = Self::new(numerator, denominator)?;
        (!content.is_zero()).then_some(content)
    }

    /// `1 / self`, or `None` for zero.
    #[must_use]
    pub fn recip(self) -> Option<Self> {
        Self::new(self.denominator, self.numerator)
    }
}

/// The positive greatest common divisor; zero of two zeros.
fn greatest_common_divisor(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.saturating_abs(), b.saturating_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// Whether a number is at the end of the range, where its negative may be beyond it.
const fn is_limit(value: i128) -> bool {
    value == i128::MAX || value == i128::MIN
}

/// A whole number, unless it has overflowed.
fn whole(value: Option<i128>) -> Ratio {
    match value {
        Some(value) if !is_limit(value) => Ratio::integer(value),
        _ => Ratio::OUT_OF_RANGE,
    }
}

/// The fraction of two numbers, unless one of them has overflowed.
fn reduced(numerator: Option<i128>, denominator: Option<i128>) -> Ratio {
    match (numerator, denominator) {
        (Some(numerator), Some(denominator)) => {
            Ratio::new(numerator, denominator).unwrap_or(Ratio::ZERO)
        }
        _ => Ratio::OUT_OF_RANGE,
    }
}

impl Add for Ratio {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_out_of_range() || other.is_out_of_range() {
            return Self::OUT_OF_RANGE;
        }
        if self.is_integer() && other.is_integer() {
            return whole(self.numerator.checked_add(other.numerator));
        }
        let times = i128::checked_mul;
        let left = times(self.numerator, other.denominator);
        let right = times(other.numerator, self.denominator);
        reduced(
            left.zip(right)
                .and_then(|(left, right)| left.checked_add(right)),
            times(self.denominator, other.denominator),
        )
    }
}

impl Sub for Ratio {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Ratio {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        if self.is_out_of_range() || other.is_out_of_range() {
            return Self::OUT_OF_RANGE;
        }
        if self.is_integer() && other.is_integer() {
            return match (
                i64::try_from(self.numerator),
                i64::try_from(other.numerator),
            ) {
                (Ok(a), Ok(b)) => Self::integer(i128::from(a) * i128::from(b)),
                _ => whole(self.numerator.checked_mul(other.numerator)),
            };
        }
        reduced(
            self.numerator.checked_mul(other.numerator),
            self.denominator.checked_mul(other.denominator),
        )
    }
}

impl Div for Ratio {
    type Output = Self;
    /// Callers must exclude a divisor of zero; the quotient by it is zero.
    fn div(self, other: Self) -> Self {
        if other == Self::ONE {
            return self;
        }
        if other == Self::integer(-1) {
            return -self;
        }
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        if self.is_out_of_range() || other.is_out_of_range() {
            return Self::OUT_OF_RANGE;
        }
        reduced(
            self.numerator.checked_mul(other.denominator),
            self.denominator.checked_mul(other.numerator),
        )
    }
}

impl Neg for Ratio {
    type Output = Self;
    fn neg(self) -> Self {
        if self.is_out_of_range() {
            return self;
        }
        Self {
            numerator: -self.numerator,
            denominator: self.denominator,
        }
    }
}

impl From<i128> for Ratio {
    fn from(value: i128) -> Self {
        Self::integer(value)
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            _ if self.is_out_of_range() => write!(f, "beyond 128 bits"),
            1 => write!(f, "{}", self.numerator),
            denominator => write!(f, "{}/{denominator}", self.numerator),
        }
    }
}

impl fmt::Debug for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_stay_in_lowest_terms() {
        let sixth = Ratio::new(-2, -12).unwrap();
        assert_eq!((sixth.numerator(), sixth.denominator()), (1, 6));
        assert_eq!(sixth + Ratio::new(1, 3).unwrap(), Ratio::new(1, 2).unwrap());
        assert_eq!(sixth * Ratio::integer(6), Ratio::ONE);
        assert_eq!(Ratio::new(1, 0), None);
    }

    #[test]
    fn the_nearest_double_is_that_of_the_standard_library() {
        for (numerator, denominator) in [
            (314_159_265_358_979_323_846, 100_000_000_000_000_000_000),
            (12_345_678_901_234_567, 100_000_000_000_000_000),
            (-1, 3),
            (1, 1 << 100),
            (0, 1),
            ((1 << 54) + 1, 1),
            ((1 << 54) + 2, 1),
            ((1 << 54) + 6, 1),
            ((1 << 53) + 1, 1 << 30),
            (i128::MAX - 1, 7),
        ] {
            let ratio = Ratio::new(numerator, denominator).unwrap();
            let (mantissa, exponent) = ratio.nearest_double();
            let found = mantissa as f64 * 2_f64.powi(exponent);
            let text = match (numerator, denominator) {
                (314_159_265_358_979_323_846, _) => "3.14159265358979323846".to_owned(),
                (12_345_678_901_234_567, _) => "0.12345678901234567".to_owned(),
                _ => (numerator as f64 / denominator as f64).to_string(),
            };
            assert_eq!(Ok(found), text.parse(), "{ratio}");
        }
    }

    #[test]
    fn nothing_wraps_round() {
        let large = Ratio::integer(1 << 100);
        let tiny = Ratio::new(1, 1 << 100).unwrap();
        let beyond = large * large;
        let cases = [
            beyond,
            -beyond,
            beyond + Ratio::ONE,
            Ratio::ONE - beyond,
            beyond - beyond,
            beyond / beyond,
            beyond.recip().unwrap(),
            beyond * tiny,
            tiny * tiny,
            tiny + Ratio::new(1, (1 << 100) + 1).unwrap(),
            large / tiny,
            Ratio::integer(i128::MAX - 1) + Ratio::ONE,
            Ratio::integer(-i128::MAX) - Ratio::ONE,
            Ratio::integer(i128::MIN).abs(),
            Ratio::new(i128::MIN, -1).unwrap(),
            Ratio::new(1, i128::MIN).unwrap(),
        ];
        for case in cases {
            assert!(case.is_out_of_range(), "{case}");
        }
        assert_eq!(beyond * Ratio::ZERO, Ratio::ZERO);
        assert_eq!(large * tiny, Ratio::ONE);
        assert_eq!(-(large - large), Ratio::ZERO);
    }
}
