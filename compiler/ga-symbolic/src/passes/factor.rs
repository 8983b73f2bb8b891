//! Common factors of sums.
//!
//! `a b + a c` becomes `a (b + c)`, and `k a + k b` becomes `k (a + b)` for a constant k: one
//! multiplication less for each term but the first, and one addition less too for each where the
//! sum in the brackets is already computed. In each sum the factor is taken out first that saves
//! most, and again until none saves.
//!
//! Where some inputs are uniform, what saves most of the rest comes first: of `u v + w v` with
//! uniform u and w the sum `u + w` moves to the uniform part.
//!
//! Products of products that nothing else reads count with all of their factors:
//! `a (b c) + d (b e)` becomes `b (a c + d e)`.
//!
//! It is right by the distributive law.

use std::collections::BTreeMap;

use rustc_hash::FxHashSet;

use super::flatten;
use super::rewrite::{Graph, collect_factors, reads, rewrite};
use super::uniformity::Uniformity;
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// Takes out common factors; `None` where there are none.
#[must_use]
pub fn factor(arena: &Arena, outputs: &[Value], uniform: &[bool]) -> Option<Graph> {
    with_reads(arena, outputs, uniform, &reads(arena, outputs))
}

/// Takes out common factors of sums and differences of the same products too, out of both:
/// `a b + a c` and `a b − a c` become `a (b + c)` and `a (b − c)`, where other factors may stand in
/// place of a. `None` where there are no such sums.
#[must_use]
pub fn factor_together(arena: &Arena, outputs: &[Value], uniform: &[bool]) -> Option<Graph> {
    let mut reads = reads(arena, outputs);
    let mut known: FxHashSet<Vec<NodeId>> = FxHashSet::default();
    let mut has_changed = false;
    for id in arena.ids() {
        if let Node::Sum(terms) = arena.node(id)
            && reads[id.index()] > 0
        {
            let nodes: Vec<NodeId> = terms.iter().map(|term| term.node).collect();
            if known.contains(&nodes) {
                has_changed = true;
                for node in nodes {
                    reads[node.index()] -= 1;
                }
            } else {
                known.insert(nodes);
            }
        }
    }
    has_changed.then(|| with_reads(arena, outputs, uniform, &reads))?
}

/// Takes out common factors, where products that are read once belong to their readers.
fn with_reads(
    arena: &Arena,
    outputs: &[Value],
    uniform: &[bool],
    reads: &[usize],
) -> Option<Graph> {
    let is_candidate = |id: NodeId| match arena.node(id) {
        Node::Sum(terms) if reads[id.index()] > 0 => {
            has_common_factor(arena, terms, reads) || has_common_constant(terms)
        }
        _ => false,
    };
    if !arena.ids().any(is_candidate) {
        return None;
    }
    let mut uniformity = Uniformity::new(uniform);
    rewrite(arena, outputs, reads, |copy, id, images| {
        let Node::Sum(terms) = arena.node(id) else {
            return None;
        };
        if !is_candidate(id) {
            return None;
        }
        let terms: Vec<Term> = terms
            .iter()
            .map(|&term| Term::new(arena, reads, images, term))
            .collect();
        let terms = with_variables_taken_out(copy, terms, &mut uniformity);
        let terms = with_constants_taken_out(copy, &terms);
        Some(copy.sum(terms))
    })
}

/// A term of a sum, in the copy.
struct Term {
    value: Value,
    /// The factors of a product that nothing else reads, so that it is saved if the term is
    /// removed; empty for other terms.
    factors: Vec<NodeId>,
}

impl Term {
    fn new(arena: &Arena, reads: &[usize], images: &[Value], term: Value) -> Self {
        let value = term.image(images);
        let mut leaves = Vec::new();
        collect_factors(arena, reads, term.node, &mut leaves);
        let product = leaves.iter().map(|leaf| images[leaf.index()]);
        let factors =
            if leaves.len() < 2 || product.clone().any(|leaf| leaf.as_constant().is_some()) {
                Vec::new()
            } else {
                product.map(|leaf| leaf.node).collect()
            };
        Self { value, factors }
    }
}

