//! Which facts of a type follow from its blades.

use super::membership::broken_facts;
use super::sample::{POINTS, free_member, sequence};
use crate::algebra::Algebra;
use crate::define::TypeDefinition;

/// The names of the facts that do not hold for every choice of stored coefficients.
#[must_use]
pub fn facts_not_implied(algebra: &Algebra, kind: &TypeDefinition) -> Vec<&'static str> {
    let mut broken = Vec::new();
    for point in 0..POINTS {
        let member = free_member(kind, &mut sequence(point));
        for fact in broken_facts(algebra, kind, &member) {
            if !broken.contains(&fact) {
                broken.push(fact);
            }
        }
    }
    broken
}
