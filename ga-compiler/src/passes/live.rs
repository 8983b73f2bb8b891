//! Dead code and order: what the outputs need, each node after what it needs itself.

use crate::ir::{Arena, Node, NodeId, Value};

/// The nodes that some outputs need, in an order in which they can be computed.
#[derive(Clone, Debug)]
pub struct Schedule {
    /// The nodes other than inputs and the number 1.
    pub order: Vec<NodeId>,
    /// How often each node of the arena is read, by its index; zero for a dead one.
    pub uses: Vec<usize>,
}

/// Finds the live nodes of an arena. They come in depth-first order from the first output to the last, so that a
/// value is computed close to where it is first used.
#[must_use]
pub fn schedule(arena: &Arena, outputs: &[Value]) -> Schedule {
    let mut result = Schedule {
        order: Vec::new(),
        uses: vec![0; arena.len()],
    };
    for output in outputs.iter().filter(|value| !value.is_zero()) {
        visit(arena, output.node, &mut result);
    }
    result
}

fn visit(arena: &Arena, id: NodeId, result: &mut Schedule) {
    result.uses[id.index()] += 1;
    if result.uses[id.index()] > 1 {
        return;
    }
    match arena.node(id) {
        Node::One | Node::Input(_) => return,
        Node::Sum(terms) => {
            for term in terms {
                visit(arena, term.node, result);
            }
        }
        Node::Function(_, arguments) => {
            for argument in arguments {
                visit(arena, argument.node, result);
            }
        }
        Node::Product(a, b) | Node::Quotient(a, b) => {
            visit(arena, *a, result);
            visit(arena, *b, result);
        }
    }
    result.order.push(id);
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
