//! The passes together.

use rustc_hash::FxHashSet;

use super::rewrite::{Graph, reads, with_first};
use super::uniformity::Uniformity;
use super::{
    cost, factor, factor_together, flatten, fraction, hoist, proportional, reduce, scale, share,
    substitute,
};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, Value};

/// Rewrites a graph to an equal one that costs no more.
///
/// `uniform` marks inputs that are the same for all elements of a batch; those beyond its end vary.
/// What depends on uniform inputs only counts after the rest. `relations` are values of the arena
/// that are known to be zero.
#[must_use]
pub fn optimise(arena: Arena, outputs: Vec<Value>, uniform: &[bool], relations: &[Value]) -> Graph {
    let mut starts = Vec::new();
    starts.extend(reduced(&arena, &outputs, relations));
    starts.push(flatten(&arena, &outputs).unwrap_or_else(|| (arena.clone(), outputs.clone())));
    for start in &mut starts {
        if let Some(graph) = proportional(&start.0, &start.1) {
            *start = graph;
        }
    }
    let mut best = Candidate::new((arena, outputs), uniform);
    let mut seen = FxHashSet::default();
    for start in &starts {
        for graph in restructured(start, uniform) {
            if !seen.insert(graph.0.fingerprint(&graph.1)) {
                continue;
            }
            let graph = apply(graph, fraction);
            let graph = apply(graph, substitute);
            let graph = apply(graph, |arena, outputs| hoist(arena, outputs, uniform));
            // What follows saves multiples by constants at most.
            if without_multiples(&graph, uniform) > best.price.0 {
                continue;
            }
            let graph = apply(graph, |arena, outputs| scale(arena, outputs, uniform));
            // Factors that have moved to the terms of sums let these merge with others.
            let graph = apply(graph, |arena, outputs| hoist(arena, outputs, uniform));
            let next = Candidate::new(graph, uniform);
            if next.price < best.price {
                best = next;
            }
        }
    }
    best.graph
}

/// The varying operations of a graph but for multiplications by constants, or fewer.
fn without_multiples((arena, outputs): &Graph, uniform: &[bool]) -> usize {
    let reads = reads(arena, outputs);
    let is_multiple =
        |value: &&Value| value.as_constant().is_none() && value.factor.abs() != Ratio::ONE;
    let live = arena.ids().filter(|id| reads[id.index()] > 0);
    let multiples = live.map(|id| match arena.node(id) {
        Node::Sum(values) | Node::Function(_, values) => values.iter().filter(is_multiple).count(),
        Node::One | Node::Input(_) | Node::Product(..) | Node::Quotient(..) => 0,
    });
    let multiples = multiples.sum::<usize>() + outputs.iter().filter(is_multiple).count();
    let varying = match uniform.contains(&true) {
        true => varying_cost(arena, outputs, uniform),
        false => cost(arena, outputs).total(),
    };
    varying.saturating_sub(multiples)
}

/// The graph flattened and reduced, if the relations make it cheaper.
fn reduced(arena: &Arena, outputs: &[Value], relations: &[Value]) -> Option<Graph> {
    if relations.is_empty() {
        return None;
    }
    // The relations come first, so that every sum can use them, and are flattened together with
    // the graph.
    let ((arena, outputs), relations) = with_first(arena, outputs, relations)?;
    let all: Vec<Value> = outputs.iter().chain(&relations).copied().collect();
    let (arena, mut all) = flatten(&arena, &all).unwrap_or((arena, all));
    let relations = all.split_off(outputs.len());
    let reduced = reduce(&arena, &all, &relations)?;
    Some(apply(reduced, flatten))
}

/// The graph factored and shared, in both orders where they may differ.
fn restructured(start: &Graph, uniform: &[bool]) -> Vec<Graph> {
    let take_out = |arena: &Arena, outputs: &[Value]| factor(arena, outputs, uniform);
    let factored = take_out(&start.0, &start.1);
    let shared = share(&start.0, &start.1);
    let is_same = factored.is_none() && shared.is_none();
    let mut results = Vec::new();
    results.extend(factored.map(|graph| apply(graph, share)));
    results.extend(shared.map(|graph| apply(graph, take_out)));
    if is_same {
        results.push(start.clone());
    }
    let together = factor_together(&start.0, &start.1, uniform);
    let price = |graph: &Graph| cost(&graph.0, &graph.1).total();
    let least = results.iter().map(price).min();
    results.extend(
        together
            .map(|graph| apply(graph, share))
            .filter(|graph| least.is_none_or(|least| price(graph) < least)),
    );
    results
}

fn apply(graph: Graph, pass: impl Fn(&Arena, &[Value]) -> Option<Graph>) -> Graph {
    pass(&graph.0, &graph.1).unwrap_or(graph)
}

/// A graph with its cost: first of what varies, then of the whole, then negations.
struct Candidate {
    graph: Graph,
    price: (usize, usize, usize),
}

impl Candidate {
    fn new(graph: Graph, uniform: &[bool]) -> Self {
        let (arena, outputs) = &graph;
        let whole = cost(arena, outputs);
        let varying = if uniform.contains(&true) {
            varying_cost(arena, outputs, uniform)
        } else {
            whole.total()
        };
        let price = (varying, whole.total(), whole.negations);
        Self { graph, price }
    }
}

/// The cost without the nodes that are uniform.
pub(crate) fn varying_cost(arena: &Arena, outputs: &[Value], uniform: &[bool]) -> usize {
    let reads = reads(arena, outputs);
    let mut uniformity = Uniformity::new(uniform);
    let uniform_nodes: Vec<Value> = arena
        .ids()
        .filter(|&id| reads[id.index()] > 0 && uniformity.is_uniform(arena, id))
        .map(Value::of)
        .collect();
    cost(arena, outputs).total() - cost(arena, &uniform_nodes).total()
}
