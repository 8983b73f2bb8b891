//! Random members of a type.

use super::components::Components;
use super::membership::membership;
use super::numbers::{Numbers, coefficient, product, scaled, signed};
use super::stored::from_stored;
use crate::algebra::{Algebra, Blade, Product};
use crate::define::{Coefficient, Role, TypeDefinition};
use crate::ir::{Number, NumberSequence};

/// How many random points are tried, where every type is an irreducible variety.
pub(crate) const POINTS: u64 = 2;

/// How many are tried at most where types have several components.
const MOST_POINTS: u64 = 64;

/// The reproducible sequence of numbers of a seed.
#[must_use]
pub fn sequence(seed: u64) -> NumberSequence {
    NumberSequence::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ 0x6e75_6c6c_636f_6e65)
}

/// A random member of a type; `None` where none is found.
///
/// Where the stored coefficients are free they are drawn at random. Unit versors are products V of
/// `(1 + αb)²/(1 − α²b²)` over the bivectors b that the type has or that its vectors span, with
/// random α, times a unit versor U of a random component of the variety, or `V U ~V`; for most
/// types of even blades U is 1. Blades are outer products of vectors: of those that all blades of
/// the type contain, and of random sums of the others.
#[must_use]
pub fn sample(
    algebra: &Algebra,
    kind: &TypeDefinition,
    sequence: &mut NumberSequence,
) -> Option<Numbers> {
    if let Some(parameters) = &kind.parameters {
        let members = parameters.list.iter();
        let members = members.map(|parameter| sample(algebra, &parameter.kind, sequence));
        let members: Vec<Numbers> = members.collect::<Option<_>>()?;
        return parameters.value.evaluate(algebra, &members)?.pop();
    }
    if kind.facts_are_implied {
        return Some(free_member(kind, sequence));
    }
    if kind.facts.blade {
        return blade(algebra, kind, sequence);
    }
    Components::new(algebra, kind).sample(sequence)
}

/// How many random points show what holds for all members of some types: each component of a type
/// is drawn, and each combination of components of different operands.
#[must_use]
pub fn points(algebra: &Algebra, operands: &[&TypeDefinition]) -> u64 {
    let parts = operands.iter().flat_map(|kind| match &kind.parameters {
        None => vec![*kind],
        Some(parameters) => parameters.list.iter().map(|p| &p.kind).collect(),
    });
    let components = parts
        .filter(|kind| kind.facts.unit_versor && !kind.facts_are_implied && !kind.facts.blade)
        .map(|kind| Components::new(algebra, kind).count() as u64)
        .fold(1, u64::saturating_mul);
    if components <= 1 {
        return POINTS;
    }
    components.saturating_mul(8).min(MOST_POINTS)
}

/// Whether random members are found that have every blade of the type, and all blades have one
/// parity: only then do they represent all of its unit versors or blades.
#[must_use]
pub fn is_family(algebra: &Algebra, kind: &TypeDefinition) -> bool {
    let first = kind.coefficients.first();
    let parity = first.map(|c| c.blade.involute_is_negative());
    let is_mixed = kind
        .coefficients
        .iter()
        .any(|c| Some(c.blade.involute_is_negative()) != parity);
    if is_mixed {
        return false;
    }
    if !kind.facts.blade {
        return Components::new(algebra, kind).are_whole(&mut sequence(0));
    }
    let Some(member) = sample(algebra, kind, &mut sequence(0)) else {
        return false;
    };
    let has = |c: &Coefficient| member.get(&c.blade).is_some_and(|value| !value.is_zero());
    kind.coefficients.iter().all(has)
}

/// A random blade of a type; `None` where the outer products do not lie in the type.
fn blade(
    algebra: &Algebra,
    kind: &TypeDefinition,
    sequence: &mut NumberSequence,
) -> Option<Numbers> {
    let blades = || kind.coefficients.iter().map(|c| c.blade.0);
    let all = blades().fold(0, |all, blade| all | blade);
    let common = Blade(blades().fold(all, |common, blade| common & blade));
    let grade = kind.coefficients.first()?.blade.grade();
    let mut member = Numbers::from([(common, Number::ONE)]);
    for _ in common.grade()..grade {
        let others = Blade(all & !common.0).vectors().map(Blade::vector);
        let vector: Numbers = others
            .map(|vector| (vector, sequence.next_number()))
            .collect();
        member = product(algebra, Product::Wedge, &member, &vector);
    }
    // A multiple has the constant coefficient that the type states.
    let constant = kind.coefficients.iter().find_map(|c| match c.role {
        Role::Constant(value) => Some((c.blade, signed(Number::from_ratio(value), c.is_negative))),
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
pub(super) fn free_member(kind: &TypeDefinition, sequence: &mut NumberSequence) -> Numbers {
    let stored: Vec<_> = kind.stored().map(|_| sequence.next_number()).collect();
    from_stored(kind, &stored)
}
