//! Nodes of the hierarchy.

use ga_runtime::scalar::Lanes;

/// How many children a node has.
pub(super) const BRANCHES: usize = 8;

/// One number for each child.
pub(super) type Children = Lanes<f32, BRANCHES>;

/// Set in the reference to a child that is a leaf; the other bits number its packet. Without it,
/// they number a node.
pub(super) const LEAF: u32 = 1 << 31;

/// The reference to a child that does not exist: a leaf without a packet.
pub(super) const NOTHING: u32 = u32::MAX;

/// Eight children with their boxes, in the coordinates of the frame. The boxes are rounded
/// outwards. A child that does not exist has a box that is met by no query whose numbers are in the
/// range of `f32`, and refers to [`NOTHING`].
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(super) struct Node {
    /// The lower and the upper bound of x, of y and of z.
    pub(super) bounds: [Children; 6],
    /// Nodes and leaves.
    pub(super) children: [u32; BRANCHES],
}

/// The longest path from the root to a leaf. The builder keeps to it.
pub(super) const DEPTH: usize = 20;

/// As many references as a traversal can have put aside: seven at each node of a path, the node
/// itself, and a place for one that is not kept.
pub(super) const STACK: usize = (BRANCHES - 1) * DEPTH + 2;

/// What a traversal has put aside: references to nodes and leaves, each with a lower bound of its
/// distance.
pub(super) struct Stack {
    entries: [u64; STACK],
    length: usize,
}

impl Stack {
    /// Only the root is left to visit.
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self {
            entries: [0; STACK],
            length: 1,
        }
    }

    /// The reference put aside last, with its distance.
    #[inline(always)]
    pub(super) fn pop(&mut self) -> Option<(f32, u32)> {
        self.length = self.length.checked_sub(1)?;
        let entry = self.entries[self.length];
        Some((f32::from_bits((entry >> 32) as u32), entry as u32))
    }

    /// Puts aside the children of a node at which `distances` is below infinity, the nearest one
    /// last. Distances are not negative.
    #[inline(always)]
    pub(super) fn push(&mut self, distances: [f32; BRANCHES], children: &[u32; BRANCHES]) {
        // Without branches, since it cannot be predicted which children are met.
        let first = self.length;
        let mut length = first;
        for (distance, child) in distances.into_iter().zip(children) {
            if let Some(place) = self.entries.get_mut(length) {
                *place = u64::from(distance.to_bits()) << 32 | u64::from(*child);
            }
            length += usize::from(distance < f32::INFINITY);
        }
        self.length = length.min(STACK);
        // Numbers that are not negative are in the order of their bits.
        if let Some((last, others)) = self.entries[first..self.length].split_last_mut() {
            for other in others {
                let (near, far) = ((*last).min(*other), (*last).max(*other));
                (*last, *other) = (near, far);
            }
        }
    }
}
