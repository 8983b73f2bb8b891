//! Nodes of the hierarchy.

use ga_runtime::scalar::{LaneMask, Lanes};

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

/// As many references as a traversal can have put aside: seven at each node of a path, and the node
/// itself.
pub(super) const STACK: usize = (BRANCHES - 1) * DEPTH + 1;

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

    /// Puts aside the children of a node that are met, the nearest one last. Distances are not
    /// negative.
    #[inline(always)]
    pub(super) fn push(
        &mut self,
        is_met: LaneMask<BRANCHES>,
        distances: Children,
        children: &[u32; BRANCHES],
    ) {
        // Distances are read from memory by the bits of a mask. Branches on the lanes of a vector
        // would divide the computation of the vector.
        let mut rest = 0_u32;
        for (lane, is_met) in is_met.to_array().into_iter().enumerate() {
            rest |= u32::from(is_met) << lane;
        }
        let distances = distances.to_array();
        let mut nearest = None;
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % BRANCHES;
            rest &= rest - 1;
            // Numbers that are not negative are in the order of their bits.
            let entry = u64::from(distances[lane].to_bits()) << 32 | u64::from(children[lane]);
            if let Some(other) = nearest.replace(entry) {
                self.put(entry.max(other));
                nearest = Some(entry.min(other));
            }
        }
        if let Some(entry) = nearest {
            self.put(entry);
        }
    }

    #[inline(always)]
    fn put(&mut self, entry: u64) {
        if let Some(place) = self.entries.get_mut(self.length) {
            *place = entry;
            self.length += 1;
        }
    }
}
