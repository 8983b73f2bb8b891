//! Frames along which the parts of the body are measured.

use crate::vector::Vector;

/// A point on a straight axis and the directions of the axis and of the two reaches, orthonormal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) origin: Vector,
    pub(crate) along: Vector,
    pub(crate) across: Vector,
    pub(crate) depth: Vector,
}

impl Frame {
    /// At the origin, along straight up, across to the left, depth to the front.
    pub(crate) const UPRIGHT: Frame = Frame {
        origin: [0.0; 3],
        along: [0.0, 1.0, 0.0],
        across: [1.0, 0.0, 0.0],
        depth: [0.0, 0.0, 1.0],
    };

    /// The point at the given position along the axis and off it.
    pub(crate) fn point(&self, along: f64, across: f64, depth: f64) -> Vector {
        std::array::from_fn(|i| {
            self.origin[i] + along * self.along[i] + across * self.across[i] + depth * self.depth[i]
        })
    }
}
