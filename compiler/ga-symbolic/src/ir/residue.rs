//! The field of integers modulo a prime and the roots of its elements, in which the compiler checks
//! its own work exactly.

use std::ops::{Add, Mul, Neg, Sub};

use crate::algebra::Ratio;

/// How far the modulus is below 2⁶¹. Of the primes 2⁶¹ − d with d < 2³⁰ that are 7 modulo 8, it is
/// the one modulo which the most of the smallest primes are squares: all up to 83.
const BELOW: u64 = 139_666_593;
const MODULUS: u64 = (1 << 61) - BELOW;

/// A residue modulo the prime p = 2⁶¹ − 139,666,593, or `a + b i` with such residues and i² = −1.
///
/// Since p is 3 modulo 4, −1 has no root among the residues, and the numbers `a + b i` form the
/// field of p² elements. Every residue has a root there; the other elements have one in half of the
/// cases.
///
/// Squares take the place of positive numbers: their products and quotients are squares, and of x
/// and −x one is. The primes up to 83 are squares, and so are all positive fractions that consist
/// of them. So the roots of 9 and of 3 x² are those of the real numbers where x is a square. A
/// field has no order, so this is not true of all numbers: signs are decided by real numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Residue {
    real: u64,
    imaginary: u64,
}

impl Residue {
    /// Zero.
    pub const ZERO: Self = Self::real(0);
    /// One.
    pub const ONE: Self = Self::real(1);

    /// The residue of a number.
    #[must_use]
    pub const fn new(value: u64) -> Self {
        Self::real(value % MODULUS)
    }

    const fn real(real: u64) -> Self {
        let imaginary = 0;
        Self { real, imaginary }
    }

    /// The residue as a number below the modulus: a of `a + b i`.
    #[must_use]
    pub const fn residue(self) -> u64 {
        self.real
    }

    /// The factor b of i in `a + b i`.
    #[must_use]
    pub const fn imaginary(self) -> u64 {
        self.imaginary
    }

    /// Whether this is a residue modulo p.
    #[must_use]
    pub const fn is_real(self) -> bool {
        self.imaginary == 0
    }

    /// One of the two roots, the same at each call; `None` for half of the elements that are not
    /// residues modulo p.
    ///
    /// The root of a square of residues is a square itself, so that the root of a product of such
    /// squares is the product of their roots.
    #[must_use]
    pub fn square_root(self) -> Option<Self> {
        if self.is_real() {
            return Some(root(self.real).map_or_else(
                || Self {
                    real: 0,
                    imaginary: power(negative(self.real), (MODULUS + 1) / 4),
                },
                Self::real,
            ));
        }
        // (x + y i)² = a + b i with 2 x² = a + s, s² = a² + b². The product of (a + s)/2 and
        // (a − s)/2 is −b²/4, so exactly one of them is a square.
        let size = root(self.norm())?;
        let half = MODULUS.div_ceil(2);
        let square = |size: u64| multiplied(half, added(self.real, size));
        let real = root(square(size)).or_else(|| root(square(negative(size))))?;
        let inverse = power(added(real, real), MODULUS - 2);
        let imaginary = multiplied(self.imaginary, inverse);
        Some(Self { real, imaginary })
    }

    /// The root of the square: the element or its negative. The absolute value of a product of
    /// residues is the product of their absolute values, as with real numbers.
    #[must_use]
    pub fn absolute(self) -> Self {
        (self * self).square_root().unwrap_or(self)
    }

    /// The image of a fraction. A denominator that the modulus divides gives zero.
    #[must_use]
    pub fn from_ratio(ratio: Ratio) -> Self {
        let residue = |value: i128| {
            let value = value.rem_euclid(i128::from(MODULUS));
            Self::real(u64::try_from(value).unwrap_or(0))
        };
        if ratio.is_integer() {
            return residue(ratio.numerator());
        }
        residue(ratio.numerator()) * residue(ratio.denominator()).recip()
    }

    /// The fraction of small height that a residue is, by the extended algorithm of Euclid
    /// (Wang 1981).
    #[must_use]
    pub fn to_ratio(self, largest: u64) -> Option<Ratio> {
        if !self.is_real() {
            return None;
        }
        let largest = i128::from(largest);
        let (mut a, mut b) = (i128::from(MODULUS), i128::from(self.real));
        let (mut s, mut t) = (0_i128, 1_i128);
        while b > largest {
            let quotient = a / b;
            (a, b) = (b, a - quotient * b);
            (s, t) = (t, s - quotient * t);
        }
        if t.abs() > largest {
            return None;
        }
        Ratio::new(b, t)
    }

    /// The inverse; zero for zero.
    #[must_use]
    pub fn recip(self) -> Self {
        if self.is_real() {
            return Self::real(power(self.real, MODULUS - 2));
        }
        let inverse = power(self.norm(), MODULUS - 2);
        Self {
            real: multiplied(self.real, inverse),
            imaginary: multiplied(negative(self.imaginary), inverse),
        }
    }

