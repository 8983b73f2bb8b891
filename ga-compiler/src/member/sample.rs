//! Random members of a type.

use super::membership::membership;
use super::numbers::{Numbers, coefficient, product, sandwich, scaled, signed};
use super::stored::from_stored;
use crate::algebra::{Algebra, Blade, Product, Ratio};
use crate::define::{Coefficient, Role, TypeDefinition};
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
/// it where the type has vectors alone. Blades are outer products of vectors: of those that all
/// blades of the type contain, and of random sums of the others.
#[must_use]
pub fn sample(
    algebra: &Algebra,
    kind: &TypeDefinition,
    sequence: &mut ResidueSequence,
) -> Option<Numbers> {
    if kind.facts_are_implied {
        return Some(free_member(kind, sequence));
    }
    if kind.facts.blade {
        return blade(algebra, kind, sequence);
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

/// Whether random members are found that have every blade of the type, and all blades have one
/// parity: only then do they represent all of its unit versors or blades.
#[must_use]
pub(crate) fn is_family(algebra: &Algebra, kind: &TypeDefinition) -> bool {
    let first = kind.coefficients.first();
    let parity = first.map(|c| c.blade.involute_is_negative());
    let is_mixed = kind
        .coefficients
        .iter()
        .any(|c| Some(c.blade.involute_is_negative()) != parity);
    let Some(member) = sample(algebra, kind, &mut sequence(0)) else {
        return false;
    };
    let has = |c: &Coefficient| {
        member
            .get(&c.blade)
            .is_some_and(|value| *value != Residue::ZERO)
    };
    !is_mixed && kind.coefficients.iter().all(has)
}

/// A random blade of a type; `None` where the outer products do not lie in the type.
fn blade(
    algebra: &Algebra,
    kind: &TypeDefinition,
    sequence: &mut ResidueSequence,
) -> Option<Numbers> {
    let blades = || kind.coefficients.iter().map(|c| c.blade.0);
    let all = blades().fold(0, |all, blade| all | blade);
    let common = Blade(blades().fold(all, |common, blade| common & blade));
    let grade = kind.coefficients.first()?.blade.grade();
    let mut member = Numbers::from([(common, Residue::ONE)]);
    for _ in common.grade()..grade {
        let others = Blade(all & !common.0).vectors().map(Blade::vector);
        let vector: Numbers = others
            .map(|vector| (vector, sequence.next_residue()))
            .collect();
        member = product(algebra, Product::Wedge, &member, &vector);
    }
    // A multiple has the constant coefficient that the type states.
    let constant = kind.coefficients.iter().find_map(|c| match c.role {
        Role::Constant(value) => Some((c.blade, signed(Residue::from_ratio(value), c.is_negative))),
        Role::Stored | Role::Derived(_) => None,
    });
    if let Some((blade, value)) = constant {
        member = scaled(&member, value * coefficient(&member, blade).recip());
    }
    membership(algebra, Some(kind), &member)
        .is_empty()
        .then_some(member)
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
