//! Two stages of a graph: what depends on its uniform inputs alone, and the rest.

use super::schedule::{Schedule, schedule};
use super::uniformity::Uniformity;
use crate::ir::{Arena, Node, NodeId, Value};

/// A graph in two stages. Without uniform inputs the first is empty.
pub struct Stages {
    /// What is done once.
    pub prologue: Stage,
    /// What is done in every call.
    pub inner: Stage,
    /// The nodes that the first stage hands to the second: uniform inputs and nodes that are read
    /// there, in rising order.
    pub handed: Vec<NodeId>,
}

/// The nodes of one stage.
pub struct Stage {
    /// The nodes other than inputs and the number 1, each after what it needs.
    pub order: Vec<NodeId>,
    /// How often each node of the arena is read in this stage, by its index. A node that is read
    /// more than once is written as a variable; one that would stand too deep inside the
    /// expressions of others counts as read twice.
    pub uses: Vec<usize>,
}

/// How deep expressions are written inside each other. Emitted code is parsed again, by recursion.
const MAX_DEPTH: usize = 64;

impl Stages {
    /// Divides a graph; `uniform` marks the inputs that stay the same over many calls.
    pub fn new(arena: &Arena, outputs: &[Value], uniform: &[bool]) -> Self {
        let live = schedule(arena, outputs);
        let mut uniformity = Uniformity::new(uniform);
        let mut is_uniform = |id: NodeId| uniformity.is_uniform(arena, id);
        let (first, second) = divided(arena, &live.order, &mut is_uniform);
        let inner = Stage::new(arena, second, outputs.iter().map(|value| value.node));
        let handed: Vec<NodeId> = live_inputs(arena, &inner.uses)
            .chain(first.iter().copied())
            .filter(|id| inner.uses[id.index()] > 0 && is_uniform(*id))
            .filter(|id| !is_condition(arena, *id))
            .collect();
        let prologue = Stage::new(arena, first, handed.iter().copied());
        Self {
            prologue,
            inner,
            handed,
        }
    }
}

impl Stage {
    /// A graph that is not divided.
    pub fn whole(arena: &Arena, outputs: &[Value]) -> Self {
        let Schedule { order, uses } = schedule(arena, outputs);
        Self { order, uses }.with_bounded_depth(arena)
    }

    fn new(arena: &Arena, order: Vec<NodeId>, roots: impl Iterator<Item = NodeId>) -> Self {
        let mut uses = vec![0; arena.len()];
        for &id in &order {
            arena
                .node(id)
                .for_each_operand(|operand| uses[operand.index()] += 1);
        }
        for root in roots {
            uses[root.index()] += 1;
        }
        Self { order, uses }.with_bounded_depth(arena)
    }

    fn with_bounded_depth(mut self, arena: &Arena) -> Self {
        let mut depths = vec![0; arena.len()];
        for &id in &self.order {
            let mut depth = 0;
            arena.node(id).for_each_operand(|operand| {
                if self.uses[operand.index()] == 1 {
                    depth = depth.max(depths[operand.index()] + 1);
                }
            });
            if depth == MAX_DEPTH {
                self.uses[id.index()] = self.uses[id.index()].max(2);
            }
            depths[id.index()] = depth;
        }
        self
    }
}

/// The nodes of the two stages. The first hands numbers to the second, not conditions: a uniform
/// condition that the second stage reads is computed there, from numbers that are handed over.
fn divided(
    arena: &Arena,
    order: &[NodeId],
    is_uniform: &mut impl FnMut(NodeId) -> bool,
) -> (Vec<NodeId>, Vec<NodeId>) {
    let mut belongs = vec![[false; 2]; arena.len()];
    for &id in order.iter().rev() {
        if !is_condition(arena, id) {
            belongs[id.index()] = [is_uniform(id), !is_uniform(id)];
        } else if !is_uniform(id) {
            belongs[id.index()] = [false, true];
        }
        let [first, second] = belongs[id.index()];
        arena.node(id).for_each_operand(|operand| {
            if is_condition(arena, operand) {
                belongs[operand.index()][0] |= first;
                belongs[operand.index()][1] |= second;
            }
        });
    }
    let stage = |number: usize| {
        let nodes = order.iter().copied();
        nodes
            .filter(|id| belongs[id.index()][number])
            .collect::<Vec<_>>()
    };
    (stage(0), stage(1))
}

fn is_condition(arena: &Arena, id: NodeId) -> bool {
    matches!(arena.node(id), Node::Function(function, _) if function.is_condition())
}

fn live_inputs<'a>(arena: &'a Arena, uses: &'a [usize]) -> impl Iterator<Item = NodeId> + 'a {
    arena
        .ids()
        .filter(|&id| matches!(arena.node(id), Node::Input(_)) && uses[id.index()] > 0)
}
