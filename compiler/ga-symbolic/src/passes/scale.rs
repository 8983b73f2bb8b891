//! Where constant factors are multiplied in.
//!
//! A factor may stand at a sum's terms, at an operand of a product or at the result:
//! `2 (x y − w z)` is `(2 y) x − (2 z) w`, and where many products read y and z, the doubled values
//! are computed once for all of them. This pass gives every node a *scale*, the multiple of it
//! that is computed, and counts for each node the *multiples* that are read. Each multiple other
//! than the scale costs a multiplication, so the number of those is brought down:
//!
//! 1. a factor of a sum moves to its terms, and a factor of a product moves to an operand that is a
//!    sum;
//! 2. while it saves something, the multiple of a node is added that serves most of the products
//!    which read the node;
//! 3. a sum takes another scale where that saves something.
//!
//! An alternative leaves out the first two steps, and where inputs are uniform, another one moves
//! factors of products to uniform operands only. The cheapest result is taken. It is right
//! because the scale of a node is divided out again where the node is read.

use crate::order::Order as _;
use std::collections::BTreeMap;

use super::rewrite::{Graph, reads, rewrite};
use super::uniformity::Uniformity;
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// Places constant factors; `None` where there are none or nothing is saved.
#[must_use]
pub fn scale(arena: &Arena, outputs: &[Value], uniform: &[bool]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let is_scaled = |term: &Value| term.as_constant().is_none() && term.factor.abs() != Ratio::ONE;
    let has_work = outputs.iter().any(is_scaled)
        || arena.ids().any(|id| {
            reads[id.index()] > 0
                && matches!(arena.node(id), Node::Sum(terms) if terms.iter().any(is_scaled))
        });
    if !has_work {
        return None;
    }
    let start = Scales::new(arena, outputs, &reads, uniform);
    let mut plain = start.clone();
    plain.settle_sums();
    let has_uniform = uniform.contains(&true);
    let mut best = plain;
    for is_staged in [false, true].into_iter().take(1 + usize::from(has_uniform)) {
        let mut pushed = start.clone();
        pushed.push_down(is_staged);
        pushed.add_multiples();
        pushed.settle_sums();
        pushed.add_multiples();
        if pushed.total < best.total {
            best = pushed;
        }
    }
    // A uniform multiple is worth a node even if it is read once.
    let is_better = best.total < start.total || has_uniform;
    is_better.then(|| best.build(outputs, &reads))?
}

/// Scales of the nodes and the multiples that are read of them.
#[derive(Clone)]
struct Scales<'a> {
    arena: &'a Arena,
    live: Vec<NodeId>,
    /// The multiple of each node that is computed.
    scales: Vec<Ratio>,
    /// The multiples of the operands of each product.
    sides: Vec<[Ratio; 2]>,
    /// The multiples that are read of each node, and how often.
    wanted: Vec<Vec<(Ratio, usize)>>,
    /// The products that read each node.
    products: Vec<Vec<NodeId>>,
    /// What a multiple of each node costs.
    weights: Vec<usize>,
    /// What all multiples cost.
    total: usize,
}

/// Of how many multiples the most useful is looked for.
const MOST_CANDIDATES: usize = 64;

/// The cost of a multiplication for every element, where one in the prologue costs 1.
const VARYING: usize = 1 << 20;

impl<'a> Scales<'a> {
    fn new(arena: &'a Arena, outputs: &[Value], reads: &[usize], uniform: &[bool]) -> Self {
        let mut uniformity = Uniformity::new(uniform);
        let mut weight = |id| match uniformity.is_uniform(arena, id) {
            true => 1,
            false => VARYING,
        };
        let mut scales = Self {
            arena,
            live: arena.ids().filter(|id| reads[id.index()] > 0).collect(),
            scales: vec![Ratio::ONE; arena.len()],
            sides: vec![[Ratio::ONE; 2]; arena.len()],
            wanted: vec![Vec::new(); arena.len()],
            products: vec![Vec::new(); arena.len()],
            weights: arena.ids().map(&mut weight).collect(),
            total: 0,
        };
        for id in scales.live.clone() {
            if let Node::Product(a, b) = arena.node(id) {
                scales.products[a.index()].push(id);
                if a != b {
                    scales.products[b.index()].push(id);
                }
            }
            scales.want_operands(id, true);
        }
        for output in outputs {
            if output.as_constant().is_none() {
                scales.want(output.node, output.factor.abs(), true);
            }
        }
        scales
    }

    /// What the multiples of a node cost.
    fn cost(&self, id: NodeId) -> usize {
        let scale = self.scales[id.index()];
        let others = self.wanted[id.index()]
            .iter()
            .filter(|(multiple, _)| *multiple != scale);
        others.count() * self.weights[id.index()]
    }

