//! Points on joints, and where they should be.

use ga_runtime::cga3::Point;

/// A point that is fixed to a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marker {
    /// The joint that carries it.
    pub joint: usize,
    /// Where it is at rest, in the coordinates of the skeleton.
    pub at_rest: [f64; 3],
}

/// Where a marker should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// The place.
    pub position: Point<f64>,
    /// How much its squared distance counts; 0 for a marker that was not seen.
    pub weight: f64,
}
