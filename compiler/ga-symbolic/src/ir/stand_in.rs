//! What stands for the functions of scalars over the prime field, and their values at fractions.

use rustc_hash::FxHashMap;

use super::{Function, Residue, ResidueSequence};
use crate::algebra::Ratio;

impl Function {
    /// The stand-in over the prime field. The root of a residue without a root there is a multiple
    /// of i = √−1. `None` where such a number has no root, so that another point must be tried.
    #[must_use]
    pub fn evaluate(self, arguments: &[Residue]) -> Option<Residue> {
        let x = arguments[0];
        let two = Residue::new(2);
        if let Some(exact) = self.exact_at_residues(arguments) {
            return Some(Residue::from_ratio(exact));
        }
        let random = |of: Self| random(of, arguments);
        let circle = || {
            // A point of the unit circle.
            let t = random(Self::Sine);
            let scale = (Residue::ONE + t * t).recip();
            ((Residue::ONE - t * t) * scale, two * t * scale)
        };
        let conic = || {
            // A point of the conic C² − x S² = 1.
            let t = random(Self::StumpffSine);
            let scale = (Residue::ONE - x * t * t).recip();
            ((Residue::ONE + x * t * t) * scale, two * t * scale)
        };
        Some(match self {
            Self::SquareRoot => return x.square_root(),
            Self::Absolute => x.absolute(),
            Self::Sine => circle().1,
            Self::Cosine => circle().0,
            Self::StumpffCosine => conic().0,
            Self::StumpffSine => conic().1,
            Self::StumpffSineSlope => {
                let (cosine, sine) = conic();
                (cosine - sine) * (two * x).recip()
            }
            Self::ArcTangent
            | Self::Exponential
            | Self::NaturalLogarithm
            | Self::VersorAngle
            | Self::VersorAngleSlope => random(self),
            Self::Minimum | Self::Maximum => match random(self).residue() & 1 {
                0 => x,
                _ => arguments[1],
            },
            Self::Less | Self::LessOrEqual => condition(random(self).residue() & 1 == 1),
            // The same for both orders of the numbers.
            Self::Equal => {
                let difference = x - arguments[1];
                let state = self::random(self, &[difference * difference]);
                condition(state.residue() & 1 == 1)
            }
            Self::And => x * arguments[1],
            Self::Or => x + arguments[1] - x * arguments[1],
            Self::Not => Residue::ONE - x,
            Self::Select if x == Residue::ZERO => arguments[2],
            Self::Select => arguments[1],
            // As C and S at x², of which they are cosh x = C and sinh x = x S.
            Self::HyperbolicSine => x * Self::StumpffSine.evaluate(&[x * x])?,
            Self::HyperbolicCosine => Self::StumpffCosine.evaluate(&[x * x])?,
            Self::HyperbolicTangent => {
                let cosine = Self::HyperbolicCosine.evaluate(arguments)?;
                Self::HyperbolicSine.evaluate(arguments)? * cosine.recip()
            }
            Self::Hypotenuse => return (x * x + arguments[1] * arguments[1]).square_root(),
            Self::Reciprocal => x.recip(),
            Self::Divisor => x,
        })
    }

    /// The same, where outcomes are taken for some comparisons.
    pub(crate) fn evaluate_with(
        self,
        arguments: &[Residue],
        outcomes: &Outcomes,
    ) -> Option<Residue> {
        match outcomes.get(self, arguments) {
            Some(holds) => Some(condition(holds)),
            None => self.evaluate(arguments),
        }
    }

    /// The positive factor of the first argument that stands before the function instead:
    /// `√(r² x) = r √x` and `|c x| = |c| |x|`, with what is left of it in the argument.
    pub(crate) fn outer_factor(self, inner: Ratio) -> (Ratio, Ratio) {
        match self {
            Self::SquareRoot => {
                let root = inner.root_factor();
                (root, inner / (root * root))
            }
            Self::Absolute => {
                let size = inner.abs();
                if size.is_of_small_primes() {
                    (size, Ratio::ONE)
                } else {
                    (Ratio::ONE, size)
                }
            }
            Self::Reciprocal => match inner.recip() {
                Some(outer) => (outer, Ratio::ONE),
                None => (Ratio::ONE, inner),
            },
            _ => (Ratio::ONE, inner),
        }
    }