    /// Adds or takes away one read of a multiple.
    fn want(&mut self, id: NodeId, multiple: Ratio, is_added: bool) {
        if id == Arena::ONE {
            return;
        }
        // The scale itself costs nothing.
        let weight = match multiple == self.scales[id.index()] {
            true => 0,
            false => self.weights[id.index()],
        };
        let wanted = &mut self.wanted[id.index()];
        match wanted.iter().position(|(other, _)| *other == multiple) {
            Some(place) if is_added => wanted[place].1 += 1,
            Some(place) if wanted[place].1 > 1 => wanted[place].1 -= 1,
            Some(place) => {
                wanted.swap_remove(place);
                self.total -= weight;
            }
            None => {
                wanted.push((multiple, 1));
                self.total += weight;
            }
        }
    }

    /// Adds or takes away what a node reads.
    fn want_operands(&mut self, id: NodeId, is_added: bool) {
        let arena = self.arena;
        match arena.node(id) {
            Node::Sum(terms) => {
                let scale = self.scales[id.index()];
                for term in terms {
                    self.want(term.node, term.factor.abs() * scale, is_added);
                }
            }
            Node::Product(a, b) => {
                let [left, right] = self.sides[id.index()];
                self.want(*a, left, is_added);
                self.want(*b, right, is_added);
            }
            Node::Function(_, arguments) => {
                for argument in arguments {
                    self.want(argument.node, argument.factor.abs(), is_added);
                }
            }
            node => node.for_each_operand(|operand| {
                self.want(operand, Ratio::ONE, is_added);
            }),
        }
    }

    /// Changes the scale of a sum.
    fn set_sum(&mut self, id: NodeId, scale: Ratio) {
        self.want_operands(id, false);
        self.total -= self.cost(id);
        self.scales[id.index()] = scale;
        self.total += self.cost(id);
        self.want_operands(id, true);
    }

    /// Changes the multiples that a product reads.
    fn set_product(&mut self, id: NodeId, sides: [Ratio; 2]) {
        self.want_operands(id, false);
        self.total -= self.cost(id);
        self.sides[id.index()] = sides;
        self.scales[id.index()] = sides[0] * sides[1];
        self.total += self.cost(id);
        self.want_operands(id, true);
    }

    /// The multiple that is read most often of a node, of equals the smallest.
    fn most_wanted(&self, id: NodeId) -> Option<Ratio> {
        let wanted = self.wanted[id.index()].iter();
        let best = wanted.max_by_key(|(multiple, count)| (*count, std::cmp::Reverse(*multiple)));
        best.map(|(multiple, _)| *multiple)
    }

    /// Moves factors to the operands, from the outputs to the inputs: those of products to a sum,
    /// or only to what is uniform.
    fn push_down(&mut self, is_staged: bool) {
        let weights = self.weights.clone();
        let arena = self.arena;
        let is_taken = |id: NodeId| match is_staged {
            true => weights[id.index()] != VARYING,
            false => matches!(arena.node(id), Node::Sum(_)),
        };
        for id in self.live.clone().into_iter().rev() {
            let Some(multiple) = self.most_wanted(id) else {
                continue;
            };
            if multiple == self.scales[id.index()] {
                continue;
            }
            match self.arena.node(id) {
                Node::Sum(_) => self.set_sum(id, multiple),
                Node::Product(a, b) if is_taken(*a) => self.set_product(id, [multiple, Ratio::ONE]),
                Node::Product(a, b) if is_taken(*b) => self.set_product(id, [Ratio::ONE, multiple]),
                _ => {}
            }
        }
    }

    /// Adds multiples that serve several products, the most useful first. Of many, every one that
    /// saves.
    fn add_multiples(&mut self) {
        loop {
            let candidates = self.candidates();
            let before = self.total;
            if candidates.len() > MOST_CANDIDATES {
                for (id, multiple) in candidates {
                    let least = self.total;
                    let undo = self.serve(id, multiple);
                    if self.total >= least {
                        self.restore(undo);
                    }
                }
                if self.total == before {
                    return;
                }
                continue;
            }
            let mut best: Option<(usize, NodeId, Ratio)> = None;
            for (id, multiple) in candidates {
                let undo = self.serve(id, multiple);
                let after = self.total;
                self.restore(undo);
                if after < best.map_or(before, |(least, ..)| least) {
                    best = Some((after, id, multiple));
                }
            }
            let Some((_, id, multiple)) = best else {
                return;
            };
            self.serve(id, multiple);
        }
    }

    fn restore(&mut self, undo: Vec<(NodeId, [Ratio; 2])>) {
        for (product, sides) in undo.into_iter().rev() {
            self.set_product(product, sides);
        }
    }

