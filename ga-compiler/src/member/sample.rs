//! Random members of a type.

use super::membership::membership;
use super::numbers::{Numbers, product, sandwich};
use super::stored::from_stored;
use crate::algebra::{Algebra, Blade, Product, Ratio};
use crate::define::TypeDefinition;
use crate::ir::{Residue, ResidueSequence};

/// How many random points are tried.
pub(crate) const POINTS: u64 = 2;

/// The reproducible sequence of residues of a seed.
#[must_use]
pub fn sequence(seed: u64) -> ResidueSequence {
    ResidueSequence::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ 0x6e75_6c6c_636f_6e65)
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
    sequence: &mut ResidueSequence,
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
    let mut versor = Numbers::from([(Blade::SCALAR, Residue::ONE)]);
    for plane in planes {
        let factor = unit_factor(algebra, plane, sequence.next_residue());
        versor = product(algebra, Product::Geometric, &versor, &factor);
    }
    let candidate = if blades.iter().all(|b| b.grade() % 2 == 1) {
        let unit = vectors.iter().find(|b| {
            let square = algebra.geometric(**b, **b);
            *square == [(Blade::SCALAR, Ratio::ONE)]
        })?;
        let unit = Numbers::from([(*unit, Residue::ONE)]);
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

/// The multivector with random stored coefficients, without regard to facts.
pub(super) fn free_member(kind: &TypeDefinition, sequence: &mut ResidueSequence) -> Numbers {
    let stored: Vec<_> = kind.stored().map(|_| sequence.next_residue()).collect();
    from_stored(kind, &stored)
}

/// `(1 + αb)²/(1 − α²b²)`, a unit versor for every 2-blade b of the basis.
fn unit_factor(algebra: &Algebra, plane: Blade, alpha: Residue) -> Numbers {
    let square = algebra
        .geometric(plane, plane)
        .iter()
        .find(|(blade, _)| *blade == Blade::SCALAR)
        .map_or(Residue::ZERO, |(_, value)| Residue::from_ratio(*value));
    let norm = (Residue::ONE - alpha * alpha * square).recip();
    let root = Numbers::from([(Blade::SCALAR, Residue::ONE), (plane, alpha)]);
    let mut versor = product(algebra, Product::Geometric, &root, &root);
    for value in versor.values_mut() {
        *value = *value * norm;
    }
    versor
}
