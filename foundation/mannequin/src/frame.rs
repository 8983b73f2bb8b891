//! Frames in which the parts of the body are measured.

use crate::Vector;

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
        origin: Vector::ZERO,
        along: Vector::Y,
        across: Vector::X,
        depth: Vector::Z,
    };

    /// The point at the given position along the axis and off it.
    pub(crate) fn point(&self, along: f64, across: f64, depth: f64) -> Vector {
        self.origin + self.along * along + self.across * across + self.depth * depth
    }
}
