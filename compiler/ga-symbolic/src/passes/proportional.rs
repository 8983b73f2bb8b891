//! Sums that are multiples of one sum.
//!
//! With `n = x² + y² + z²` computed anyway, `(a x)² + (a y)² + (a z)²` is `a² n`, even where `a x`
//! is needed elsewhere: what is written out of products that others read too has a factor in
//! common. So it is with two such sums, of which neither is n.
//!
//! It is right by the distributive law.

use crate::order::Order as _;
use rustc_hash::FxHashMap;

use super::rewrite::{Graph, reads, rewrite};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// The longest sum, and the longest product in it, that is written out.
const LONGEST: usize = 12;

/// The factors of a product in order.
type Monomial = Vec<NodeId>;

/// Writes sums with a factor and a sum in common as products; `None` where there are none.
#[must_use]
pub fn proportional(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let mut groups: FxHashMap<Rest, Vec<Multiple>> = FxHashMap::default();
    for id in arena.ids().filter(|id| reads[id.index()] > 0) {
        if let Node::Sum(terms) = arena.node(id)
            && let Some((multiple, rest)) = divided(arena, id, terms)
        {
            groups.entry(rest).or_default().push(multiple);
        }
    }
    groups.retain(|rest, multiples| {
        let before = multiples
            .iter()
            .map(|multiple| match arena.node(multiple.id) {
                Node::Sum(terms) => cost(arena, terms, &reads),
                _ => 0,
            });
        let products = rest
            .iter()
            .map(|(_, factors)| factors.len().saturating_sub(1));
        let common = multiples.iter().map(|multiple| multiple.common.len());
        let after = products.sum::<usize>() + rest.len() - 1 + common.sum::<usize>();
        multiples.len() > 1 && after < before.sum::<usize>()
    });
    if groups.is_empty() {
        return None;
    }
    let mut found: FxHashMap<NodeId, (&Rest, &Multiple)> = FxHashMap::default();
    for (rest, multiples) in &groups {
        found.extend(
            multiples
                .iter()
                .map(|multiple| (multiple.id, (rest, multiple))),
        );
    }
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let (rest, multiple) = found.get(&id)?;
        let product = |copy: &mut Arena, first: Value, factors: &[NodeId]| {
            factors.iter().fold(first, |whole, factor| {
                copy.product(whole, images[factor.index()])
            })
        };
        let mut terms = Vec::with_capacity(rest.len());
        for (scale, factors) in *rest {
            terms.push(product(copy, Value::ONE, factors).scaled(*scale));
        }
        let sum = copy.sum(terms);
        Some(product(copy, sum, &multiple.common).scaled(multiple.scale))
    })
}

/// A sum that is a multiple of another.
struct Multiple {
    id: NodeId,
    scale: Ratio,
    /// The factors that all of its terms have.
    common: Monomial,
}

/// The terms without what they have in common, the first with the number 1 in front.
type Rest = Vec<(Ratio, Monomial)>;

/// What it costs to add some terms up, and the products that only this sum needs.
fn cost(arena: &Arena, terms: &[Value], reads: &[usize]) -> usize {
    let is_own = |term: &&Value| {
        reads[term.node.index()] == 1 && matches!(arena.node(term.node), Node::Product(..))
    };
    terms.iter().filter(is_own).count() + terms.len() - 1
}

/// What is common to all terms of a sum, and the rest.
fn divided(arena: &Arena, id: NodeId, terms: &[Value]) -> Option<(Multiple, Rest)> {
    if !(2..=LONGEST).contains(&terms.len()) {
        return None;
    }
    let mut monomials = Vec::with_capacity(terms.len());
    for term in terms {
        let mut factors = Vec::new();
        write_out(arena, term.node, &mut factors);
        if factors.len() > LONGEST {
            return None;
        }
        factors.order();
        monomials.push((term.factor, factors));
    }
    let mut common = monomials[0].1.clone();
    for (_, factors) in &monomials[1..] {
        let mut others = factors.clone();
        common.retain(|factor| {
            let place = others.iter().position(|other| other == factor);
            place.map(|place| others.remove(place)).is_some()
        });
    }
    for (_, factors) in &mut monomials {
        *factors = without(factors, &common)?;
    }
    monomials.order_by(|(_, a), (_, b)| a.cmp(b));
    let scale = monomials[0].0;
    for (factor, _) in &mut monomials {
        *factor = *factor / scale;
    }
    let multiple = Multiple { id, scale, common };
    Some((multiple, monomials))
}

/// The factors that remain of a product; `None` where it has not all of the others.
fn without(factors: &[NodeId], others: &[NodeId]) -> Option<Monomial> {
    let mut rest = factors.to_vec();
    for other in others {
        let place = rest.iter().position(|factor| factor == other)?;
        rest.remove(place);
    }
    Some(rest)
}

fn write_out(arena: &Arena, id: NodeId, factors: &mut Monomial) {
    match arena.node(id) {
        Node::Product(a, b) if factors.len() <= LONGEST => {
            write_out(arena, *a, factors);
            write_out(arena, *b, factors);
        }
        _ => factors.push(id),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Residue;
    use crate::passes::cost;

    #[test]
    fn a_square_of_multiples_is_a_multiple_of_the_square() {
        let mut arena = Arena::default();
        let [a, x, y, z] = [(); 4].map(|()| arena.input());
        let squares = [x, y, z].map(|part| arena.product(part, part));
        let multiples = [x, y, z].map(|part| arena.product(a, part));
        let of_multiples = multiples.map(|part| arena.product(part, part));
        let mut outputs = multiples.to_vec();
        outputs.push(arena.sum(squares));
        outputs.push(arena.sum(of_multiples));
        let before = cost(&arena, &outputs);
        let Some((new, found)) = proportional(&arena, &outputs) else {
            panic!("it pays")
        };
        assert_eq!(before.total() - cost(&new, &found).total(), 3);
        let inputs = [5, 7, 11, 13].map(Residue::new);
        let (before, after) = (arena.evaluate(&inputs), new.evaluate(&inputs));
        for (old, new) in outputs.iter().zip(&found) {
            assert_eq!(before[old.node.index()], after[new.node.index()]);
        }
        assert!(proportional(&arena, &outputs[..4]).is_none());
    }
}