    /// The value at residues that stand for constants: it is that of the constants.
    fn exact_at_residues(self, arguments: &[Residue]) -> Option<Ratio> {
        let constants: Option<Vec<Ratio>> = if self.properties().is_random_choice {
            let each = arguments.iter().map(|x| x.to_ratio(LARGEST_CONSTANT));
            each.collect()
        } else if self.arity() == 1 {
            let simple = [Ratio::ZERO, Ratio::ONE].into_iter();
            let mut simple = simple.filter(|x| Residue::from_ratio(*x) == arguments[0]);
            simple.next().map(|x| vec![x])
        } else {
            None
        };
        self.exact(&constants?)
    }

    /// The value at fractions where it is a fraction for which the stand-in is the same: a positive
    /// one that is a square among the residues, or a comparison of constants that are recognised
    /// there.
    #[must_use]
    pub(crate) fn folded(self, arguments: &[Ratio]) -> Option<Ratio> {
        let value = self.exact(arguments)?;
        let is_same = match self {
            Self::SquareRoot | Self::Hypotenuse | Self::Absolute => value.is_of_small_primes(),
            _ if self.properties().is_random_choice => {
                let largest = i128::from(LARGEST_CONSTANT);
                arguments.iter().all(|x| x.height() <= largest)
            }
            _ => true,
        };
        is_same.then_some(value)
    }

    /// The value at fractions, where it is a fraction itself.
    #[must_use]
    pub(crate) fn exact(self, arguments: &[Ratio]) -> Option<Ratio> {
        let x = arguments[0];
        if arguments.iter().any(|x| x.is_out_of_range()) {
            return None;
        }
        let condition = |holds: bool| Some(if holds { Ratio::ONE } else { Ratio::ZERO });
        let second = || arguments[1];
        let difference = || x - second();
        match self {
            Self::SquareRoot => x.square_root(),
            Self::Hypotenuse => (x * x + second() * second()).square_root(),
            Self::Absolute => Some(x.abs()),
            Self::Sine | Self::HyperbolicSine | Self::HyperbolicTangent if x.is_zero() => {
                Some(Ratio::ZERO)
            }
            Self::Cosine
            | Self::Exponential
            | Self::StumpffCosine
            | Self::StumpffSine
            | Self::HyperbolicCosine
                if x.is_zero() =>
            {
                Some(Ratio::ONE)
            }
            Self::StumpffSineSlope if x.is_zero() => Ratio::new(1, 6),
            Self::NaturalLogarithm if x == Ratio::ONE => Some(Ratio::ZERO),
            Self::Reciprocal => Some(x.recip().unwrap_or(Ratio::ZERO)),
            Self::Minimum => Some(if difference().is_negative() {
                x
            } else {
                second()
            }),
            Self::Maximum => Some(if difference().is_negative() {
                second()
            } else {
                x
            }),
            Self::Less => condition(difference().is_negative()),
            Self::LessOrEqual => condition(difference().is_negative() || difference().is_zero()),
            Self::Equal => condition(difference().is_zero()),
            Self::And => Some(x * second()),
            Self::Or => condition(!(x.is_zero() && second().is_zero())),
            Self::Not => Some(Ratio::ONE - x),
            Self::Select => Some(arguments[if x.is_zero() { 2 } else { 1 }]),
            _ => None,
        }
    }
}

/// The largest numerator and denominator of a constant that is told from a random residue.
const LARGEST_CONSTANT: u64 = 1 << 20;

/// Outcomes that are taken for comparisons of some numbers, in place of random ones.
#[derive(Clone, Debug, Default)]
pub struct Outcomes(FxHashMap<(Function, Vec<u64>), bool>);

impl Outcomes {
    /// Takes an outcome for a comparison of two numbers, unless one is taken already or they are
    /// constants.
    pub(crate) fn set(&mut self, comparison: Function, numbers: &[Residue], holds: bool) {
        if comparison.exact_at_residues(numbers).is_none() {
            self.0.entry(key(comparison, numbers)).or_insert(holds);
        }
    }

    fn get(&self, function: Function, arguments: &[Residue]) -> Option<bool> {
        if self.0.is_empty() || !function.is_condition() {
            return None;
        }
        self.0.get(&key(function, arguments)).copied()
    }
}

/// The same for both orders of numbers that are compared for equality.
fn key(comparison: Function, numbers: &[Residue]) -> (Function, Vec<u64>) {
    let parts = |number: &Residue| [number.residue(), number.imaginary()];
    let parts: Vec<u64> = match (comparison, numbers) {
        (Function::Equal, [a, b]) => parts(&((*a - *b) * (*a - *b))).to_vec(),
        _ => numbers.iter().flat_map(parts).collect(),
    };
    (comparison, parts)
}

