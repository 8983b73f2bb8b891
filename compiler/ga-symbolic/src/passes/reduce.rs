//! Reduction by relations between values.
//!
//! What is known of operands says that some sums are zero: of a unit rotor `s² + a² + b² + c² − 1`,
//! of a unit motor also the scalar and pseudoscalar of `M ~M − 1` with its null part (the Study
//! condition). A multiple of such a sum may be added to any sum, and it is added where the result
//! is cheaper: `s² + a² − b² − c²` becomes `1 − 2 (b² + c²)`.
//!
//! It is right where the relations hold, which is on the members of the operands' types.

use super::flatten::{collected, price};
use super::rewrite::{Graph, reads, rewrite};
use crate::algebra::{Algebra, Blade, Product, Unary};
use crate::ir::{Arena, Function, Multivector, Node, NodeId, Value, plucker};
use crate::order::Order as _;

/// The values that are zero by the facts of an operand: the coefficients of `M ~M − 1` for a unit
/// versor, of `X²` for a null X, and the Plücker relations of a blade.
pub fn relations(arena: &mut Arena, algebra: &Algebra, operand: &Multivector) -> Vec<Value> {
    let (mut zero, mut more) = (Vec::new(), Vec::new());
    if operand.facts.unit_versor {
        let reverse = operand.unary(arena, algebra, Unary::Reverse);
        let square = operand.product(arena, algebra, Product::Geometric, &reverse, |_| true);
        let one = Multivector::new(arena, [(Blade::SCALAR, -Value::ONE)]);
        zero.push(square.sum(arena, &one));
    }
    if operand.facts.null {
        zero.push(operand.product(arena, algebra, Product::Geometric, operand, |_| true));
    }
    if operand.facts.blade {
        more.extend(plucker(arena, operand));
    }
    let coefficients = zero.iter().flat_map(Multivector::terms);
    let values = coefficients.map(|(_, value)| *value);
    values.chain(more).collect()
}

/// Reduces sums by values of the same arena that are known to be zero; `None` where nothing gets
/// cheaper. A relation serves the sums that come after its terms.
#[must_use]
pub fn reduce(arena: &Arena, outputs: &[Value], relations: &[Value]) -> Option<Graph> {
    let known: Vec<Vec<Value>> = relations
        .iter()
        .map(|&relation| collected(without_sums(arena, relation)))
        .filter(|terms| terms.len() > 1)
        .collect();
    if known.is_empty() {
        return None;
    }
    let mut places: Vec<Vec<usize>> = vec![Vec::new(); arena.len()];
    for (place, relation) in known.iter().enumerate() {
        for term in relation {
            places[term.node.index()].push(place);
        }
    }
    let reads = reads(arena, outputs);
    let is_sensitive = sensitive(arena);
    let mut reduced: Vec<Option<Vec<Value>>> = vec![None; arena.len()];
    for id in arena.ids() {
        if let Node::Sum(terms) = arena.node(id)
            && reads[id.index()] > 0
        {
            let next = cheaper(arena, id, terms, (&known, &places), &reads);
            let is_kept = is_sensitive[id.index()]
                && next
                    .as_ref()
                    .is_some_and(|next| gains_a_number(terms, next));
            reduced[id.index()] = next.filter(|_| !is_kept);
        }
    }
    if reduced.iter().all(Option::is_none) {
        return None;
    }
    // The relations may bring in nodes that nothing read before.
    let everything = vec![1; arena.len()];
    rewrite(arena, outputs, &everything, |copy, id, images| {
        let terms = reduced[id.index()].as_ref()?;
        Some(copy.sum(terms.iter().map(|term| term.image(images))))
    })
}

/// Which nodes are divisors or arguments of functions. Where such a value is small, its relative
/// error from cancellation matters. The sine of a small half angle is `√(a² + b² + c²)`, but not
/// `√(1 − s²)`.
fn sensitive(arena: &Arena) -> Vec<bool> {
    let mut is_sensitive = vec![false; arena.len()];
    for id in arena.ids() {
        match arena.node(id) {
            Node::Quotient(_, divisor) => is_sensitive[divisor.index()] = true,
            // A choice is as accurate as what is chosen.
            Node::Function(Function::Select, _) => {}
            Node::Function(_, arguments) => {
                for argument in arguments {
                    is_sensitive[argument.node.index()] = true;
                }
            }
            Node::One | Node::Input(_) | Node::Sum(_) | Node::Product(..) => {}
        }
    }
    is_sensitive
}

/// Whether a sum becomes the difference of a number and something.
fn gains_a_number(before: &[Value], after: &[Value]) -> bool {
    let has_number = |terms: &[Value]| terms.iter().any(|term| term.node == Arena::ONE);
    after.len() > 1 && has_number(after) && !has_number(before)
}

/// The terms of a value, with sums in it replaced by their terms.
fn without_sums(arena: &Arena, value: Value) -> Vec<Value> {
    match arena.node(value.node) {
        Node::Sum(terms) => terms
            .iter()
            .flat_map(|term| without_sums(arena, term.scaled(value.factor)))
            .collect(),
        _ => vec![value],
    }
}

/// The terms of a sum, reduced while it gets cheaper; `None` if it does not. The relations are
/// given with the places of those that have each node.
fn cheaper(
    arena: &Arena,
    id: NodeId,
    terms: &[Value],
    (known, places): (&[Vec<Value>], &[Vec<usize>]),
    reads: &[usize],
) -> Option<Vec<Value>> {
    // Factors come last: the next passes often find a place for them where they cost nothing.
    let full_price = |terms: &[Value]| {
        let own = terms.iter().filter(|term| {
            reads[term.node.index()] <= 1
                && matches!(
                    arena.node(term.node),
                    Node::Product(..) | Node::Quotient(..)
                )
        });
        (own.count() + terms.len(), price(terms))
    };
    let mut best = (full_price(terms), terms.to_vec());
    let mut improved = false;
    loop {
        let current = best.1.clone();
        let mut near: Vec<usize> = current
            .iter()
            .filter(|term| term.node != Arena::ONE)
            .flat_map(|term| places[term.node.index()].iter().copied())
            .collect();
        near.order();
        near.dedup();
        // A sum can only take in nodes that come before it.
        let near = near.into_iter().map(|place| &known[place]);
        for relation in near.filter(|relation| relation.iter().all(|term| term.node < id)) {
            for shared in relation {
                let Some(term) = current.iter().find(|term| term.node == shared.node) else {
                    continue;
                };
                if shared.node == Arena::ONE {
                    continue;
                }
                let factor = -(term.factor / shared.factor);
                let added = relation.iter().map(|value| value.scaled(factor));
                let next = collected(current.iter().copied().chain(added));
                let price = full_price(&next);
                if price < best.0 {
                    best = (price, next);
                    improved = true;
                }
            }
        }
        if best.1 == current {
            return improved.then_some(best.1);
        }
    }
}
