//! Equal graphs, whatever the order of their nodes.

use std::hash::{Hash, Hasher};

use rustc_hash::FxHasher;

use super::{Arena, Node, NodeId, Value};
use crate::order::Order as _;

impl Arena {
    /// A number that is the same for graphs that compute the same outputs in the same way, in
    /// whatever order their nodes were added.
    #[must_use]
    pub(crate) fn fingerprint(&self, outputs: &[Value]) -> u64 {
        let mut hashes: Vec<u64> = Vec::with_capacity(self.len());
        for id in self.ids() {
            let of = |id: NodeId| hashes[id.index()];
            let each = |value: &Value| hash((value.factor, of(value.node)));
            let next = match self.node(id) {
                Node::One => hash(0_u8),
                Node::Input(number) => hash((1_u8, *number)),
                Node::Sum(terms) => {
                    let mut terms: Vec<u64> = terms.iter().map(each).collect();
                    terms.order();
                    hash((2_u8, terms))
                }
                Node::Product(a, b) => {
                    let (a, b) = (of(*a), of(*b));
                    hash((3_u8, a.min(b), a.max(b)))
                }
                Node::Quotient(a, b) => hash((4_u8, of(*a), of(*b))),
                Node::Function(function, arguments) => {
                    let arguments: Vec<u64> = arguments.iter().map(each).collect();
                    hash((5_u8, *function, arguments))
                }
            };
            hashes.push(next);
        }
        let outputs: Vec<u64> = outputs
            .iter()
            .map(|value| hash((value.factor, hashes[value.node.index()])))
            .collect();
        hash(outputs)
    }
}

fn hash(value: impl Hash) -> u64 {
    let mut hasher = FxHasher::default();
    value.hash(&mut hasher);
    hasher.finish()
}
