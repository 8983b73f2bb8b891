//! The hierarchy as data.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::frame::Frame;
use super::node::{LEAF, Node};
use super::packet::{Packet, Screen};

/// A bounding volume hierarchy over triangles; see the [module](super).
#[derive(Clone, Debug)]
pub struct Bvh {
    pub(super) frame: Frame,
    pub(super) bounds: Option<[Vector<f64>; 2]>,
    /// The first one is the root.
    pub(super) nodes: Vec<Node>,
    pub(super) packets: Vec<Packet>,
    /// One for each packet.
    pub(super) screens: Vec<Screen>,
    pub(super) triangle_count: usize,
}

impl Bvh {
    /// How many triangles there are.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// The least and the greatest coordinates of the triangles; `None` if there are none.
    #[must_use]
    pub fn bounds(&self) -> Option<[Point<f64>; 2]> {
        self.bounds.map(|bounds| bounds.map(Point::from))
    }

    /// The packet of a leaf, if it has one.
    #[inline(always)]
    pub(super) fn packet(&self, leaf: u32) -> Option<&Packet> {
        self.packets.get((leaf ^ LEAF) as usize)
    }
}