    /// Operands, each with the factor that a product which reads it lacks. A single product gains
    /// nothing by a multiple that is not read yet.
    fn candidates(&self) -> Vec<(NodeId, Ratio)> {
        let mut found: BTreeMap<(NodeId, Ratio), bool> = BTreeMap::new();
        for &id in &self.live {
            let &Node::Product(a, b) = self.arena.node(id) else {
                continue;
            };
            let scale = self.scales[id.index()];
            for &(multiple, _) in &self.wanted[id.index()] {
                if multiple == scale {
                    continue;
                }
                let missing = multiple / scale;
                for (operand, side) in [a, b].into_iter().zip(self.sides[id.index()]) {
                    let is_read = self.count(operand, side * missing) > 0;
                    found
                        .entry((operand, missing))
                        .and_modify(|serves| *serves = true)
                        .or_insert(is_read);
                }
            }
        }
        let useful = found.into_iter().filter(|(_, serves)| *serves);
        useful.map(|(candidate, _)| candidate).collect()
    }

    /// Lets every product that gains by it read another multiple of a node; returns the former
    /// state.
    fn serve(&mut self, id: NodeId, multiple: Ratio) -> Vec<(NodeId, [Ratio; 2])> {
        let mut undo = Vec::new();
        for product in self.products[id.index()].clone() {
            let sides = self.sides[product.index()];
            let is_first = matches!(self.arena.node(product), Node::Product(a, _) if *a == id);
            let changed = match is_first {
                true => [sides[0] * multiple, sides[1]],
                false => [sides[0], sides[1] * multiple],
            };
            let before = self.cost(product);
            self.set_product(product, changed);
            if self.cost(product) < before {
                undo.push((product, sides));
            } else {
                self.set_product(product, sides);
            }
        }
        undo
    }

    /// Gives sums the scale that saves most, while something is saved.
    fn settle_sums(&mut self) {
        for _ in 0..3 {
            let before = self.total;
            for id in self.live.clone().into_iter().rev() {
                let Node::Sum(terms) = self.arena.node(id) else {
                    continue;
                };
                let current = self.scales[id.index()];
                let mut tried: Vec<Ratio> = self.wanted[id.index()].iter().map(|w| w.0).collect();
                for term in terms {
                    tried.push(self.scales[term.node.index()] / term.factor.abs());
                }
                tried.order();
                tried.dedup();
                let mut best = (self.total, current);
                for scale in tried {
                    if scale != current {
                        self.set_sum(id, scale);
                        if self.total < best.0 {
                            best = (self.total, scale);
                        }
                    }
                }
                self.set_sum(id, best.1);
            }
            if self.total == before {
                return;
            }
        }
    }

    /// The graph with these scales.
    fn build(&self, outputs: &[Value], reads: &[usize]) -> Option<Graph> {
        let (mut copy, images) = rewrite(self.arena, outputs, reads, |copy, id, images| {
            let scale = self.scales[id.index()];
            let whole = match self.arena.node(id) {
                Node::Product(a, b) => {
                    let [left, right] = self.sides[id.index()];
                    let left = self.multiple(copy, images, *a, left);
                    let right = self.multiple(copy, images, *b, right);
                    copy.product(left, right)
                }
                Node::Sum(terms) => {
                    let terms = self.scaled_terms(copy, images, terms, scale);
                    copy.sum(terms)
                }
                _ => return None,
            };
            // The image of a node is the multiple that is computed, divided by the scale again.
            Some(whole.scaled(Ratio::ONE / scale))
        })?;
        let outputs = outputs.iter().zip(images).map(|(output, image)| {
            let is_shared = self.count(output.node, output.factor.abs()) > 1;
            if is_shared { copy.held(image) } else { image }
        });
        let outputs = outputs.collect();
        Some((copy, outputs))
    }

    /// How often a multiple of a node is read.
    fn count(&self, id: NodeId, multiple: Ratio) -> usize {
        let wanted = &self.wanted[id.index()];
        let found = wanted.iter().find(|(other, _)| *other == multiple);
        found.map_or(0, |(_, count)| *count)
    }

    /// A multiple of a node in the copy, a node of its own.
    fn multiple(&self, copy: &mut Arena, images: &[Value], id: NodeId, multiple: Ratio) -> Value {
        let value = images[id.index()].scaled(multiple);
        let is_scale = multiple == self.scales[id.index()];
        if is_scale { value } else { copy.held(value) }
    }

    /// The terms of a sum whose scale is given. A whole factor that only this sum needs stays at
    /// its term, unless it is common to all terms and moves outwards.
    fn scaled_terms(
        &self,
        copy: &mut Arena,
        images: &[Value],
        terms: &[Value],
        scale: Ratio,
    ) -> Vec<Value> {
        let is_plain = |term: &Value| term.factor.abs() * scale == self.scales[term.node.index()];
        let has_plain = terms.iter().any(is_plain);
        let scaled = terms.iter().map(|term| {
            let size = term.factor.abs() * scale;
            let is_uniform = self.weights[term.node.index()] != VARYING;
            let ratio = size / self.scales[term.node.index()];
            let is_shared = is_uniform || self.count(term.node, size) > 1;
            if has_plain && ratio.is_integer() && !is_shared {
                images[term.node.index()].scaled(term.factor * scale)
            } else {
                let sign = term.factor / term.factor.abs();
                self.multiple(copy, images, term.node, size).scaled(sign)
            }
        });
        scaled.collect()
    }
}
