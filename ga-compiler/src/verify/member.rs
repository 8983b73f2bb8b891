//! Random members of a type.

use super::membership;
use super::numeric::{Numbers, coefficient, product, sandwich, signed};
use crate::algebra::{Algebra, Blade, Product, Ratio};
use crate::define::{PolynomialStep, Role, TypeDefinition};
use crate::ir::{Prime, PrimeSequence};

/// The member with the given stored coefficients, in the order and with the signs of the
/// declaration.
#[must_use]
pub fn from_stored(kind: &TypeDefinition, stored: &[Prime]) -> Numbers {
    let mut fields = stored.iter().copied();
    let written: Vec<Option<Prime>> = kind
        .coefficients
        .iter()
        .map(|c| match &c.role {
            Role::Stored => fields.next(),
            Role::Constant(value) => Some(Prime::from_ratio(*value)),
            Role::Derived(_) => None,
        })
        .collect();
    kind.coefficients
        .iter()
        .enumerate()
        .map(|(index, c)| {
            let value = match &c.role {
                Role::Derived(polynomial) => polynomial.evaluate(
                    &mut Prime::from_ratio,
                    &mut |place| written[place].unwrap_or(Prime::ZERO),
                    &mut |step, a, b| match step {
                        PolynomialStep::Sum => a + b,
                        PolynomialStep::Product => a * b,
                    },
                ),
                _ => written[index].unwrap_or(Prime::ZERO),
            };
            (c.blade, signed(value, c.is_negative))
        })
        .collect()
}

/// The stored coefficients of a member, in the order and with the signs of the declaration.
#[must_use]
pub fn stored(kind: &TypeDefinition, value: &Numbers) -> Vec<Prime> {
    kind.stored()
        .map(|c| signed(coefficient(value, c.blade), c.is_negative))
        .collect()
}

/// A random member of a type; `None` where none is found.
///
/// Where the stored coefficients are free they are drawn at random. Unit versors are products of
/// `(1 + αb)²/(1 − α²b²)` over the 2-blades b that the type has or that its vectors span, with
/// random α; for a type of odd blades such a product times a basis vector of square 1, or acting on
/// it where the type has vectors alone.
#[must_use]
pub fn sample(
    algebra: &Algebra,
    kind: &TypeDefinition,
    sequence: &mut PrimeSequence,
) -> Option<Numbers> {
    if kind.facts_are_implied {
        return Some(free_member(kind, sequence));
    }
    let blades: Vec<Blade> = kind.coefficients.iter().map(|c| c.blade).collect();
    let vectors: Vec<Blade> = blades.iter().copied().filter(|b| b.grade() == 1).collect();
    let mut planes: Vec<Blade> = blades.iter().copied().filter(|b| b.grade() == 2).collect();
    for (place, a) in vectors.iter().enumerate() {
        planes.extend(vectors[place + 1..].iter().map(|b| Blade(a.0 | b.0)));
    }
    planes.sort();
    planes.dedup();
    let mut versor = Numbers::from([(Blade::SCALAR, Prime::ONE)]);
    for plane in planes {
        let factor = unit_factor(algebra, plane, sequence.next_prime());
        versor = product(algebra, Product::Geometric, &versor, &factor);
    }
    let candidate = if blades.iter().all(|b| b.grade() % 2 == 1) {
        let unit = vectors.iter().find(|b| {
            let square = algebra.geometric(**b, **b);
            *square == [(Blade::SCALAR, Ratio::ONE)]
        })?;
        let unit = Numbers::from([(*unit, Prime::ONE)]);
        if vectors.len() == blades.len() {
            sandwich(algebra, &versor, &unit)
        } else {
            product(algebra, Product::Geometric, &versor, &unit)
        }
    } else {
        versor
    };
    membership(algebra, Some(kind), &candidate)
        .is_empty()
        .then_some(candidate)
}

fn free_member(kind: &TypeDefinition, sequence: &mut PrimeSequence) -> Numbers {
    let stored: Vec<_> = kind.stored().map(|_| sequence.next_prime()).collect();
    from_stored(kind, &stored)
}

/// `(1 + αb)²/(1 − α²b²)`, a unit versor for every 2-blade b of the basis.
fn unit_factor(algebra: &Algebra, plane: Blade, alpha: Prime) -> Numbers {
    let square = algebra
        .geometric(plane, plane)
        .iter()
        .find(|(blade, _)| *blade == Blade::SCALAR)
        .map_or(Prime::ZERO, |(_, value)| Prime::from_ratio(*value));
    let norm = (Prime::ONE - alpha * alpha * square).recip();
    let root = Numbers::from([(Blade::SCALAR, Prime::ONE), (plane, alpha)]);
    let mut versor = product(algebra, Product::Geometric, &root, &root);
    for value in versor.values_mut() {
        *value = *value * norm;
    }
    versor
}
