//! The signs of differences: whether `a − b` or `b − a` is computed.
//!
//! The graph holds both as one node with factors 1 and −1. Where an output is the negative of a
//! difference that others read as well, the difference is negated, and the others take its
//! negative: in sums and products this costs nothing.

use super::rewrite::{Graph, reads, rewrite};
use crate::ir::{Arena, Node, NodeId, Value};

/// Negates sums of which more outputs are the negatives; `None` if there are none.
///
/// The sums of the result start with a positive term but are not in canonical order any more, so
/// this comes last.
#[must_use]
pub fn choose_signs(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let mut votes = vec![0_i32; arena.len()];
    for output in outputs.iter().filter(|value| !value.is_zero()) {
        if let Some(sum) = turnable(arena, &reads, output.node) {
            votes[sum.index()] += if output.factor.is_negative() { -1 } else { 1 };
        }
    }
    let is_wanted = |id: NodeId| votes[id.index()] < 0 && reads[id.index()] > 0;
    if !arena.ids().any(is_wanted) {
        return None;
    }
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let Node::Sum(terms) = arena.node(id) else {
            return None;
        };
        if terms.len() < 2 {
            return None;
        }
        let mut terms: Vec<Value> = terms.iter().map(|term| term.image(images)).collect();
        let mut is_turned = is_wanted(id);
        if is_turned {
            terms.iter_mut().for_each(|term| *term = -*term);
        }
        let positive = match terms.iter().position(|term| !term.factor.is_negative()) {
            Some(place) => place,
            None => {
                is_turned = !is_turned;
                terms.iter_mut().for_each(|term| *term = -*term);
                0
            }
        };
        terms[..=positive].rotate_right(1);
        let sum = copy.ordered_sum(terms);
        Some(if is_turned { -sum } else { sum })
    })
}

/// The sum whose negation negates a value: itself, or a factor of a product that is read once.
fn turnable(arena: &Arena, reads: &[usize], id: NodeId) -> Option<NodeId> {
    match arena.node(id) {
        Node::Sum(terms) => {
            let is_mixed = terms.iter().any(|term| term.factor.is_negative());
            (terms.len() > 1 && is_mixed).then_some(id)
        }
        Node::Product(a, b) if reads[id.index()] == 1 => {
            turnable(arena, reads, *a).or_else(|| turnable(arena, reads, *b))
        }
        Node::Quotient(a, _) if reads[id.index()] == 1 => turnable(arena, reads, *a),
        Node::One
        | Node::Input(_)
        | Node::Product(..)
        | Node::Quotient(..)
        | Node::Function(..) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Residue;
    use crate::passes::cost;

    #[test]
    fn a_shared_difference_is_negated() {
        let mut arena = Arena::default();
        let [a, b, c] = [(); 3].map(|()| arena.input());
        let difference = arena.difference(a, b);
        let product = arena.product(difference, c);
        let whole = arena.sum([product, c]);
        let outputs = [-difference, whole];
        assert_eq!(cost(&arena, &outputs).negations, 1);
        let Some((turned, found)) = choose_signs(&arena, &outputs) else {
            panic!("an output is negative")
        };
        assert_eq!(cost(&turned, &found).negations, 0);
        let inputs = [3, 5, 11].map(Residue::new);
        let (before, after) = (arena.evaluate(&inputs), turned.evaluate(&inputs));
        for (old, new) in outputs.iter().zip(&found) {
            let value = |values: &[Residue], value: &Value| {
                values[value.node.index()] * Residue::from_ratio(value.factor)
            };
            assert_eq!(value(&before, old), value(&after, new));
        }
    }
}
