//! Common factors of sums.
//!
//! `a b + a c` becomes `a (b + c)`, and `k a + k b` becomes `k (a + b)` for a constant k: one multiplication less for each
//! term but the first, and one addition less too for each where the sum in the brackets is at hand already. In each sum
//! the factor is taken out first that saves most, and again until none saves.
//!
//! Where some inputs are uniform, what saves most of the rest comes first: of `u v + w v` with uniform u and w the
//! sum `u + w` moves to the uniform part.
//!
//! It is right by the distributive law.

use std::collections::{BTreeMap, BTreeSet};

use super::flatten;
use super::rate::Rates;
use super::rewrite::{Graph, image, reads, rewrite};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// Takes out common factors; `None` where there are none.
#[must_use]
pub fn factor(arena: &Arena, outputs: &[Value], uniform: &[bool]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let is_candidate = |id: NodeId| match arena.node(id) {
        Node::Sum(terms) if reads[id.index()] > 0 => {
            has_common_factor(arena, terms, &reads) || has_common_constant(terms)
        }
        _ => false,
    };
    if !arena.ids().any(is_candidate) {
        return None;
    }
    let mut search = Search {
        rates: Rates::new(uniform),
        tried: BTreeSet::new(),
    };
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let Node::Sum(terms) = arena.node(id) else {
            return None;
        };
        if !is_candidate(id) {
            return None;
        }
        let terms: Vec<Term> = terms
            .iter()
            .map(|&term| Term {
                value: image(images, term),
                is_only_here: reads[term.node.index()] == 1,
            })
            .collect();
        let terms = with_variables_taken_out(copy, terms, &mut search);
        let terms = with_constants_taken_out(copy, &terms);
        Some(copy.sum(terms))
    })
}

/// What is known while the sums of a graph are gone through.
struct Search<'a> {
    rates: Rates<'a>,
    /// Sums that were built to look at them, and are not at hand therefore.
    tried: BTreeSet<NodeId>,
}

/// A term of a sum.
#[derive(Clone, Copy)]
struct Term {
    value: Value,
    /// Whether no other operation reads the term's node, so that it is saved if the term goes.
    is_only_here: bool,
}

fn has_common_factor(arena: &Arena, terms: &[Value], reads: &[usize]) -> bool {
    let mut seen: Vec<NodeId> = Vec::with_capacity(2 * terms.len());
    for term in terms {
        if let Node::Product(a, b) = arena.node(term.node) {
            if seen.contains(a) || seen.contains(b) {
                return true;
            }
            if reads[term.node.index()] == 1 {
                seen.extend([*a, *b]);
            }
        }
    }
    false
}

fn has_common_constant(terms: &[Value]) -> bool {
    let scaled = |term: &&Value| term.factor.abs() != Ratio::ONE && term.node != Arena::ONE;
    let mut found: Vec<Ratio> = Vec::new();
    terms.iter().filter(scaled).any(|term| {
        let size = term.factor.abs();
        let again = found.contains(&size);
        found.push(size);
        again
    })
}

fn with_variables_taken_out(
    copy: &mut Arena,
    mut terms: Vec<Term>,
    search: &mut Search<'_>,
) -> Vec<Value> {
    while let Some(common) = best_factor(copy, &terms, search) {
        let mut inside = Vec::new();
        let mut outside = Vec::with_capacity(terms.len());
        for term in terms {
            match cofactor(copy, term.value.node, common) {
                Some(node) if term.is_only_here => inside.push(Value {
                    factor: term.value.factor,
                    node,
                }),
                _ => outside.push(term),
            }
        }
        let (shared, plain): (Vec<Value>, Vec<Value>) = inside
            .into_iter()
            .partition(|value| matches!(copy.node(value.node), Node::Sum(_)));
        let bracket = flatten::sum(copy, &plain, &shared);
        search.tried.remove(&bracket.node);
        let factor = Value {
            factor: Ratio::ONE,
            node: common,
        };
        let value = copy.product(factor, bracket);
        outside.push(Term {
            value,
            is_only_here: true,
        });
        terms = outside;
    }
    terms.into_iter().map(|term| term.value).collect()
}

/// The other factor of a product, if one is as given.
fn cofactor(arena: &Arena, node: NodeId, factor: NodeId) -> Option<NodeId> {
    match arena.node(node) {
        Node::Product(a, b) if *a == factor => Some(*b),
        Node::Product(a, b) if *b == factor => Some(*a),
        _ => None,
    }
}

/// The factor that saves most: first of what varies, then of all; of equals the earliest node.
fn best_factor(copy: &mut Arena, terms: &[Term], search: &mut Search<'_>) -> Option<NodeId> {
    let mut groups: BTreeMap<NodeId, Vec<Value>> = BTreeMap::new();
    for term in terms.iter().filter(|term| term.is_only_here) {
        if let &Node::Product(a, b) = copy.node(term.value.node) {
            let cofactor = |node| Value {
                factor: term.value.factor,
                node,
            };
            groups.entry(a).or_default().push(cofactor(b));
            if a != b {
                groups.entry(b).or_default().push(cofactor(a));
            }
        }
    }
    let mut best = None;
    for (common, cofactors) in groups {
        if cofactors.len() < 2 {
            continue;
        }
        let mut saved = cofactors.len() - 1;
        let before = copy.len();
        let bracket = copy.sum(cofactors.iter().copied());
        if copy.len() > before {
            search.tried.insert(bracket.node);
        }
        if !search.tried.contains(&bracket.node) {
            saved += cofactors.len() - 1;
        }
        // Unlike the products, a sum in brackets is uniform where all of its terms are.
        let moved = if search.rates.is_uniform(copy, common)
            || !search.rates.is_uniform(copy, bracket.node)
        {
            0
        } else {
            cofactors.len() - 1
        };
        let gain = (saved + moved, saved);
        if best.is_none_or(|(most, _)| gain > most) {
            best = Some((gain, common));
        }
    }
    best.map(|(_, common)| common)
}

fn with_constants_taken_out(copy: &mut Arena, terms: &[Value]) -> Vec<Value> {
    if !has_common_constant(terms) {
        return terms.to_vec();
    }
    let mut groups: BTreeMap<Ratio, Vec<Value>> = BTreeMap::new();
    for &term in terms {
        let size = if term.node == Arena::ONE {
            Ratio::ONE
        } else {
            term.factor.abs()
        };
        groups.entry(size).or_default().push(term);
    }
    let mut result = Vec::new();
    for (size, group) in groups {
        if size == Ratio::ONE || group.len() == 1 {
            result.extend(group);
        } else {
            result.push(copy.sum(group));
        }
    }
    result
}