    /// `a² + b²`, which is zero for zero only.
    fn norm(self) -> u64 {
        added(
            multiplied(self.real, self.real),
            multiplied(self.imaginary, self.imaginary),
        )
    }
}

const fn added(a: u64, b: u64) -> u64 {
    let sum = a + b;
    if sum < MODULUS { sum } else { sum - MODULUS }
}

const fn negative(a: u64) -> u64 {
    if a == 0 { 0 } else { MODULUS - a }
}

#[allow(clippy::cast_possible_truncation, reason = "the lower bits are meant")]
const fn multiplied(a: u64, b: u64) -> u64 {
    const LOW: u64 = (1 << 61) - 1;
    let wide = a as u128 * b as u128;
    // 2⁶¹ is BELOW. The higher half is below 2⁶¹, then below 2²⁹.
    let folded = (wide >> 61) * BELOW as u128 + (wide as u64 & LOW) as u128;
    let twice = (folded >> 61) as u64 * BELOW + (folded as u64 & LOW);
    if twice < MODULUS {
        twice
    } else {
        twice - MODULUS
    }
}

const fn power(mut base: u64, mut exponent: u64) -> u64 {
    let mut power = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = multiplied(power, base);
        }
        base = multiplied(base, base);
        exponent >>= 1;
    }
    power
}

/// The root that is a square itself, of a square modulo p.
fn root(square: u64) -> Option<u64> {
    let root = power(square, (MODULUS + 1) / 4);
    (multiplied(root, root) == square).then_some(root)
}

impl Add for Residue {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            real: added(self.real, other.real),
            imaginary: added(self.imaginary, other.imaginary),
        }
    }
}

impl Sub for Residue {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Residue {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            real: negative(self.real),
            imaginary: negative(self.imaginary),
        }
    }
}

impl Mul for Residue {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let real = multiplied(a.real, b.real);
        if a.is_real() && b.is_real() {
            return Self::real(real);
        }
        let square = multiplied(a.imaginary, b.imaginary);
        let imaginary = added(
            multiplied(a.real, b.imaginary),
            multiplied(a.imaginary, b.real),
        );
        Self {
            real: added(real, negative(square)),
            imaginary,
        }
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
            Residue::new(MODULUS - 1) * Residue::new(MODULUS - 1),
            Residue::ONE,
            "(−1)²"
        );
    }

    #[test]
    fn products_agree_with_those_of_wide_integers() {
        let mut sequence = ResidueSequence::new(11);
        let edges = [0, 1, 2, BELOW, MODULUS - 1, MODULUS / 2].map(Residue::new);
        let random: Vec<Residue> = (0..64).map(|_| sequence.next_residue()).collect();
        for &a in edges.iter().chain(&random) {
            for &b in edges.iter().chain(&random) {
                let wide = u128::from(a.residue()) * u128::from(b.residue());
                assert_eq!(u128::from((a * b).residue()), wide % u128::from(MODULUS));
            }
        }
    }

    #[test]
    fn positive_fractions_of_small_primes_are_squares() {
        for number in 1..=88_i128 {
            let root = |n, d| Residue::from_ratio(Ratio::new(n, d).unwrap()).square_root();
            assert!(root(number, 1).unwrap().is_real(), "{number}");
            assert!(!root(-number, 1).unwrap().is_real(), "−{number}");
            assert_eq!(
                root(number * number, 49),
                Some(Residue::from_ratio(Ratio::new(number, 7).unwrap()))
            );
        }
    }

    #[test]
    fn roots_of_residues_exist_beside_them() {
        let mut sequence = ResidueSequence::new(3);
        let mut roots = 0;
        for _ in 0..64 {
            let (a, b) = (sequence.next_residue(), sequence.next_residue());
            let root = |x: Residue| x.square_root().expect("each residue has one");
            assert_eq!(root(a) * root(a), a);
            assert_eq!(root(a).is_real(), !root(-a).is_real());
            assert_eq!((a * a).square_root(), Some(a.absolute()));
            assert_eq!((a * b).absolute(), a.absolute() * b.absolute());
            if root(a).is_real() && root(b).is_real() {
                assert_eq!(root(a * b), root(a) * root(b));
            }
            let z = a + b * root(-Residue::ONE);
            assert_eq!(z * z.recip(), Residue::ONE);
            assert_eq!(z - z, Residue::ZERO);
            let square = root(z * z);
            assert!(square == z || square == -z);
            if let Some(root) = z.square_root() {
                assert_eq!(root * root, z);
                roots += 1;
            }
        }
        assert!((16..48).contains(&roots), "half of the others are squares");
    }
}
