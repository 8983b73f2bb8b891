//! Hoisting: uniform parts of sums and products become nodes of their own.
//!
//! Where some inputs are uniform, `u + w + v` with uniform u and w is one addition for each v if
//! u + w is a node of its own, and `u (w v)` one multiplication as `(u w) v`.
//!
//! A sum that only one other sum reads counts as its terms, so that their uniform parts come
//! together.
//!
//! It is right because addition and multiplication are associative and commutative.

use super::rewrite::{Graph, collect_factors, reads, rewrite};
use super::uniformity::Uniformity;
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// Separates uniform parts from the rest; `None` where there are none to separate.
#[must_use]
pub fn hoist(arena: &Arena, outputs: &[Value], uniform: &[bool]) -> Option<Graph> {
    if !uniform.contains(&true) {
        return None;
    }
    let reads = reads(arena, outputs);
    let mut uniformity = Uniformity::new(uniform);
    let mut changed = false;
    let graph = rewrite(arena, outputs, &reads, |copy, id, images| {
        let mut is_uniform = |id: NodeId| uniformity.is_uniform(arena, id);
        let (first, second): (Vec<Value>, Vec<Value>) = match arena.node(id) {
            Node::Sum(terms) => {
                let mut all = Vec::new();
                for term in terms {
                    collect_terms(arena, &reads, *term, &mut all);
                }
                all.iter().partition(|term| is_uniform(term.node))
            }
            Node::Product(a, b) if !is_uniform(*a) || !is_uniform(*b) => {
                let mut factors = Vec::new();
                collect_factors(arena, &reads, *a, &mut factors);
                collect_factors(arena, &reads, *b, &mut factors);
                let factors = factors.into_iter().map(Value::of);
                factors.partition(|factor| is_uniform(factor.node))
            }
            _ => return None,
        };
        if first.len() < 2 || second.is_empty() {
            return None;
        }
        changed = true;
        let values = |parts: Vec<Value>| -> Vec<Value> {
            parts.into_iter().map(|part| part.image(images)).collect()
        };
        let (first, second) = (values(first), values(second));
        Some(match arena.node(id) {
            Node::Sum(_) => {
                let constant = copy.sum(first);
                copy.sum(second.into_iter().chain([constant]))
            }
            _ => first
                .into_iter()
                .chain(second)
                .fold(Value::ONE, |whole, next| copy.product(whole, next)),
        })
    })?;
    changed.then_some(graph)
}

/// The terms of a sum, with those of inner sums that nothing else reads.
fn collect_terms(arena: &Arena, reads: &[usize], term: Value, terms: &mut Vec<Value>) {
    match arena.node(term.node) {
        Node::Sum(inner)
            if inner.len() > 1
                && reads[term.node.index()] == 1
                && term.factor.abs() == Ratio::ONE =>
        {
            for &part in inner {
                collect_terms(arena, reads, part.scaled(term.factor), terms);
            }
        }
        _ => terms.push(term),
    }
}
