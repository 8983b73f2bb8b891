//! Functions of scalars beyond arithmetic.

use super::{Residue, ResidueSequence};
use crate::algebra::Ratio;

/// A function of scalars beyond arithmetic. The graph knows only that equal arguments give equal
/// results.
///
/// Over the prime field each has a stand-in that satisfies the equations on which membership in a
/// type may depend: squares of roots, `sin² + cos² = 1`, and the like. A function without such an
/// equation is a random function of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// `√x`.
    SquareRoot,
    /// `|x|`.
    Absolute,
    /// `sin x`.
    Sine,
    /// `cos x`.
    Cosine,
    /// The angle of the point (second argument, first argument).
    ArcTangent,
    /// `eˣ`.
    Exponential,
    /// `ln x`.
    NaturalLogarithm,
    /// The Stumpff function c₀(−x), which is C(x) of `exp B = C(B²) + S(B²) B`: cos √−x, for x > 0
    /// cosh √x.
    StumpffCosine,
    /// The Stumpff function c₁(−x), which is S(x) of `exp B = C(B²) + S(B²) B`: sin √−x / √−x, for
    /// x > 0 sinh √x / √x.
    StumpffSine,
    /// The derivative of S, `(C − S)/(2x)`.
    StumpffSineSlope,
    /// 1/S(B²) from C(B²) and `S(B²)² B²`.
    VersorAngle,
    /// `−2 S′(B²)/S(B²)³` from the same.
    VersorAngleSlope,
}

/// Earlier names of variants.
#[allow(non_upper_case_globals)]
impl Function {
    /// Another name of [`StumpffCosine`](Self::StumpffCosine).
    pub const VersorCosine: Self = Self::StumpffCosine;
    /// Another name of [`StumpffSine`](Self::StumpffSine).
    pub const VersorSine: Self = Self::StumpffSine;
    /// Another name of [`StumpffSineSlope`](Self::StumpffSineSlope).
    pub const VersorSineSlope: Self = Self::StumpffSineSlope;
}

impl Function {
    /// Every function.
    pub const ALL: [Self; 12] = [
        Self::SquareRoot,
        Self::Absolute,
        Self::Sine,
        Self::Cosine,
        Self::ArcTangent,
        Self::Exponential,
        Self::NaturalLogarithm,
        Self::StumpffCosine,
        Self::StumpffSine,
        Self::StumpffSineSlope,
        Self::VersorAngle,
        Self::VersorAngleSlope,
    ];

    /// The number of arguments.
    #[must_use]
    pub const fn arity(self) -> usize {
        match self {
            Self::ArcTangent | Self::VersorAngle | Self::VersorAngleSlope => 2,
            Self::SquareRoot
            | Self::Absolute
            | Self::Sine
            | Self::Cosine
            | Self::Exponential
            | Self::NaturalLogarithm
            | Self::StumpffCosine
            | Self::StumpffSine
            | Self::StumpffSineSlope => 1,
        }
    }

    /// The functions that come out of one computation with this one, itself among them.
    #[must_use]
    pub const fn family(self) -> &'static [Self] {
        match self {
            Self::SquareRoot => &[Self::SquareRoot],
            Self::Absolute => &[Self::Absolute],
            Self::Sine | Self::Cosine => &[Self::Sine, Self::Cosine],
            Self::ArcTangent => &[Self::ArcTangent],
            Self::Exponential => &[Self::Exponential],
            Self::NaturalLogarithm => &[Self::NaturalLogarithm],
            Self::StumpffCosine | Self::StumpffSine | Self::StumpffSineSlope => &[
                Self::StumpffCosine,
                Self::StumpffSine,
                Self::StumpffSineSlope,
            ],
            Self::VersorAngle | Self::VersorAngleSlope => {
                &[Self::VersorAngle, Self::VersorAngleSlope]
            }
        }
    }

    /// The stand-in over the prime field. `None` where the argument of a root has none, so that
    /// another point must be tried.
    #[must_use]
    pub fn evaluate(self, arguments: &[Residue]) -> Option<Residue> {
        let x = arguments[0];
        let two = Residue::new(2);
        if let Some(exact) = self.folded(x == Residue::ZERO, x == Residue::ONE) {
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
        })
    }

    /// The stand-in for a root of a constant that has none in the prime field: an arbitrary
    /// residue, whose square is not that constant.
    #[must_use]
    pub fn stand_in(self, arguments: &[Residue]) -> Residue {
        random(self, arguments)
    }

    /// The value at an argument of zero or one, where the graph folds it to a fraction.
    #[must_use]
    pub(crate) fn folded(self, is_zero: bool, is_one: bool) -> Option<Ratio> {
        match self {
            // Absolute values of other constants have other stand-ins over the prime field.
            Self::SquareRoot | Self::Absolute | Self::Sine if is_zero => Some(Ratio::ZERO),
            Self::Cosine | Self::Exponential | Self::StumpffCosine | Self::StumpffSine
                if is_zero =>
            {
                Some(Ratio::ONE)
            }
            Self::StumpffSineSlope if is_zero => Ratio::new(1, 6),
            Self::SquareRoot if is_one => Some(Ratio::ONE),
            Self::NaturalLogarithm if is_one => Some(Ratio::ZERO),
            Self::SquareRoot
            | Self::Absolute
            | Self::Sine
            | Self::Cosine
            | Self::ArcTangent
            | Self::Exponential
            | Self::NaturalLogarithm
            | Self::StumpffCosine
            | Self::StumpffSine
            | Self::StumpffSineSlope
            | Self::VersorAngle
            | Self::VersorAngleSlope => None,
        }
    }
}

/// A reproducible residue of a function and its arguments.
fn random(function: Function, arguments: &[Residue]) -> Residue {
    let start = Residue::new(0x9e37_79b9_7f4a_7c15 ^ function as u64);
    arguments.iter().fold(start, |state, argument| {
        ResidueSequence::new(state.residue() ^ argument.residue().rotate_left(17)).next_residue()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_lists_every_function() {
        // Exhaustive, so that a function added later must be given its place.
        let next = |function: Function| match function {
            Function::SquareRoot => Some(Function::Absolute),
            Function::Absolute => Some(Function::Sine),
            Function::Sine => Some(Function::Cosine),
            Function::Cosine => Some(Function::ArcTangent),
            Function::ArcTangent => Some(Function::Exponential),
            Function::Exponential => Some(Function::NaturalLogarithm),
            Function::NaturalLogarithm => Some(Function::StumpffCosine),
            Function::StumpffCosine => Some(Function::StumpffSine),
            Function::StumpffSine => Some(Function::StumpffSineSlope),
            Function::StumpffSineSlope => Some(Function::VersorAngle),
            Function::VersorAngle => Some(Function::VersorAngleSlope),
            Function::VersorAngleSlope => None,
        };
        let every = std::iter::successors(Some(Function::SquareRoot), |&function| next(function));
        assert!(every.eq(Function::ALL));
    }

    #[test]
    fn stand_ins_satisfy_their_equations() {
        let mut sequence = ResidueSequence::new(5);
        let mut roots = 0;
        for _ in 0..64 {
            let x = sequence.next_residue();
            let value = |function: Function| function.evaluate(&[x]);
            if let Some(root) = value(Function::SquareRoot) {
                assert_eq!(root * root, x);
                roots += 1;
            }
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
        }
        assert!(
            (16..48).contains(&roots),
            "half of all residues are squares"
        );
    }
}
