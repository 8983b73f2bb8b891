//! Products with a reciprocal that is 0 for 0 as quotients, which the other passes know.
//!
//! `a · recip(d) → a/d`, where the quotient is 0 for a d of 0. A reciprocal that is multiplied with
//! itself or with another one stays, since its powers share it.

use rustc_hash::FxHashSet;

use super::rewrite::{Graph, collect_factors, reads, rewrite};
use crate::ir::{Arena, Function, Node, NodeId, Value};

/// Rewrites the products of a graph; `None` where there is no reciprocal.
#[must_use]
pub fn divisor(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let is_reciprocal =
        |id: NodeId| matches!(arena.node(id), Node::Function(Function::Reciprocal, _));
    let live = || arena.ids().filter(|id| reads[id.index()] > 0);
    if !live().any(is_reciprocal) {
        return None;
    }
    let factors = |id: NodeId| {
        let mut factors = Vec::new();
        if let Node::Product(a, b) = arena.node(id) {
            collect_factors(arena, &reads, *a, &mut factors);
            collect_factors(arena, &reads, *b, &mut factors);
        }
        factors
    };
    let mut shared: FxHashSet<NodeId> = FxHashSet::default();
    for id in live() {
        let own: Vec<NodeId> = factors(id)
            .into_iter()
            .filter(|f| is_reciprocal(*f))
            .collect();
        if own.len() > 1 {
            shared.extend(own);
        }
    }
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let product = |copy: &mut Arena, factors: &[NodeId]| {
            factors.iter().fold(Value::ONE, |whole, factor| {
                copy.product(whole, images[factor.index()])
            })
        };
        let (place, rest) = match arena.node(id) {
            Node::Function(Function::Reciprocal, _) if !shared.contains(&id) => (id, Vec::new()),
            Node::Product(..) => {
                let mut rest = factors(id);
                let is_divided = |f: &NodeId| is_reciprocal(*f) && !shared.contains(f);
                let place = rest.iter().position(is_divided)?;
                (rest.remove(place), rest)
            }
            _ => return None,
        };
        let Node::Function(_, argument) = arena.node(place) else {
            return None;
        };
        let argument = argument[0].image(images);
        let divisor = copy.function(Function::Divisor, &[argument]);
        let dividend = product(copy, &rest);
        copy.quotient(dividend, divisor)
    })
}
