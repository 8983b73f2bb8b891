//! Numbers by which the compiler checks its work: residues for exactness, real numbers for signs.

use std::ops::{Add, Mul, Neg, Sub};

use super::{Function, Outcomes, Real, Residue, ResidueSequence};
use crate::algebra::Ratio;

/// A residue and a real number that stand for the same value at two independent random points: one
/// of the prime field, one of real space. Either may be missing.
///
/// What is equal is equal in both. A residue has no sign, so that `√(q²)` is q for some q and −q
/// for others, whatever their size; a real number is rounded, so that what is nearly equal seems
/// equal. Only an identity that holds in both is used.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    residue: Option<Residue>,
    real: Real,
}

/// Which parts of a number there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Parts {
    pub(crate) residue: bool,
    pub(crate) real: bool,
}

impl Parts {
    pub(crate) const BOTH: Self = Self {
        residue: true,
        real: true,
    };

    pub(crate) const fn and(self, other: Self) -> Self {
        Self {
            residue: self.residue && other.residue,
            real: self.real && other.real,
        }
    }

    /// The parts that the other does not have.
    pub(crate) const fn without(self, other: Self) -> Self {
        Self {
            residue: self.residue && !other.residue,
            real: self.real && !other.real,
        }
    }

    pub(crate) const fn any(self) -> bool {
        self.residue || self.real
    }
}

impl Number {
    /// Zero.
    pub const ZERO: Self = Self {
        residue: Some(Residue::ZERO),
        real: Real::exact(0.0),
    };
    /// One.
    pub const ONE: Self = Self {
        residue: Some(Residue::ONE),
        real: Real::exact(1.0),
    };

    /// The number of two parts.
    #[must_use]
    pub const fn new(residue: Option<Residue>, real: Real) -> Self {
        Self { residue, real }
    }

    /// The image of a fraction.
    #[must_use]
    pub fn from_ratio(ratio: Ratio) -> Self {
        // Most factors are signs.
        if ratio == Ratio::ONE {
            return Self::ONE;
        }
        if ratio == Ratio::integer(-1) {
            return -Self::ONE;
        }
        Self {
            residue: Some(Residue::from_ratio(ratio)),
            real: Real::from_ratio(ratio),
        }
    }

    /// The residue, if there is one.
    #[must_use]
    pub const fn residue(self) -> Option<Residue> {
        self.residue
    }

    /// The real number.
    #[must_use]
    pub const fn real(self) -> Real {
        self.real
    }

    /// Which parts the number has.
    pub(crate) const fn parts(self) -> Parts {
        Parts {
            residue: self.residue.is_some(),
            real: self.real.is_known(),
        }
    }

    /// Whether nothing says that the number is not zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.residue.is_none_or(|residue| residue == Residue::ZERO) && self.real.may_be_zero()
    }

    /// Whether a number that was computed in another way agrees with what is expected. It must have
    /// the parts that are expected; only where rounding hides the sign of a divisor or of the
    /// argument of a function nothing is known of the real number.
    #[must_use]
    pub fn stands_for(self, expected: Self) -> bool {
        let residue = self.residue == expected.residue || expected.residue.is_none();
        let real = !expected.real.is_known() || !self.real.is_none();
        residue && real && self.real.may_equal(expected.real)
    }

    /// The inverse; a part that is zero has none.
    #[must_use]
    pub fn recip(self) -> Self {
        let residue = self.residue.filter(|residue| *residue != Residue::ZERO);
        Self {
            residue: residue.map(Residue::recip),
            real: self.real.recip(),
        }
    }

    /// A function, by its stand-in over the prime field and its value among the real numbers.
    /// `outcomes` are taken for comparisons of residues.
    pub(crate) fn function(function: Function, arguments: &[Self], outcomes: &Outcomes) -> Self {
        let reals: Vec<Real> = arguments.iter().map(|x| x.real).collect();
        let residue = if function == Function::Select {
            // What is not chosen need not exist.
            let condition = arguments[0].residue;
            condition
                .and_then(|holds| arguments[if holds == Residue::ZERO { 2 } else { 1 }].residue)
        } else {
            let residues: Option<Vec<Residue>> = arguments.iter().map(|x| x.residue).collect();
            residues.and_then(|all| function.evaluate_with(&all, outcomes))
        };
        Self {
            residue,
            real: Real::function(function, &reals),
        }
    }

    /// The number with the residue of another, or with its real part.
    pub(crate) fn with_parts_of(self, other: Self, parts: Parts) -> Self {
        Self {
            residue: if parts.residue {
                other.residue
            } else {
                self.residue
            },
            real: if parts.real { other.real } else { self.real },
        }
    }

    /// The number without those parts that are not kept.
    pub(crate) fn only(self, parts: Parts) -> Self {
        Self {
            residue: self.residue.filter(|_| parts.residue),
            real: if parts.real { self.real } else { Real::UNKNOWN },
        }
    }
}

impl PartialEq for Number {
    /// Whether nothing says that the numbers differ.
    fn eq(&self, other: &Self) -> bool {
        let is_same = match (self.residue, other.residue) {
            (Some(a), Some(b)) => a == b,
            _ => true,
        };
        is_same && self.real.may_equal(other.real)
    }
}

impl From<Residue> for Number {
    fn from(residue: Residue) -> Self {
        Self {
            residue: Some(residue),
            real: Real::UNKNOWN,
        }
    }
}

impl Add for Number {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            residue: self.residue.zip(other.residue).map(|(a, b)| a + b),
            real: self.real + other.real,
        }
    }
}

impl Sub for Number {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Number {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            residue: self.residue.map(Neg::neg),
            real: -self.real,
        }
    }
}

impl Mul for Number {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            residue: self.residue.zip(other.residue).map(|(a, b)| a * b),
            real: self.real * other.real,
        }
    }
}

/// Random numbers: residues, with real numbers where signs matter.
#[derive(Clone, Debug)]
pub struct NumberSequence {
    sequence: ResidueSequence,
    with_reals: bool,
}

impl NumberSequence {
    /// The sequence of a seed, of residues alone.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self {
            sequence: ResidueSequence::new(seed),
            with_reals: false,
        }
    }

    /// The same residues, each with a real number.
    #[must_use]
    pub const fn with_reals(mut self, with_reals: bool) -> Self {
        self.with_reals = with_reals;
        self
    }

    /// The next number.
    pub fn next_number(&mut self) -> Number {
        let residue = self.sequence.next_residue();
        // A sequence of its own, so that residues do not depend on real numbers.
        let real = match self.with_reals {
            true => Real::random(&mut ResidueSequence::new(residue.residue().rotate_left(23))),
            false => Real::UNKNOWN,
        };
        Number::new(Some(residue), real)
    }

    /// A whole number below a bound.
    pub fn below(&mut self, bound: usize) -> usize {
        let residue = self.sequence.next_residue().residue();
        // The remainder is below the bound.
        usize::try_from(residue % (bound as u64).max(1)).unwrap_or(0)
    }
}
