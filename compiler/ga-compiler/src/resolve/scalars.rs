//! Products of scalars that are written as if they were something else: `x^2` is not a power.

use super::error::{ResolveError, ResolveErrorKind};
use super::power::constant;
use super::{Resolver, Result};
use crate::algebra::Product;
use crate::parse::{Formula, FormulaKind, Operator};
use crate::program::StepId;

impl Resolver<'_, '_> {
    /// Refuses outer, inner and regressive products of two scalars. A function that is called may
    /// have such operands where its own types do not tell; it is checked where it is compiled
    /// itself.
    pub(super) fn check_scalars(
        &self,
        whole: &Formula,
        product: Product,
        [left, right]: [&Formula; 2],
        [a, b]: [StepId; 2],
    ) -> Result<()> {
        let name = match product {
            Product::Wedge => "outer product",
            Product::LeftContraction => "left contraction",
            Product::RightContraction => "right contraction",
            Product::Vee => "regressive product",
            Product::Geometric | Product::ScalarProduct | Product::Commutator => return Ok(()),
        };
        let witness = &self.builder.witness;
        if self.callers.len() > 1 || !witness.is_scalar(a) || !witness.is_scalar(b) {
            return Ok(());
        }
        let plain = format!("{} * {}", factor(left), factor(right));
        let instead = match constant(right) {
            Some(_) if product == Product::Wedge => {
                let (left, right) = (bare(left), bare(right));
                let square = if right.to_string() == "2" {
                    format!(" or `{0} * {0}`", factor(left))
                } else {
                    String::new()
                };
                format!("`{plain}`; a power is written `pow({left}, {right})`{square}")
            }
            _ if product == Product::Vee => format!(
                "which is zero; `{plain}` multiplies them, and `a > 0 && b > 0` joins conditions"
            ),
            _ => format!("`{plain}`; write that if it is meant"),
        };
        let kind = ResolveErrorKind::ProductOfScalars {
            formula: whole.to_string(),
            name,
            instead,
        };
        Err(ResolveError::new(kind, whole.place()))
    }
}

/// A formula as a factor of a product.
fn factor(formula: &Formula) -> String {
    match &formula.kind {
        FormulaKind::Binary(operator, ..) if *operator != Operator::Multiply => {
            format!("({formula})")
        }
        _ => formula.to_string(),
    }
}

/// A formula without parentheses around all of it.
fn bare(formula: &Formula) -> &Formula {
    match &formula.kind {
        FormulaKind::Parenthesised(inner) => bare(inner),
        _ => formula,
    }
}
