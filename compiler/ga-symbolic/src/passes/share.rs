//! Common parts of sums.
//!
//! Where two terms stand together in several sums, up to a common factor or sign, their sum becomes
//! a node of its own, which saves an addition in each but one of them. The pair that saves most
//! goes first, and the new node takes part in further pairs, so that longer common parts are found
//! step by step.
//!
//! It is right because addition is associative and commutative.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::rewrite::{Graph, reads, rewrite};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// The longest sum that is examined: the number of pairs grows with its square.
const LONGEST: usize = 64;

/// Shares common parts; `None` where there are none.
#[must_use]
pub fn share(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let mut search = Search {
        sums: vec![Vec::new(); arena.len()],
        pairs: BTreeMap::new(),
        queue: BinaryHeap::new(),
        found: Vec::new(),
        nodes: arena.len(),
    };
    for id in arena.ids() {
        if let Node::Sum(terms) = arena.node(id)
            && reads[id.index()] > 0
            && (2..=LONGEST).contains(&terms.len())
        {
            search.add(id, terms, &reads);
        }
    }
    while search.take_out_best() {}
    if search.found.is_empty() {
        return None;
    }
    let nodes: Vec<NodeId> = arena.ids().collect();
    let mut built: Vec<Option<Value>> = vec![None; search.found.len()];
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let terms = &search.sums[id.index()];
        if terms.is_empty() {
            return None;
        }
        let values: Vec<Value> = terms
            .iter()
            .map(|term| search.value(copy, &nodes, images, &mut built, *term))
            .collect();
        Some(copy.sum(values))
    })
}

/// A term of a sum: a place, which is that of a node or, beyond all nodes, of a common part; and
/// its factor.
#[derive(Clone, Copy)]
struct Term {
    place: usize,
    factor: Ratio,
    /// Whether the place occurs elsewhere, so that it can be part of what is common.
    can_pair: bool,
}

/// Two places with coprime whole factors, the first of which is positive.
type Pair = [(usize, Ratio); 2];

struct Search {
    /// The terms of each sum, by the index of its node.
    sums: Vec<Vec<Term>>,
    /// The pairs, with the sums in which they stand and what factors out of them there.
    pairs: BTreeMap<Pair, Vec<(usize, Ratio)>>,
    /// Pairs with the operations that they saved when last examined.
    queue: BinaryHeap<(usize, Reverse<Pair>)>,
    found: Vec<Pair>,
    nodes: usize,
}

impl Search {
    fn add(&mut self, id: NodeId, terms: &[Value], reads: &[usize]) {
        let terms: Vec<Term> = terms
            .iter()
            .map(|term| Term {
                place: term.node.index(),
                factor: term.factor,
                can_pair: reads[term.node.index()] > 1,
            })
            .collect();
        for (number, &first) in terms.iter().enumerate() {
            for &second in &terms[number + 1..] {
                self.enter(id.index(), first, second);
            }
        }
        self.sums[id.index()] = terms;
    }

    fn enter(&mut self, sum: usize, first: Term, second: Term) {
        if first.can_pair && second.can_pair {
            let (pair, factor) = paired(first, second);
            let places = self.pairs.entry(pair).or_default();
            places.push((sum, factor));
            if places.len() > 1 {
                let saved = self.saved(&pair);
                self.queue.push((saved, Reverse(pair)));
            }
        }
    }

    fn leave(&mut self, sum: usize, first: Term, second: Term) {
        if first.can_pair && second.can_pair {
            let (pair, _) = paired(first, second);
            if let Some(places) = self.pairs.get_mut(&pair) {
                places.retain(|(other, _)| *other != sum);
            }
        }
    }

    /// How many operations it saves to take out a pair.
    fn saved(&self, pair: &Pair) -> usize {
        let places = self.pairs.get(pair).map_or(&[][..], Vec::as_slice);
        if places.len() < 2 {
            return 0;
        }
        let [(_, p), (_, q)] = *pair;
        let before = |f: Ratio| 1 + cost(p * f) + cost(q * f);
        let before: usize = places.iter().map(|(_, f)| before(*f)).sum();
        let after: usize = places.iter().map(|(_, f)| cost(*f)).sum();
        before.saturating_sub(after + 1 + cost(p) + cost(q))
    }

    /// The pair that saves most, of equals the first. What a pair saves falls while others are
    /// taken out, and where it rises the pair is queued again, so an entry that is still right is
    /// the best.
    fn best(&mut self) -> Option<Pair> {
        while let Some((promised, Reverse(pair))) = self.queue.pop() {
            let saved = self.saved(&pair);
            if saved > 0 && saved == promised {
                return Some(pair);
            }
            if saved > 0 {
                self.queue.push((saved, Reverse(pair)));
            }
        }
        None
    }

    /// Takes out the best pair, if there is one.
    fn take_out_best(&mut self) -> bool {
        let Some(pair) = self.best() else {
            return false;
        };
        let place = self.nodes + self.found.len();
        self.found.push(pair);
        for (sum, factor) in self.pairs.remove(&pair).unwrap_or_default() {
            let (gone, mut kept): (Vec<Term>, Vec<Term>) = self.sums[sum]
                .iter()
                .partition(|term| pair.iter().any(|(place, _)| *place == term.place));
            let new = Term {
                place,
                factor,
                can_pair: true,
            };
            for &other in &kept {
                for &term in &gone {
                    self.leave(sum, term, other);
                }
                self.enter(sum, other, new);
            }
            kept.push(new);
            self.sums[sum] = kept;
        }
        true
    }

    /// Builds what a term stands for.
    fn value(
        &self,
        copy: &mut Arena,
        nodes: &[NodeId],
        images: &[Value],
        built: &mut [Option<Value>],
        term: Term,
    ) -> Value {
        let Some(number) = term.place.checked_sub(self.nodes) else {
            let value = Value {
                factor: term.factor,
                node: nodes[term.place],
            };
            return value.image(images);
        };
        let whole = built[number].unwrap_or_else(|| {
            let parts = self.found[number].map(|(place, factor)| {
                let part = Term {
                    place,
                    factor,
                    can_pair: true,
                };
                self.value(copy, nodes, images, built, part)
            });
            let whole = copy.sum(parts);
            built[number] = Some(whole);
            whole
        });
        whole.scaled(term.factor)
    }
}

/// The pair of two terms and what factors out of it.
fn paired(first: Term, second: Term) -> (Pair, Ratio) {
    let (first, second) = if first.place < second.place {
        (first, second)
    } else {
        (second, first)
    };
    let ratio = second.factor / first.factor;
    let whole = Ratio::integer(ratio.denominator());
    let pair = [(first.place, whole), (second.place, ratio * whole)];
    (pair, first.factor / whole)
}

fn cost(factor: Ratio) -> usize {
    usize::from(factor.abs() != Ratio::ONE)
}
