//! Planes with a positive side.

use ga_runtime::vga3::Vector;

/// The plane of the points x with `n·x = d`, n of length 1. Its positive side is the one that the
/// normal points to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    pub(crate) normal: Vector<f64>,
    pub(crate) distance: f64,
}

impl Plane {
    /// The plane through a point.
    pub(crate) fn through(point: Vector<f64>, normal: Vector<f64>) -> Self {
        let distance = normal.dot(point);
        Self { normal, distance }
    }

    /// The distance of a point from the plane, positive on its positive side.
    pub(crate) fn height(&self, point: Vector<f64>) -> f64 {
        self.normal.dot(point) - self.distance
    }
}
