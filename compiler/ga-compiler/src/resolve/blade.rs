//! Types whose members are blades.

use crate::define::{Definition, TypeDefinition};
use crate::member;

/// A type with the fact that its members are blades; `None` where all of them are, or none.
pub(crate) fn as_blade(definition: &Definition, index: usize) -> Option<&TypeDefinition> {
    let known = definition.as_blades.get_or_init(|| {
        let types = definition.types.iter();
        types.map(|kind| with_blade(definition, kind)).collect()
    });
    known.get(index)?.as_ref()
}

/// The type whose members are the blades among those of another; `None` where all or none are.
fn with_blade(definition: &Definition, kind: &TypeDefinition) -> Option<TypeDefinition> {
    let first = kind.coefficients.first()?.blade.grade();
    let is_of_one_grade = kind.coefficients.iter().all(|c| c.blade.grade() == first);
    if !is_of_one_grade || !kind.facts_are_implied || kind.facts.blade {
        return None;
    }
    let mut with_blade = kind.clone();
    with_blade.facts.blade = true;
    let algebra = &definition.algebra;
    with_blade.facts_are_implied = member::facts_not_implied(algebra, &with_blade).is_empty();
    let is_needed = !with_blade.facts_are_implied;
    (is_needed && member::is_family(algebra, &with_blade)).then_some(with_blade)
}
