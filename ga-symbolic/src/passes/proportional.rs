//! Sums that are products of another sum.
//!
//! With `n = x² + y² + z²` computed anyway, `(a x)² + (a y)² + (a z)²` is `a² n`, even where `a x` is
//! needed elsewhere: what is written out of products that others read too has a factor in common.
//!
//! It is right by the distributive law.

use rustc_hash::FxHashMap;

use super::rewrite::{Graph, reads, rewrite};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// The longest sum, and the longest product in it, that is written out.
const LONGEST: usize = 12;

/// The factors of a product in order.
type Monomial = Vec<NodeId>;

/// Writes sums as products of earlier ones; `None` where there are none.
#[must_use]
pub fn proportional(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let mut known: FxHashMap<Vec<(Ratio, Monomial)>, (NodeId, Ratio, Monomial)> =
        FxHashMap::default();
    let mut found: FxHashMap<NodeId, (NodeId, Ratio, Monomial)> = FxHashMap::default();
    for id in arena.ids().filter(|id| reads[id.index()] > 0) {
        let Node::Sum(terms) = arena.node(id) else {
            continue;
        };
        let Some((scale, common, rest)) = divided(arena, terms) else {
            continue;
        };
        match known.get(&rest) {
            None => {
                known.insert(rest, (id, scale, common));
            }
            Some((other, other_scale, part)) => {
                if let Some(factors) = without(&common, part)
                    && factors.len() < cost(arena, terms, &reads)
                {
                    found.insert(id, (*other, scale / *other_scale, factors));
                }
            }
        }
    }
    if found.is_empty() {
        return None;
    }
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let (other, scale, factors) = found.get(&id)?;
        let mut multiple = Value::ONE;
        for factor in factors {
            multiple = copy.product(multiple, images[factor.index()]);
        }
        Some(copy.product(multiple, images[other.index()]).scaled(*scale))
    })
}

/// What it costs to add some terms up, and the products that only this sum needs.
fn cost(arena: &Arena, terms: &[Value], reads: &[usize]) -> usize {
    let is_own = |term: &&Value| {
        reads[term.node.index()] == 1 && matches!(arena.node(term.node), Node::Product(..))
    };
    terms.iter().filter(is_own).count() + terms.len() - 1
}

/// A sum as a number, the factors that all terms have in common, and the rest, whose first number
/// is 1.
fn divided(arena: &Arena, terms: &[Value]) -> Option<(Ratio, Monomial, Vec<(Ratio, Monomial)>)> {
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
        factors.sort_unstable();
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
    monomials.sort_by(|(_, a), (_, b)| a.cmp(b));
    let scale = monomials[0].0;
    for (factor, _) in &mut monomials {
        *factor = *factor / scale;
    }
    Some((scale, common, monomials))
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
