//! Sums in terms of other sums.
//!
//! Where two sums have terms in common, one may be cheaper as a multiple of the other and a
//! remainder: if `m = x + d` is computed anyway, `x + 2 d` is `m + d`, which saves the doubling.
//!
//! It is right because the multiple of the one sum is taken from the other's terms and added as a
//! whole. A sum is only expressed by sums that come before it, so that none comes to depend on
//! itself.

use std::collections::BTreeMap;

use super::flatten::{collected, price};
use super::rewrite::{Graph, reads, rewrite};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// How many of the sums that read a node are compared: a node such as the number 1 is in too many.
const MOST: usize = 16;

/// Expresses sums by others; `None` where none gets cheaper.
#[must_use]
pub fn substitute(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let mut readers: Vec<Vec<NodeId>> = vec![Vec::new(); arena.len()];
    let mut changed: BTreeMap<NodeId, Vec<Value>> = BTreeMap::new();
    for id in arena.ids() {
        let Node::Sum(terms) = arena.node(id) else {
            continue;
        };
        if reads[id.index()] == 0 {
            continue;
        }
        if price(terms) > 1
            && let Some(cheaper) = expressed(arena, terms, &readers)
        {
            changed.insert(id, cheaper);
        }
        for term in terms {
            if reads[term.node.index()] > 1 {
                readers[term.node.index()].push(id);
            }
        }
    }
    if changed.is_empty() {
        return None;
    }
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let terms = changed.get(&id)?;
        Some(copy.sum(terms.iter().map(|term| term.image(images))))
    })
}

/// The cheapest way to write a sum by one that shares at least two of its nodes, if it is cheaper
/// than the sum.
fn expressed(arena: &Arena, terms: &[Value], readers: &[Vec<NodeId>]) -> Option<Vec<Value>> {
    let mut shared: BTreeMap<NodeId, Vec<Ratio>> = BTreeMap::new();
    for term in terms {
        let sums = &readers[term.node.index()];
        for sum in sums.iter().take(MOST) {
            if let Node::Sum(parts) = arena.node(*sum)
                && let Some(part) = parts.iter().find(|part| part.node == term.node)
            {
                shared
                    .entry(*sum)
                    .or_default()
                    .push(term.factor / part.factor);
            }
        }
    }
    let mut best: Option<(usize, Vec<Value>)> = None;
    for (sum, multiples) in shared {
        let Node::Sum(parts) = arena.node(sum) else {
            continue;
        };
        if multiples.len() < 2 {
            continue;
        }
        for factor in multiples {
            let taken = parts.iter().map(|part| part.scaled(-factor));
            let whole = Value { factor, node: sum };
            let next = collected(terms.iter().copied().chain(taken).chain([whole]));
            let cost = price(&next);
            if cost < best.as_ref().map_or(price(terms), |(least, _)| *least) {
                best = Some((cost, next));
            }
        }
    }
    best.map(|(_, terms)| terms)
}
