//! The level ground under a model, and the background behind both.

use crate::{Vector, View};

/// A level ground with a faint grid, fading into the background.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// The *y* coordinate of the plane.
    pub height: f64,
    /// The distance between grid lines, in the unit of the model.
    pub grid: f64,
}

impl Ground {
    /// The depth at which a ray of depth 1 in the camera's frame meets the ground; infinite where
    /// it does not.
    pub(crate) fn depth(&self, view: &View, ray: Vector) -> f64 {
        let fall = view.world_direction(ray).e2;
        let depth = (self.height - view.eye()[1]) / fall;
        if depth >= view.near() && depth <= view.far() {
            depth
        } else {
            f64::INFINITY
        }
    }
}
