//! Two stages of a kernel: what depends on its uniform inputs alone, and the rest.

use crate::ir::{Arena, Node, NodeId, Value};
use crate::kernel::Kernel;
use crate::passes::schedule;

/// A kernel in two stages. Without uniform inputs the first is empty.
pub(crate) struct Stages {
    /// What is done once.
    pub(crate) prologue: Stage,
    /// What is done in every call.
    pub(crate) inner: Stage,
    /// The nodes that the first stage hands to the second: uniform inputs and nodes that are read
    /// there, in rising order.
    pub(crate) handed: Vec<NodeId>,
}

/// The nodes of one stage.
pub(crate) struct Stage {
    /// The nodes other than inputs and the number 1, each after what it needs.
    pub(crate) order: Vec<NodeId>,
    /// How often each node of the arena is read in this stage, by its index.
    pub(crate) uses: Vec<usize>,
}

impl Stages {
    /// Parts a kernel.
    pub(crate) fn new(kernel: &Kernel) -> Self {
        let arena = &kernel.arena;
        let live = schedule(arena, &kernel.outputs);
        let uniform = uniform_nodes(kernel);
        let (first, second): (Vec<_>, Vec<_>) =
            live.order.into_iter().partition(|id| uniform[id.index()]);
        let inner = Stage::new(arena, second, kernel.outputs.iter().map(|value| value.node));
        let handed: Vec<NodeId> = live_inputs(arena, &inner.uses)
            .chain(first.iter().copied())
            .filter(|id| uniform[id.index()] && inner.uses[id.index()] > 0)
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
    fn new(arena: &Arena, order: Vec<NodeId>, roots: impl Iterator<Item = NodeId>) -> Self {
        let mut uses = vec![0; arena.len()];
        for &id in &order {
            for child in children(arena.node(id)) {
                uses[child.index()] += 1;
            }
        }
        for root in roots {
            uses[root.index()] += 1;
        }
        Self { order, uses }
    }
}

/// What a node reads, each as often as it is read.
pub(crate) fn children(node: &Node) -> Vec<NodeId> {
    let nodes = |values: &[Value]| values.iter().map(|value| value.node).collect();
    match node {
        Node::One | Node::Input(_) => Vec::new(),
        Node::Sum(terms) => nodes(terms),
        Node::Function(_, arguments) => nodes(arguments),
        Node::Product(a, b) | Node::Quotient(a, b) => vec![*a, *b],
    }
}

fn live_inputs<'a>(arena: &'a Arena, uses: &'a [usize]) -> impl Iterator<Item = NodeId> + 'a {
    arena
        .ids()
        .filter(|&id| matches!(arena.node(id), Node::Input(_)) && uses[id.index()] > 0)
}

/// For each node, whether it depends on uniform inputs and on nothing else.
fn uniform_nodes(kernel: &Kernel) -> Vec<bool> {
    if !kernel.uniform.contains(&true) {
        return vec![false; kernel.arena.len()];
    }
    let mut uniform: Vec<bool> = Vec::with_capacity(kernel.arena.len());
    for id in kernel.arena.ids() {
        let node = kernel.arena.node(id);
        let is_uniform = match node {
            Node::One => false,
            Node::Input(number) => kernel.uniform.get(*number).copied().unwrap_or(false),
            _ => children(node)
                .into_iter()
                .all(|child| child == Arena::ONE || uniform[child.index()]),
        };
        uniform.push(is_uniform);
    }
    uniform
}
