//! Powers with a constant exponent: `pow(x, 2)`, `pow(x, 1/2)`.

use super::error::{ResolveError, ResolveErrorKind};
use super::{Bound, Resolver, Result};
use crate::algebra::Ratio;
use crate::parse::{Formula, FormulaKind, Operator};

/// The operation that takes a number, the exponent, beside its operand.
pub(super) const POWER: &str = "pow";

impl<'s> Resolver<'_, 's> {
    /// `pow(base, exponent)`.
    pub(super) fn power(
        &mut self,
        formula: &Formula,
        base: &'s Formula,
        exponent: &Formula,
    ) -> Result<Bound> {
        let Some(value) = constant(exponent) else {
            let kind = ResolveErrorKind::ExponentNotConstant;
            return Err(ResolveError::new(kind, exponent.place()));
        };
        let base = self.single(base)?;
        let step = self.builder.power(base, value);
        step.map(Bound::One).map_err(|error| {
            let kind = ResolveErrorKind::Operation(POWER, error);
            ResolveError::new(kind, formula.place())
        })
    }
}

/// The number that a formula of numbers is.
pub(super) fn constant(formula: &Formula) -> Option<Ratio> {
    match &formula.kind {
        FormulaKind::Number(value) => Some(*value),
        FormulaKind::Negative(inner) => constant(inner).map(|value| -value),
        FormulaKind::Parenthesised(inner) => constant(inner),
        FormulaKind::Binary(operator, a, b) => {
            let (a, b) = (constant(a)?, constant(b)?);
            match operator {
                Operator::Add => Some(a + b),
                Operator::Subtract => Some(a - b),
                Operator::Multiply => Some(a * b),
                Operator::Divide => b.recip().map(|inverse| a * inverse),
                _ => None,
            }
        }
        _ => None,
    }
}
