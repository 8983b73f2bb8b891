//! The products that a declaration asks for.

use super::TypeDefinition;
use crate::algebra::{Product, Unary};
use crate::expression::Expression;

/// An operation that a declaration may ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// A bilinear product.
    Product(Product),
    /// The dual or its inverse.
    Unary(Unary),
    /// The action of a versor.
    Sandwich,
}

/// One operation on given types.
#[derive(Clone)]
pub struct ProductDefinition {
    /// The operation.
    pub operation: Operation,
    /// The types of the operands, as indices.
    pub operands: Vec<usize>,
    /// For each operand that must be a blade though not all members of its type are, the type with
    /// that fact.
    pub as_blades: Vec<Option<TypeDefinition>>,
    /// The type of the result, as an index; none for a scalar.
    pub result: Option<usize>,
}

impl Operation {
    /// The operation of that name in declarations.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "dual" => Some(Self::Unary(Unary::Dual)),
            "undual" => Some(Self::Unary(Unary::Undual)),
            "sandwich" => Some(Self::Sandwich),
            other => Product::from_name(other).map(Self::Product),
        }
    }

    /// The name in declarations and of methods.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Product(product) => product.name(),
            Self::Unary(unary) => unary.name(),
            Self::Sandwich => "sandwich",
        }
    }

    /// The operation as an expression of operands 0 and 1.
    #[must_use]
    pub fn expression(self) -> Expression {
        let (first, second) = (Expression::Operand(0), Expression::Operand(1));
        match self {
            Self::Product(product) => Expression::binary(product, first, second),
            Self::Unary(operation) => Expression::unary(operation, first),
            Self::Sandwich => Expression::sandwich(first, second),
        }
    }

    /// The number of operands.
    #[must_use]
    pub const fn arity(self) -> usize {
        match self {
            Self::Unary(_) => 1,
            Self::Product(_) | Self::Sandwich => 2,
        }
    }
}
