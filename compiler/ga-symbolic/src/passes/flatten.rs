//! Sums of sums.
//!
//! A sum that is read by one other sum only is merged into it, which costs no addition and lets
//! equal terms collect or cancel. A sum that is read elsewhere too is merged where enough cancels
//! that the outer sum costs no more than before: with `n = x² + y² + z²` the sum `x² + y² + z² − n`
//! is 0. Multiples that were held as nodes become factors again.
//!
//! It is right because addition is associative and commutative.

use super::rewrite::{Graph, reads, rewrite};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, Value};
use crate::order::Order as _;

/// Merges sums; `None` where there is nothing to merge.
#[must_use]
pub fn flatten(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let is_sum = |value: &Value| matches!(arena.node(value.node), Node::Sum(_));
    let has_work = arena.ids().any(|id| {
        reads[id.index()] > 0
            && match arena.node(id) {
                Node::Sum(terms) => terms.len() == 1 || terms.iter().any(is_sum),
                _ => false,
            }
    });
    if !has_work {
        return None;
    }
    // The sums that are taken apart where they are read, however deep they stand.
    let mut is_inner = vec![false; arena.len()];
    for id in arena.ids().filter(|id| reads[id.index()] > 0) {
        if let Node::Sum(terms) = arena.node(id) {
            for term in terms.iter().filter(|term| is_sum(term)) {
                is_inner[term.node.index()] = reads[term.node.index()] == 1;
            }
        }
    }
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let Node::Sum(terms) = arena.node(id) else {
            return None;
        };
        if is_inner[id.index()] {
            return Some(Value::ZERO);
        }
        let mut merged = Vec::with_capacity(terms.len());
        let mut shared = Vec::new();
        let mut open: Vec<Value> = terms.iter().rev().copied().collect();
        while let Some(term) = open.pop() {
            if is_inner[term.node.index()]
                && let Node::Sum(inner) = arena.node(term.node)
            {
                open.extend(inner.iter().rev().map(|inner| inner.scaled(term.factor)));
                continue;
            }
            let value = term.image(images);
            match copy.node(value.node) {
                Node::Sum(inner) if reads[term.node.index()] == 1 => {
                    merged.extend(inner.iter().map(|inner| inner.scaled(value.factor)));
                }
                Node::Sum(_) => shared.push(value),
                _ => merged.push(value),
            }
        }
        Some(sum(copy, &merged, &shared))
    })
}

/// The sum of some values and of some sums. Those sums are merged that do not make it costlier.
pub(super) fn sum(arena: &mut Arena, plain: &[Value], shared: &[Value]) -> Value {
    let mut terms = collected(plain.iter().chain(shared).copied());
    for sum in shared {
        let Some(value) = terms.iter().find(|term| term.node == sum.node).copied() else {
            continue;
        };
        let Node::Sum(inner) = arena.node(value.node) else {
            continue;
        };
        let inner = inner.iter().map(|term| term.scaled(value.factor));
        let others = terms.iter().filter(|term| term.node != value.node);
        let merged = collected(others.copied().chain(inner));
        if merged.len() <= terms.len() && price(&merged) <= price(&terms) {
            terms = merged;
        }
    }
    arena.sum(terms)
}

/// The terms with equal nodes collected.
pub(super) fn collected(terms: impl IntoIterator<Item = Value>) -> Vec<Value> {
    let mut sorted: Vec<Value> = terms.into_iter().collect();
    sorted.order_by_key(|term| term.node);
    sorted.dedup_by(|next, kept| {
        let same = next.node == kept.node;
        if same {
            kept.factor = kept.factor + next.factor;
        }
        same
    });
    sorted.retain(|term| !term.is_zero());
    sorted
}

/// What it costs to add some terms up, beyond the terms themselves.
pub(super) fn price(terms: &[Value]) -> usize {
    let scaled = terms
        .iter()
        .filter(|term| term.node != Arena::ONE && term.factor.abs() != Ratio::ONE);
    scaled.count() + terms.len().saturating_sub(1)
}
