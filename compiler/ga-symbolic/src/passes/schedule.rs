//! Dead code and order: what the outputs need, each node after what it needs itself.
//!
//! Outputs are computed from the first to the last, each depth first, so that a value is computed
//! close to where it is first used. Which operand of a node comes first decides how many values
//! wait at the same time. The one that needs most registers should come first, since no other value
//! still waits while it is computed (Sethi and Ullman, "The generation of optimal code for
//! arithmetic expressions", 1970). For trees this is optimal. Graphs share nodes, so the order as
//! written is tried too, and the one in which fewer values wait is taken.

use super::rewrite::reads;
use crate::ir::{Arena, Node, NodeId, Value};
use crate::order::Order as _;

/// The nodes that some outputs need, in an order in which they can be computed.
#[derive(Clone, Debug)]
pub struct Schedule {
    /// The nodes other than inputs and the number 1.
    pub order: Vec<NodeId>,
    /// How often each node of the arena is read, by its index; zero for a dead node.
    pub uses: Vec<usize>,
}

impl Schedule {
    /// The largest number of values, inputs not among them, that are computed and still needed at
    /// the same time.
    #[must_use]
    pub fn pressure(&self, arena: &Arena) -> usize {
        let mut left = self.uses.clone();
        let (mut waiting, mut most) = (0_usize, 0);
        for &id in &self.order {
            arena.node(id).for_each_operand(|operand| {
                left[operand.index()] -= 1;
                if left[operand.index()] == 0 && is_computed(arena, operand) {
                    waiting -= 1;
                }
            });
            waiting += 1;
            most = most.max(waiting);
        }
        most
    }
}

/// Finds the live nodes of an arena and an order with little register pressure.
#[must_use]
pub fn schedule(arena: &Arena, outputs: &[Value]) -> Schedule {
    let uses = reads(arena, outputs);
    let registers = registers(arena, &uses);
    let by_registers = |operands: &mut Vec<NodeId>| {
        operands.order_by_key(|id| std::cmp::Reverse(registers[id.index()]));
    };
    let in_order = |order| Schedule {
        order,
        uses: uses.clone(),
    };
    let written = in_order(depth_first(arena, outputs, |_| {}));
    let sorted = in_order(depth_first(arena, outputs, by_registers));
    if sorted.pressure(arena) < written.pressure(arena) {
        sorted
    } else {
        written
    }
}

/// The live nodes, each after its operands, these in the order that `arrange` gives them.
fn depth_first(
    arena: &Arena,
    outputs: &[Value],
    arrange: impl Fn(&mut Vec<NodeId>),
) -> Vec<NodeId> {
    let mut order = Vec::new();
    let mut is_done = vec![false; arena.len()];
    // Nodes to be computed, and whether their operands are.
    let mut open: Vec<(NodeId, bool)> = Vec::new();
    for output in outputs.iter().filter(|value| !value.is_zero()) {
        open.push((output.node, false));
        while let Some((id, is_ready)) = open.pop() {
            if is_ready {
                order.push(id);
            } else if !is_done[id.index()] && is_computed(arena, id) {
                is_done[id.index()] = true;
                open.push((id, true));
                let mut operands = Vec::new();
                arena
                    .node(id)
                    .for_each_operand(|operand| operands.push(operand));
                arrange(&mut operands);
                open.extend(operands.into_iter().rev().map(|operand| (operand, false)));
            }
        }
    }
    order
}

/// The number of registers that the computation of each live node takes if nothing is shared.
fn registers(arena: &Arena, uses: &[usize]) -> Vec<usize> {
    let mut registers = vec![0; arena.len()];
    let mut needs: Vec<usize> = Vec::new();
    for id in arena.ids() {
        if uses[id.index()] == 0 || !is_computed(arena, id) {
            continue;
        }
        needs.clear();
        arena
            .node(id)
            .for_each_operand(|operand| needs.push(registers[operand.index()]));
        needs.order_by_key(|need| std::cmp::Reverse(*need));
        let waiting = needs.iter().enumerate().map(|(before, need)| match need {
            0 => 1,
            _ => need + before,
        });
        registers[id.index()] = waiting.max().unwrap_or(1);
    }
    registers
}

fn is_computed(arena: &Arena, id: NodeId) -> bool {
    !matches!(arena.node(id), Node::One | Node::Input(_))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dead_nodes_are_not_scheduled() {
        let mut arena = Arena::default();
        let (a, b) = (arena.input(), arena.input());
        let wanted = arena.product(a, b);
        let dead = arena.sum([wanted, a]);
        let found = schedule(&arena, &[wanted]);
        assert_eq!(found.order, [wanted.node]);
        assert_eq!(found.uses[dead.node.index()], 0);
    }
}
