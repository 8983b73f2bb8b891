//! Expressions over typed operands as trees, for formulas that the compiler itself writes.

use crate::algebra::{Product, Ratio, Unary};

/// An expression in multivectors.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// An operand, by its number.
    Operand(usize),
    /// A constant scalar.
    Constant(Ratio),
    /// A linear operation on one operand.
    Unary(Unary, Box<Expression>),
    /// A bilinear product.
    Binary(Product, Box<Expression>, Box<Expression>),
    /// `M X ~M`, and `M X̂ ~M` for an M of which all blades are odd.
    Sandwich(Box<Expression>, Box<Expression>),
    /// A sum.
    Sum(Box<Expression>, Box<Expression>),
    /// The quotient by a scalar.
    Quotient(Box<Expression>, Box<Expression>),
    /// The negative.
    Negative(Box<Expression>),
}

impl Expression {
    /// A product of two expressions.
    #[must_use]
    pub fn binary(product: Product, left: Self, right: Self) -> Self {
        Self::Binary(product, Box::new(left), Box::new(right))
    }

    /// A linear operation on an expression.
    #[must_use]
    pub fn unary(operation: Unary, operand: Self) -> Self {
        Self::Unary(operation, Box::new(operand))
    }

    /// The action of a versor on an expression.
    #[must_use]
    pub fn sandwich(versor: Self, operand: Self) -> Self {
        Self::Sandwich(Box::new(versor), Box::new(operand))
    }

    /// The quotient of an expression by a scalar one.
    #[must_use]
    pub fn quotient(dividend: Self, divisor: Self) -> Self {
        Self::Quotient(Box::new(dividend), Box::new(divisor))
    }

    /// The sum of two expressions.
    #[must_use]
    pub fn sum(left: Self, right: Self) -> Self {
        Self::Sum(Box::new(left), Box::new(right))
    }

    /// The difference of two expressions.
    #[must_use]
    pub fn difference(left: Self, right: Self) -> Self {
        Self::sum(left, Self::Negative(Box::new(right)))
    }
}
