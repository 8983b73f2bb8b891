//! Operands: stored coefficients are inputs, constants are constants, derived ones follow.

use crate::define::{PolynomialStep, Role, TypeDefinition};
use crate::ir::{Arena, Multivector, Value};

/// An operand of a type. Its stored coefficients become the next inputs of the arena, in the order
/// of the declaration and as they are written there. `held` derived coefficients keep their
/// constant factors, the ½ of ½x² for instance, which pays where many products read them.
pub fn operand(arena: &mut Arena, kind: &TypeDefinition, held: bool) -> Multivector {
    let stored: Vec<Value> = kind.stored().map(|_| arena.input()).collect();
    complete(arena, kind, &stored, held)
}

/// The stored coefficients of a member of a type, as they are written.
pub(super) fn stored(kind: &TypeDefinition, value: &Multivector) -> impl Iterator<Item = Value> {
    kind.stored().map(|coefficient| {
        let found = value.coefficient(coefficient.blade);
        if coefficient.is_negative {
            -found
        } else {
            found
        }
    })
}

/// A member of a type from its stored coefficients as they are written.
pub(super) fn from_stored(
    arena: &mut Arena,
    kind: &TypeDefinition,
    stored: &[Value],
) -> Multivector {
    complete(arena, kind, stored, false)
}

/// A value that is known to be a member of a type, with constants for its constant coefficients and
/// with its derived ones computed from the stored ones, so that nothing else that led to them is
/// needed.
pub(super) fn rederived(
    arena: &mut Arena,
    kind: &TypeDefinition,
    value: &Multivector,
) -> Multivector {
    let stored: Vec<Value> = stored(kind, value).collect();
    let facts = value.facts.and(kind.facts);
    complete(arena, kind, &stored, false).with_facts(facts)
}

/// A member of a type from its stored coefficients as written; the others follow from the type.
fn complete(arena: &mut Arena, kind: &TypeDefinition, stored: &[Value], held: bool) -> Multivector {
    let mut stored = stored.iter().copied();
    let written: Vec<Value> = kind
        .coefficients
        .iter()
        .map(|c| match &c.role {
            Role::Stored => stored.next().unwrap_or(Value::ZERO),
            Role::Constant(value) => Value::constant(*value),
            Role::Derived(_) => Value::ZERO,
        })
        .collect();
    let mut terms = Vec::with_capacity(written.len());
    for (index, coefficient) in kind.coefficients.iter().enumerate() {
        let value = match &coefficient.role {
            Role::Derived(polynomial) => polynomial.evaluate(
                &mut Value::constant,
                &mut |place| written[place],
                &mut |step, a, b| match step {
                    PolynomialStep::Sum => arena.sum([a, b]),
                    PolynomialStep::Product => arena.product(a, b),
                },
            ),
            Role::Stored | Role::Constant(_) => written[index],
        };
        let is_held = held && matches!(coefficient.role, Role::Derived(_));
        let value = if is_held { arena.held(value) } else { value };
        let value = if coefficient.is_negative {
            -value
        } else {
            value
        };
        terms.push((coefficient.blade, value));
    }
    Multivector::new(arena, terms).with_facts(kind.facts)
}
