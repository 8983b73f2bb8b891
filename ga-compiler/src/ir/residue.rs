//! The field of integers modulo 2⁶¹ − 1, in which the compiler checks its own work exactly.

use std::ops::{Add, Mul, Neg, Sub};

use crate::algebra::Ratio;

const MODULUS: u64 = (1 << 61) - 1;

/// A residue modulo 2⁶¹ − 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Residue(u64);

impl Residue {
    /// Zero.
    pub const ZERO: Self = Self(0);
    /// One.
    pub const ONE: Self = Self(1);

    /// The residue of a number.
    #[must_use]
    pub const fn new(value: u64) -> Self {
        Self(value % MODULUS)
    }

    /// The residue as a number below the modulus.
    #[must_use]
    pub const fn residue(self) -> u64 {
        self.0
    }

    /// A root of a square; `None` for the other half of the residues.
    #[must_use]
    pub fn square_root(self) -> Option<Self> {
        // The modulus is 3 modulo 4.
        let root = self.power((MODULUS + 1) / 4);
        (root * root == self).then_some(root)
    }

    /// The residue or its negative, whichever is a square. As with real numbers, it has a root, and
    /// the absolute value of a product is the product of the absolute values.
    #[must_use]
    pub fn absolute(self) -> Self {
        if self.square_root().is_some() {
            self
        } else {
            -self
        }
    }

    /// The image of a fraction. A denominator that the modulus divides gives zero.
    #[must_use]
    pub fn from_ratio(ratio: Ratio) -> Self {
        let residue = |value: i128| {
            let value = value.rem_euclid(i128::from(MODULUS));
            Self(u64::try_from(value).unwrap_or(0))
        };
        if ratio.is_integer() {
            return residue(ratio.numerator());
        }
        residue(ratio.numerator()) * residue(ratio.denominator()).recip()
    }

    /// The inverse; zero for zero.
    #[must_use]
    pub fn recip(self) -> Self {
        self.power(MODULUS - 2)
    }

    fn power(self, mut exponent: u64) -> Self {
        let (mut power, mut base) = (Self::ONE, self);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = power * base;
            }
            base = base * base;
            exponent >>= 1;
        }
        power
    }
}

impl Add for Residue {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.0 + other.0)
    }
}

impl Sub for Residue {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.0 + MODULUS - other.0)
    }
}

impl Neg for Residue {
    type Output = Self;
    fn neg(self) -> Self {
        Self::ZERO - self
    }
}

impl Mul for Residue {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let wide = u128::from(self.0) * u128::from(other.0);
        let folded = (wide & u128::from(MODULUS)) + (wide >> 61);
        Self(u64::try_from(folded % u128::from(MODULUS)).unwrap_or(0))
    }
}

/// A reproducible sequence of residues (SplitMix64: Steele, Lea and Flood 2014). A library of
/// random numbers would make every build that uses the macros longer.
#[derive(Clone, Debug)]
pub struct ResidueSequence(u64);

impl ResidueSequence {
    /// The sequence of a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Another name of [`next_residue`](Self::next_residue).
    pub fn next_prime(&mut self) -> Residue {
        self.next_residue()
    }

    /// The next residue.
    pub fn next_residue(&mut self) -> Residue {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        Residue::new(bits ^ bits >> 31)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_and_fractions() {
        let half = Residue::from_ratio(Ratio::new(-1, 2).unwrap());
        assert_eq!(half + half, -Residue::ONE);
        let value = Residue::new(123_456_789_012_345_678);
        assert_eq!(value * value.recip(), Residue::ONE);
        assert_eq!(
            Residue(MODULUS - 1) * Residue(MODULUS - 1),
            Residue::ONE,
            "(−1)²"
        );
    }
}
