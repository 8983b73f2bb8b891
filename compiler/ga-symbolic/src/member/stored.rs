//! Members of a type from their stored coefficients, and back.

use super::numbers::{Numbers, coefficient, signed};
use crate::define::{PolynomialStep, Role, TypeDefinition};
use crate::ir::Number;

/// The member with the given stored coefficients, in the order and with the signs of the
/// declaration.
#[must_use]
pub fn from_stored(kind: &TypeDefinition, stored: &[Number]) -> Numbers {
    let mut fields = stored.iter().copied();
    let written: Vec<Option<Number>> = kind
        .coefficients
        .iter()
        .map(|c| match &c.role {
            Role::Stored => fields.next(),
            Role::Constant(value) => Some(Number::from_ratio(*value)),
            Role::Derived(_) => None,
        })
        .collect();
    kind.coefficients
        .iter()
        .enumerate()
        .map(|(index, c)| {
            let value = match &c.role {
                Role::Derived(polynomial) => polynomial.evaluate(
                    &mut Number::from_ratio,
                    &mut |place| written[place].unwrap_or(Number::ZERO),
                    &mut |step, a, b| match step {
                        PolynomialStep::Sum => a + b,
                        PolynomialStep::Product => a * b,
                    },
                ),
                Role::Stored | Role::Constant(_) => written[index].unwrap_or(Number::ZERO),
            };
            (c.blade, signed(value, c.is_negative))
        })
        .collect()
}

/// The stored coefficients of a member, in the order and with the signs of the declaration.
#[must_use]
pub fn stored(kind: &TypeDefinition, value: &Numbers) -> Vec<Number> {
    kind.stored()
        .map(|c| signed(coefficient(value, c.blade), c.is_negative))
        .collect()
}
