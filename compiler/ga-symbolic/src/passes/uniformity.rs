//! Which nodes are uniform: the same for every element of a batch.

use crate::ir::{Arena, Node, NodeId};

/// Which nodes of a growing arena are uniform.
#[derive(Clone, Debug)]
pub(super) struct Uniformity<'a> {
    uniform: &'a [bool],
    has_uniform: bool,
    known: Vec<bool>,
}

impl<'a> Uniformity<'a> {
    /// For inputs that are marked uniform; those beyond the end of the list vary.
    #[must_use]
    pub(super) fn new(uniform: &'a [bool]) -> Self {
        Self {
            uniform,
            has_uniform: uniform.contains(&true),
            known: Vec::new(),
        }
    }

    /// Whether a node depends on uniform inputs only. If no input is marked, only constants do.
    pub(super) fn is_uniform(&mut self, arena: &Arena, id: NodeId) -> bool {
        if !self.has_uniform {
            return id == Arena::ONE;
        }
        for next in arena.ids_from(self.known.len()) {
            let known = &self.known;
            let is_uniform = match arena.node(next) {
                Node::One => true,
                Node::Input(number) => self.uniform.get(*number).copied().unwrap_or(false),
                node => {
                    let mut all = true;
                    node.for_each_operand(|operand| all &= known[operand.index()]);
                    all
                }
            };
            self.known.push(is_uniform);
        }
        self.known[id.index()]
    }
}