/// A condition as a residue.
const fn condition(holds: bool) -> Residue {
    if holds { Residue::ONE } else { Residue::ZERO }
}

/// A reproducible residue of a function and its arguments.
fn random(function: Function, arguments: &[Residue]) -> Residue {
    let start = Residue::new(0x9e37_79b9_7f4a_7c15 ^ function as u64);
    arguments.iter().fold(start, |state, argument| {
        let imaginary = argument.imaginary().rotate_left(31);
        let argument = argument.residue().rotate_left(17) ^ imaginary;
        ResidueSequence::new(state.residue() ^ argument).next_residue()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comparisons_are_conditions_that_take_both_values() {
        let mut sequence = ResidueSequence::new(7);
        for comparison in [Function::Less, Function::LessOrEqual, Function::Equal] {
            let mut held = 0;
            for _ in 0..64 {
                let (x, y) = (sequence.next_residue(), sequence.next_residue());
                let holds = comparison.evaluate(&[x, y]).expect("total");
                assert_eq!(holds * holds, holds, "0 or 1");
                held += holds.residue();
                if comparison == Function::Equal {
                    assert_eq!(comparison.evaluate(&[y, x]), Some(holds));
                }
                let chosen = Function::Select.evaluate(&[holds, x, y]);
                assert_eq!(chosen, Some(if holds == Residue::ONE { x } else { y }));
            }
            assert!((16..48).contains(&held), "{comparison:?}: {held}");
        }
        let (no, yes) = (Residue::ZERO, Residue::ONE);
        for (x, y) in [(no, no), (no, yes), (yes, no), (yes, yes)] {
            let holds = |function: Function| function.evaluate(&[x, y]) == Some(yes);
            assert_eq!(holds(Function::And), x == yes && y == yes);
            assert_eq!(holds(Function::Or), x == yes || y == yes);
            assert_eq!(holds(Function::Not), x == no);
        }
    }

    #[test]
    fn stand_ins_satisfy_their_equations() {
        let mut sequence = ResidueSequence::new(5);
        let mut roots = 0;
        for _ in 0..64 {
            let x = sequence.next_residue();
            let value = |function: Function| function.evaluate(&[x]);
            let root = value(Function::SquareRoot).expect("each residue has a root");
            assert_eq!(root * root, x);
            roots += usize::from(root.is_real());
            let (Some(sine), Some(cosine)) = (value(Function::Sine), value(Function::Cosine))
            else {
                panic!("total")
            };
            assert_eq!(sine * sine + cosine * cosine, Residue::ONE);
            let (Some(c), Some(s), Some(slope)) = (
                value(Function::StumpffCosine),
                value(Function::StumpffSine),
                value(Function::StumpffSineSlope),
            ) else {
                panic!("total")
            };
            assert_eq!(c * c - x * s * s, Residue::ONE);
            assert_eq!(slope * Residue::new(2) * x, c - s);
            assert_eq!(
                value(Function::Absolute),
                Function::Absolute.evaluate(&[-x])
            );
            let (Some(sinh), Some(cosh), Some(tanh)) = (
                value(Function::HyperbolicSine),
                value(Function::HyperbolicCosine),
                value(Function::HyperbolicTangent),
            ) else {
                panic!("total")
            };
            assert_eq!(cosh * cosh - sinh * sinh, Residue::ONE);
            assert_eq!(tanh * cosh, sinh);
            assert_eq!(Function::HyperbolicSine.evaluate(&[-x]), Some(-sinh));
            assert_eq!(Function::HyperbolicCosine.evaluate(&[-x]), Some(cosh));
            let y = sequence.next_residue();
            let length = Function::Hypotenuse.evaluate(&[x, y]).expect("total");
            assert_eq!(length * length, x * x + y * y);
            assert_eq!(Function::Hypotenuse.evaluate(&[y, -x]), Some(length));
            let inverse = Function::Reciprocal.evaluate(&[x]).expect("total");
            assert_eq!(inverse * x, Residue::ONE);
            assert_eq!(Function::Divisor.evaluate(&[x]), Some(x));
        }
        assert!(
            (16..48).contains(&roots),
            "half of all residues are squares"
        );
    }
}
