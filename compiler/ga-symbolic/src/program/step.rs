//! The steps of a program.

use crate::algebra::{Blade, Product, Ratio, Unary};
use crate::ir::Function;

/// The place of a step in its program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct StepId(pub(super) usize);

impl StepId {
    /// The place as an index.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0
    }
}

/// An operation on multivectors.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// An operand, by its number.
    Operand(usize),
    /// A basis blade with a factor; numbers are multiples of the scalar blade.
    Constant(Blade, Ratio),
    /// A linear operation.
    Unary(Unary, StepId),
    /// A bilinear product.
    Binary(Product, StepId, StepId),
    /// `M X ~M`, and `M X̂ ~M` for an M that is odd for all operands. So it is `M X ~M` where M is
    /// always zero, where it has even and odd parts, and where it is odd for some operands only.
    Sandwich(StepId, StepId),
    /// A sum.
    Sum(StepId, StepId),
    /// The quotient by a scalar.
    Quotient(StepId, StepId),
    /// The negative.
    Negative(StepId),
    /// The coefficient of a blade, as a scalar.
    Coefficient(StepId, Blade),
    /// A function of scalars or conditions.
    Function(Function, Vec<StepId>),
    /// The second step where the condition that comes first holds, else the third.
    Select(StepId, StepId, StepId),
}

impl Step {
    /// The steps that this one reads.
    #[must_use]
    pub fn reads(&self) -> Vec<StepId> {
        match self {
            Self::Operand(_) | Self::Constant(..) => Vec::new(),
            Self::Unary(_, a) | Self::Negative(a) | Self::Coefficient(a, _) => vec![*a],
            Self::Binary(_, a, b)
            | Self::Sandwich(a, b)
            | Self::Sum(a, b)
            | Self::Quotient(a, b) => vec![*a, *b],
            Self::Function(_, arguments) => arguments.clone(),
            Self::Select(condition, a, b) => vec![*condition, *a, *b],
        }
    }

    /// The same operation on other steps.
    #[must_use]
    pub fn mapped(&self, mut image: impl FnMut(StepId) -> StepId) -> Self {
        match self {
            Self::Operand(_) | Self::Constant(..) => self.clone(),
            Self::Unary(unary, a) => Self::Unary(*unary, image(*a)),
            Self::Binary(product, a, b) => Self::Binary(*product, image(*a), image(*b)),
            Self::Sandwich(a, b) => Self::Sandwich(image(*a), image(*b)),
            Self::Sum(a, b) => Self::Sum(image(*a), image(*b)),
            Self::Quotient(a, b) => Self::Quotient(image(*a), image(*b)),
            Self::Negative(a) => Self::Negative(image(*a)),
            Self::Coefficient(a, blade) => Self::Coefficient(image(*a), *blade),
            Self::Function(function, arguments) => {
                Self::Function(*function, arguments.iter().map(|&a| image(a)).collect())
            }
            Self::Select(condition, a, b) => Self::Select(image(*condition), image(*a), image(*b)),
        }
    }
}

/// Which grades a multivector has, for all operands. Zero is even.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// Even ones.
    Even,
    /// Odd ones.
    Odd,
    /// Some of either.
    Mixed,
}

impl Parity {
    /// Whether a value of this parity may have a blade.
    #[must_use]
    pub const fn allows(self, blade: Blade) -> bool {
        match self {
            Self::Even => !blade.involute_is_negative(),
            Self::Odd => blade.involute_is_negative(),
            Self::Mixed => true,
        }
    }
}
