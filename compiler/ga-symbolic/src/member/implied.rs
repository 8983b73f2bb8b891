//! Which facts of a type follow from its blades.

use super::membership::broken_facts;
use super::sample::{POINTS, free_member, sample, sequence};
use crate::algebra::Algebra;
use crate::define::TypeDefinition;

/// The names of the facts that do not hold for every choice of stored coefficients.
#[must_use]
pub fn facts_not_implied(algebra: &Algebra, kind: &TypeDefinition) -> Vec<&'static str> {
    let mut broken = Vec::new();
    for point in 0..POINTS {
        let member = match &kind.parameters {
            None => Some(free_member(kind, &mut sequence(point))),
            Some(_) => sample(algebra, kind, &mut sequence(point)),
        };
        let Some(member) = member else { continue };
        for fact in broken_facts(algebra, kind, &member) {
            if !broken.contains(&fact) {
                broken.push(fact);
            }
        }
    }
    broken
}
