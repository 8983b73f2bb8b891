//! Checks of expressions by evaluation over a prime field: what a result is, and that compiled code
//! agrees with its source.
//!
//! An expression is evaluated at random members of its operands' types, in the integers modulo a
//! prime of 61 bits, by its plain meaning: no identity, no fact, no graph. Each equation is tried
//! at two points.

pub use crate::member::{
    Numbers, Reason, facts_not_implied, from_stored, membership, sample, sequence, stored,
};

use crate::algebra::{Algebra, Blade};
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::member;
use crate::order::Order as _;
use crate::program::{self, Program};

/// Checks that the value of an expression is a member of a type, or a scalar, for all members of
/// its operands' types.
///
/// # Errors
/// Each reason why it is not.
pub fn result_fits(
    algebra: &Algebra,
    operands: &[&TypeDefinition],
    expression: &Expression,
    kind: Option<&TypeDefinition>,
) -> Result<(), Vec<String>> {
    let mut reasons = Vec::new();
    for point in 0..member::points(algebra, operands) {
        let Some(result) = at_random(algebra, operands, expression, point) else {
            return Err(vec!["an operand has no members".to_owned()]);
        };
        for reason in membership(algebra, kind, &result) {
            let reason = reason.to_string();
            if !reasons.contains(&reason) {
                reasons.push(reason);
            }
        }
    }
    if reasons.is_empty() {
        Ok(())
    } else {
        Err(reasons)
    }
}

/// The blades that an expression's value really has.
#[must_use]
pub fn result_blades(
    algebra: &Algebra,
    operands: &[&TypeDefinition],
    expression: &Expression,
) -> Vec<Blade> {
    let mut blades = Vec::new();
    for point in 0..member::points(algebra, operands) {
        let result = at_random(algebra, operands, expression, point).unwrap_or_default();
        for (blade, value) in result {
            if !value.is_zero() && !blades.contains(&blade) {
                blades.push(blade);
            }
        }
    }
    blades.order();
    blades
}

fn at_random(
    algebra: &Algebra,
    operands: &[&TypeDefinition],
    expression: &Expression,
    point: u64,
) -> Option<Numbers> {
    let mut sequence = sequence(point);
    let members: Option<Vec<_>> = operands
        .iter()
        .map(|kind| sample(algebra, kind, &mut sequence))
        .collect();
    evaluate(algebra, operands, expression, &members?)
}

/// The value of an expression at given members of its operands' types; `None` where it divides by
/// zero there.
#[must_use]
pub fn evaluate(
    algebra: &Algebra,
    operands: &[&TypeDefinition],
    expression: &Expression,
    members: &[Numbers],
) -> Option<Numbers> {
    let (program, result) = Program::of_expression(operands, expression);
    let mut values = program::evaluate(algebra, &program, members)?;
    Some(values.swap_remove(result.index()))
}
