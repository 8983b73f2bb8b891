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

use std::collections::BTreeMap;

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
    let mut rates = Rates::new(uniform);
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
        let terms = with_variables_taken_out(copy, &terms, &mut rates);
        let terms = with_constants_taken_out(copy, &terms);
        Some(copy.sum(terms))
    })
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

fn with_variables_taken_out(copy: &mut Arena, terms: &[Term], rates: &mut Rates<'_>) -> Vec<Value> {
    let mut terms = Products::new(copy, terms);
    while let Some(common) = terms.best(copy, rates) {
        let cofactors: Vec<Value> = terms.take(common);
        let (shared, plain): (Vec<Value>, Vec<Value>) = cofactors
            .into_iter()
            .partition(|value| matches!(copy.node(value.node), Node::Sum(_)));
        let bracket = flatten::sum(copy, &plain, &shared);
        let factor = Value {
            factor: Ratio::ONE,
            node: common,
        };
        let product = copy.product(factor, bracket);
        terms.push(copy, product);
    }
    terms.values.into_iter().flatten().collect()
}

/// The terms of a sum, by the factors of those that are products.
struct Products {
    /// The terms; none where one was taken.
    values: Vec<Option<Value>>,
    /// For each factor the places of the products that have it, with what they have besides.
    groups: BTreeMap<NodeId, Group>,
}

#[derive(Default)]
struct Group {
    members: Vec<(usize, Value)>,
    /// Whether the sum of what the products have besides is at hand; unknown until looked for.
    is_at_hand: Option<bool>,
}

impl Products {
    fn new(arena: &Arena, terms: &[Term]) -> Self {
        let mut result = Self {
            values: Vec::with_capacity(terms.len()),
            groups: BTreeMap::new(),
        };
        for term in terms {
            if term.is_only_here {
                result.push(arena, term.value);
            } else {
                result.values.push(Some(term.value));
            }
        }
        result
    }

    fn push(&mut self, arena: &Arena, value: Value) {
        let place = self.values.len();
        self.values.push(Some(value));
        if let &Node::Product(a, b) = arena.node(value.node) {
            let both = [(a, b), (b, a)];
            for (common, node) in &both[..if a == b { 1 } else { 2 }] {
                let group = self.groups.entry(*common).or_default();
                let cofactor = Value {
                    factor: value.factor,
                    node: *node,
                };
                group.members.push((place, cofactor));
                group.is_at_hand = None;
            }
        }
    }

    /// The factor that saves most: first of what varies, then of all; of equals the earliest node.
    fn best(&mut self, arena: &Arena, rates: &mut Rates<'_>) -> Option<NodeId> {
        let mut best = None;
        for (common, group) in &mut self.groups {
            if group.members.len() < 2 {
                continue;
            }
            let fewer = group.members.len() - 1;
            let members = group.members.iter();
            let is_at_hand = *group.is_at_hand.get_or_insert_with(|| {
                let sum = arena.known_sum(members.clone().map(|(_, cofactor)| *cofactor));
                sum.is_some()
            });
            // Unlike the products, a sum in brackets is uniform where all of its terms are.
            let is_moved = !rates.is_uniform(arena, *common)
                && members
                    .clone()
                    .all(|(_, c)| rates.is_uniform(arena, c.node));
            let saved = if is_at_hand { 2 * fewer } else { fewer };
            let gain = (if is_moved { saved + fewer } else { saved }, saved);
            if best.is_none_or(|(most, _)| gain > most) {
                best = Some((gain, *common));
            }
        }
        best.map(|(_, common)| common)
    }

    /// Takes away the products with a factor; gives what they have besides.
    fn take(&mut self, common: NodeId) -> Vec<Value> {
        let taken = self.groups.remove(&common).unwrap_or_default().members;
        for (place, cofactor) in &taken {
            self.values[*place] = None;
            if let Some(group) = self.groups.get_mut(&cofactor.node) {
                group.members.retain(|(other, _)| other != place);
                group.is_at_hand = None;
            }
        }
        taken.into_iter().map(|(_, cofactor)| cofactor).collect()
    }
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
