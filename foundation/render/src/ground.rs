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
    /// The ground under a box of these least and greatest coordinates, with a grid of about a fifth
    /// of its size.
    #[must_use]
    pub fn under([low, high]: [Vector; 2]) -> Self {
        let sides = high - low;
        let size = sides.e1.max(sides.e2).max(sides.e3);
        Self {
            height: low.e2,
            grid: (size / 5.0).max(f64::MIN_POSITIVE),
        }
    }

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
