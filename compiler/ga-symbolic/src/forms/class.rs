//! One class of equal multivectors, and the operations between classes.

use super::FormRule;
use crate::algebra::{Blade, Product, Ratio, Unary};
use crate::ir::Function;
use crate::member::Numbers;

/// The place of a class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct ClassId(pub(super) usize);

impl ClassId {
    pub(super) const fn index(self) -> usize {
        self.0
    }
}

/// A multiple of the multivector that stands for a class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Term {
    pub(super) class: ClassId,
    pub(super) factor: Ratio,
}

impl Term {
    pub(super) const fn of(class: ClassId) -> Self {
        Self {
            class,
            factor: Ratio::ONE,
        }
    }

    pub(super) fn scaled(self, factor: Ratio) -> Self {
        Self {
            factor: self.factor * factor,
            ..self
        }
    }
}

/// An operation on classes. The multivectors that stand for the classes are its operands.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operation {
    Operand(usize),
    Blade(Blade),
    Unary(Unary, ClassId),
    /// Two factors, or more of the geometric and of the outer product.
    Product(Product, Vec<ClassId>),
    Sandwich(ClassId, ClassId),
    Sum(Vec<Term>),
    Quotient(ClassId, ClassId),
    Coefficient(ClassId, Blade),
    Function(Function, Vec<Term>),
}

impl Operation {
    /// The classes that it reads.
    pub(super) fn reads(&self) -> Vec<ClassId> {
        match self {
            Self::Operand(_) | Self::Blade(_) => Vec::new(),
            Self::Unary(_, a) | Self::Coefficient(a, _) => vec![*a],
            Self::Product(_, factors) => factors.clone(),
            Self::Sandwich(a, b) | Self::Quotient(a, b) => vec![*a, *b],
            Self::Sum(terms) | Self::Function(_, terms) => terms.iter().map(|t| t.class).collect(),
        }
    }
}

/// One way to a class.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub(super) operation: Operation,
    /// The multivector of the class is this multiple of what the operation gives.
    pub(super) factor: Ratio,
    /// The rule that proposed it.
    pub(super) rule: Option<FormRule>,
}

/// A multivector, and all known ways to it.
#[derive(Clone, Debug)]
pub(super) struct Class {
    /// What it is at each point of the witness; no zeros.
    pub(super) values: Vec<Numbers>,
    /// Divisors and arguments that must be in range for it to exist.
    pub(super) limits: Vec<Limit>,
    pub(super) ways: Vec<Way>,
    /// Whether it is the same for all operands.
    pub(super) is_constant: bool,
    /// Whether it depends on uniform operands alone.
    pub(super) is_uniform: bool,
    /// The operands that it was computed from, in rising order.
    pub(super) operands: Vec<usize>,
    /// Whether it is a unit versor, once that was asked.
    pub(super) is_unit: Option<bool>,
}

impl Class {
    /// Whether there is nothing to gain by taking it apart: an operand or a constant.
    pub(super) fn is_leaf(&self) -> bool {
        let mut ways = self.ways.iter();
        self.is_constant || ways.any(|way| matches!(way.operation, Operation::Operand(_)))
    }
}

/// What limits where a value exists: a divisor, or the argument of a function.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Limit(
    pub(super) Option<Function>,
    pub(super) ClassId,
    pub(super) Option<Ratio>,
);