fn has_common_factor(arena: &Arena, terms: &[Value], reads: &[usize]) -> bool {
    let mut seen: Vec<NodeId> = Vec::with_capacity(2 * terms.len());
    let mut factors = Vec::new();
    for term in terms {
        factors.clear();
        collect_factors(arena, reads, term.node, &mut factors);
        if factors.len() > 1 {
            if factors.iter().any(|factor| seen.contains(factor)) {
                return true;
            }
            seen.extend(&factors);
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
    terms: Vec<Term>,
    uniformity: &mut Uniformity<'_>,
) -> Vec<Value> {
    let mut terms = Products::new(terms);
    while let Some(common) = terms.best(copy, uniformity) {
        let rest: Vec<Term> = terms
            .take(common)
            .into_iter()
            .map(|(factor, factors)| Term {
                value: product(copy, &factors, uniformity).scaled(factor),
                factors: if factors.len() > 1 {
                    factors
                } else {
                    Vec::new()
                },
            })
            .collect();
        let rest = with_variables_taken_out(copy, rest, uniformity);
        let (shared, plain): (Vec<Value>, Vec<Value>) = rest
            .into_iter()
            .partition(|value| matches!(copy.node(value.node), Node::Sum(_)));
        let bracket = flatten::sum(copy, &plain, &shared);
        let factor = Value::of(common);
        let whole = copy.product(factor, bracket);
        terms.push(Term {
            value: whole,
            factors: match copy.node(whole.node) {
                Node::Product(a, b) => vec![*a, *b],
                _ => Vec::new(),
            },
        });
    }
    terms.values.into_iter().flatten().collect()
}

/// The product of some nodes, what is uniform first.
fn product(copy: &mut Arena, factors: &[NodeId], uniformity: &mut Uniformity<'_>) -> Value {
    let (first, second): (Vec<NodeId>, Vec<NodeId>) = factors
        .iter()
        .partition(|id| uniformity.is_uniform(copy, **id));
    let mut whole = Value::ONE;
    for node in first.into_iter().chain(second) {
        let factor = Value::of(node);
        whole = copy.product(whole, factor);
    }
    whole
}

/// The terms of a sum, by the factors of those that are products.
struct Products {
    /// The terms; none where one was taken.
    values: Vec<Option<Value>>,
    /// For each factor the products that have it.
    groups: BTreeMap<NodeId, Group>,
}

#[derive(Default)]
struct Group {
    members: Vec<Member>,
    /// Whether the sum of the remaining factors is already computed; unknown until examined.
    is_known: Option<bool>,
}

/// A product without one of its factors.
struct Member {
    place: usize,
    factor: Ratio,
    rest: Vec<NodeId>,
}

impl Products {
    fn new(terms: Vec<Term>) -> Self {
        let mut result = Self {
            values: Vec::with_capacity(terms.len()),
            groups: BTreeMap::new(),
        };
        for term in terms {
            result.push(term);
        }
        result
    }

    fn push(&mut self, term: Term) {
        let place = self.values.len();
        self.values.push(Some(term.value));
        for (number, common) in term.factors.iter().enumerate() {
            if term.factors[..number].contains(common) {
                continue;
            }
            let mut rest = term.factors.clone();
            rest.remove(number);
            let group = self.groups.entry(*common).or_default();
            group.is_known = None;
            group.members.push(Member {
                place,
                factor: term.value.factor,
                rest,
            });
        }
    }

    /// The factor that saves most, first in what varies, then in all; of equals, the earliest node.
    fn best(&mut self, arena: &Arena, uniformity: &mut Uniformity<'_>) -> Option<NodeId> {
        let mut best = None;
        for (common, group) in &mut self.groups {
            if group.members.len() < 2 {
                continue;
            }
            let fewer = group.members.len() - 1;
            let members = &group.members;
            let is_known = *group.is_known.get_or_insert_with(|| {
                let single = |member: &Member| match *member.rest {
                    [node] => Some(Value {
                        factor: member.factor,
                        node,
                    }),
                    _ => None,
                };
                let terms: Option<Vec<Value>> = members.iter().map(single).collect();
                terms.is_some_and(|terms| arena.known_sum(terms).is_some())
            });
            // Unlike the products, a sum in brackets is uniform where all of its terms are.
            let is_moved = !uniformity.is_uniform(arena, *common)
                && members.iter().all(|member| {
                    let mut rest = member.rest.iter();
                    rest.all(|node| uniformity.is_uniform(arena, *node))
                });
            let saved = if is_known { 2 * fewer } else { fewer };
            // A product with another uniform factor is multiplied by both at once.
            let is_first = uniformity.is_uniform(arena, *common);
            let has_other = |member: &&Member| {
                let mut rest = member.rest.iter();
                is_first && rest.any(|node| uniformity.is_uniform(arena, *node))
            };
            let others = members.iter().filter(has_other).count();
            if others > fewer {
                continue;
            }
            let gain = (
                if is_moved {
                    saved + fewer
                } else {
                    saved - others
                },
                saved,
            );
            if best.is_none_or(|(most, _)| gain > most) {
                best = Some((gain, *common));
            }
        }
        best.map(|(_, common)| common)
    }

    /// Removes the products with a factor; returns their other factors.
    fn take(&mut self, common: NodeId) -> Vec<(Ratio, Vec<NodeId>)> {
        let taken = self.groups.remove(&common).unwrap_or_default().members;
        for member in &taken {
            self.values[member.place] = None;
            for node in &member.rest {
                if let Some(group) = self.groups.get_mut(node) {
                    group.members.retain(|other| other.place != member.place);
                    group.is_known = None;
                }
            }
        }
        let parts = taken.into_iter();
        parts.map(|member| (member.factor, member.rest)).collect()
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
