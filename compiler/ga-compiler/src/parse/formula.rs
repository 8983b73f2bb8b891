//! Formulas as they are written: names, numbers, operators and calls, each with its place.

use std::fmt;

use syn::{Error, Ident, Result};

use super::nesting::{MAX_NESTING, MAX_OPERATORS, too_deep, too_long};
use super::operator::Operator;
use super::place::Place;
use crate::algebra::Ratio;

/// A formula with its place in the source.
#[derive(Clone, Debug)]
pub struct Formula {
    /// Its form and its parts.
    pub kind: FormulaKind,
    place: Place,
    /// How many levels it nests, not counting operators.
    nesting: usize,
    /// How many formulas contain each other, operators included.
    depth: usize,
}

/// The forms of formulas.
#[derive(Clone, Debug)]
pub enum FormulaKind {
    /// An operand, a name bound by `let`, a blade or a constant type.
    Name(Ident),
    /// A number, exact as it is written.
    Number(Ratio),
    /// `-a`.
    Negative(Box<Formula>),
    /// `!a` of a condition.
    Not(Box<Formula>),
    /// `a * b` and the like.
    Binary(Operator, Box<Formula>, Box<Formula>),
    /// `f(a, b)` or `a.f(b)`.
    Call(Ident, Vec<Formula>),
    /// `a.e12`.
    Coefficient(Box<Formula>, Ident),
    /// `a[0]` or `a.0`.
    Element(Box<Formula>, usize),
    /// `(a)`.
    Parenthesised(Box<Formula>),
    /// `(a, b)`.
    Tuple(Vec<Formula>),
    /// `[a, b]`.
    Array(Vec<Formula>),
}

impl Formula {
    /// The place of the whole formula.
    #[must_use]
    pub const fn place(&self) -> Place {
        self.place
    }

    /// An error that points at the whole formula.
    #[must_use]
    pub fn error(&self, message: impl fmt::Display) -> Error {
        self.place.error(message)
    }

    /// A formula over its parts, unless it nests too deep with them.
    pub(super) fn new(kind: FormulaKind, place: Place) -> Result<Self> {
        let level = usize::from(!matches!(kind, FormulaKind::Binary(..)));
        let (mut nesting, mut depth) = (0, 0);
        for part in kind.parts() {
            nesting = nesting.max(part.nesting + level);
            depth = depth.max(part.depth + 1);
        }
        if nesting > MAX_NESTING {
            return Err(place.error(too_deep()));
        }
        if depth > MAX_OPERATORS + MAX_NESTING {
            return Err(place.error(too_long()));
        }
        Ok(Self {
            kind,
            place,
            nesting,
            depth,
        })
    }
}

impl FormulaKind {
    /// The formulas that this one is made of.
    fn parts(&self) -> impl Iterator<Item = &Formula> {
        let (one, other, list): (Option<&Formula>, Option<&Formula>, &[Formula]) = match self {
            Self::Name(_) | Self::Number(_) => (None, None, &[]),
            Self::Negative(a)
            | Self::Not(a)
            | Self::Coefficient(a, _)
            | Self::Element(a, _)
            | Self::Parenthesised(a) => (Some(a), None, &[]),
            Self::Binary(_, a, b) => (Some(a), Some(b), &[]),
            Self::Call(_, parts) | Self::Tuple(parts) | Self::Array(parts) => (None, None, parts),
        };
        one.into_iter().chain(other).chain(list)
    }
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |parts: &[Self]| {
            let parts: Vec<_> = parts.iter().map(ToString::to_string).collect();
            parts.join(", ")
        };
        match &self.kind {
            FormulaKind::Name(name) => write!(f, "{name}"),
            FormulaKind::Number(value) => write!(f, "{value}"),
            FormulaKind::Negative(operand) => write!(f, "-{operand}"),
            FormulaKind::Not(operand) => write!(f, "!{operand}"),
            FormulaKind::Binary(operator, a, b) => write!(f, "{a} {} {b}", operator.symbol()),
            FormulaKind::Call(name, arguments) => write!(f, "{name}({})", list(arguments)),
            FormulaKind::Coefficient(operand, name) => write!(f, "{operand}.{name}"),
            FormulaKind::Element(operand, place) => write!(f, "{operand}[{place}]"),
            FormulaKind::Parenthesised(inner) => write!(f, "({inner})"),
            FormulaKind::Tuple(parts) => write!(f, "({})", list(parts)),
            FormulaKind::Array(parts) => write!(f, "[{}]", list(parts)),
        }
    }
}
