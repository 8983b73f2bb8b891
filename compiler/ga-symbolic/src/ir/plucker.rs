//! The equations that make a multivector of one grade a blade.

use super::{Arena, Multivector, NodeId, Value};
use crate::algebra::Blade;
use crate::order::Order as _;

/// The Plücker relations of a multivector of one grade: values that are all zero exactly where it
/// is an outer product of vectors, each once. For X of grade k they are the coefficients of
/// `(b*⌋X)∧X` over all basis blades b of grade k − 1, with the dual basis, so that the metric does
/// not matter. For a bivector they say that `X∧X = 0`.
pub fn plucker(arena: &mut Arena, x: &Multivector) -> Vec<Value> {
    let grade = x.terms().first().map_or(0, |(blade, _)| blade.grade());
    let mut probes: Vec<Blade> = Vec::new();
    for (blade, _) in x.terms() {
        let faces = blade
            .vectors()
            .map(|index| Blade(blade.0 & !Blade::vector(index).0));
        probes.extend(faces.filter(|_| grade > 1));
    }
    probes.order();
    probes.dedup();
    let mut known: Vec<NodeId> = Vec::new();
    let mut relations = Vec::new();
    for probe in probes {
        let containing = x
            .terms()
            .iter()
            .filter(|(blade, _)| blade.0 & probe.0 == probe.0);
        let terms: Vec<_> = containing
            .map(|&(blade, value)| {
                let rest = Blade(blade.0 & !probe.0);
                let is_negative = probe.wedge_is_negative(rest);
                (rest, if is_negative { -value } else { value })
            })
            .collect();
        let vector = Multivector::new(arena, terms);
        let mut products = Vec::new();
        for &(left, a) in vector.terms() {
            for &(right, b) in x.terms() {
                if left.0 & right.0 == 0 {
                    let product = arena.product(a, b);
                    let is_negative = left.wedge_is_negative(right);
                    let whole = Blade(left.0 | right.0);
                    products.push((whole, if is_negative { -product } else { product }));
                }
            }
        }
        for (_, value) in Multivector::new(arena, products).terms() {
            // The same relation comes from several probes, with a factor.
            if !known.contains(&value.node) {
                known.push(value.node);
                relations.push(*value);
            }
        }
    }
    relations
}
