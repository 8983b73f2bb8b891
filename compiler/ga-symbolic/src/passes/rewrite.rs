//! Copying a graph while some of its nodes change.

use crate::ir::{Arena, Node, NodeId, Value};

/// A graph and its outputs.
pub type Graph = (Arena, Vec<Value>);

/// How often each node is read by what the outputs need; zero for a dead node.
pub(super) fn reads(arena: &Arena, outputs: &[Value]) -> Vec<usize> {
    let mut reads = vec![0; arena.len()];
    for output in outputs.iter().filter(|value| !value.is_zero()) {
        reads[output.node.index()] += 1;
    }
    for id in arena.ids().rev() {
        if reads[id.index()] > 0 {
            arena
                .node(id)
                .for_each_operand(|operand| reads[operand.index()] += 1);
        }
    }
    reads
}

/// The factors of a product. Products in it that nothing else reads are replaced by their factors;
/// a node that others read stands for itself.
pub(super) fn collect_factors(
    arena: &Arena,
    reads: &[usize],
    id: NodeId,
    factors: &mut Vec<NodeId>,
) {
    let mut open = vec![id];
    while let Some(id) = open.pop() {
        match arena.node(id) {
            Node::Product(a, b) if reads[id.index()] == 1 => open.extend([*b, *a]),
            _ => factors.push(id),
        }
    }
}

/// Copies the live nodes of a graph. `change` may return another value for a node, built in the
/// copy from the images of earlier nodes; if it returns none, the node is copied.
///
/// `None` if a divisor is zero.
pub(super) fn rewrite(
    arena: &Arena,
    outputs: &[Value],
    reads: &[usize],
    change: impl FnMut(&mut Arena, NodeId, &[Value]) -> Option<Value>,
) -> Option<Graph> {
    rewrite_in_order(arena, outputs, arena.ids(), reads, change)
}

/// Copies a graph so that the nodes that some values need come first. Returns these values in the
/// copy, too.
pub(super) fn with_first(
    arena: &Arena,
    outputs: &[Value],
    first: &[Value],
) -> Option<(Graph, Vec<Value>)> {
    let before = reads(arena, first);
    let all: Vec<Value> = outputs.iter().chain(first).copied().collect();
    let live = reads(arena, &all);
    let (early, late): (Vec<NodeId>, Vec<NodeId>) =
        arena.ids().partition(|id| before[id.index()] > 0);
    let order = early.into_iter().chain(late);
    let (copy, mut all) = rewrite_in_order(arena, &all, order, &live, |_, _, _| None)?;
    let first = all.split_off(outputs.len());
    Some(((copy, all), first))
}

fn rewrite_in_order(
    arena: &Arena,
    outputs: &[Value],
    order: impl Iterator<Item = NodeId>,
    reads: &[usize],
    mut change: impl FnMut(&mut Arena, NodeId, &[Value]) -> Option<Value>,
) -> Option<Graph> {
    let mut copy = Arena::default();
    let inputs: Vec<Value> = (0..arena.inputs()).map(|_| copy.input()).collect();
    let mut images = vec![Value::ZERO; arena.len()];
    // What is changed may read the number 1 though nothing did before.
    images[Arena::ONE.index()] = Value::ONE;
    for id in order.filter(|id| reads[id.index()] > 0) {
        let image = match arena.node(id) {
            Node::Input(number) => inputs[*number],
            node => match change(&mut copy, id, &images) {
                Some(changed) => changed,
                None => copy.copied(node, &images)?,
            },
        };
        images[id.index()] = image;
    }
    let outputs = outputs.iter().map(|value| value.image(&images)).collect();
    Some((copy, outputs))
}
