//! How much of space a scene takes up.

use crate::scene::Scene;
use crate::shape::Shape;
use crate::vector3::{Vector3, along, difference, dot, length, scaled, sum};

/// The ball that holds what is finite in a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    pub(crate) centre: Vector3,
    pub(crate) radius: f64,
}

impl Extent {
    pub(crate) fn of(scene: &Scene) -> Self {
        let mut bounds = Bounds::default();
        for shape in scene.shapes() {
            finite(shape, &mut bounds);
        }
        if scene.axes || scene.grid {
            bounds.hold([0.0; 3]);
        }
        // Lines and planes come in where they are nearest to the rest.
        let middle = bounds.middle();
        for shape in scene.shapes() {
            match *shape {
                Shape::Line { support, direction } => {
                    let t = dot(difference(middle, support), direction);
                    bounds.hold(along(support, direction, t));
                }
                Shape::Plane { support, normal } => {
                    let t = dot(difference(support, middle), normal);
                    bounds.hold(along(middle, normal, t));
                }
                _ => {}
            }
        }
        let centre = bounds.middle();
        let radius = length(difference(bounds.high, centre));
        // A single place gets a neighbourhood in proportion to where it is.
        let least = 1e-9 * length(centre);
        if radius > least && radius.is_normal() {
            Self { centre, radius }
        } else {
            let radius = if least > 0.0 {
                1.0_f64.max(0.1 * length(centre))
            } else {
                1.0
            };
            Self { centre, radius }
        }
    }

    /// A place in the coordinates of the picture, in which the ball is that of radius 1 about the
    /// origin.
    pub(crate) fn place(&self, point: Vector3) -> Vector3 {
        difference(point, self.centre).map(|x| x / self.radius)
    }
}

/// A box.
#[derive(Clone, Copy)]
struct Bounds {
    low: Vector3,
    high: Vector3,
}

impl Default for Bounds {
    fn default() -> Self {
        Self {
            low: [f64::INFINITY; 3],
            high: [f64::NEG_INFINITY; 3],
        }
    }
}

impl Bounds {
    fn hold(&mut self, point: Vector3) {
        for (k, x) in point.into_iter().enumerate() {
            self.low[k] = self.low[k].min(x);
            self.high[k] = self.high[k].max(x);
        }
    }

    fn hold_about(&mut self, centre: Vector3, extent: Vector3) {
        self.hold(difference(centre, extent));
        self.hold(sum(centre, extent));
    }

    /// The centre of the box; the origin where nothing is in it.
    fn middle(&self) -> Vector3 {
        if self.low[0] > self.high[0] {
            return [0.0; 3];
        }
        scaled(sum(self.low, self.high), 0.5)
    }
}

/// Holds what has an end.
fn finite(shape: &Shape, bounds: &mut Bounds) {
    match shape {
        Shape::Point { at }
        | Shape::FlatPoint { at }
        | Shape::TangentVector { at, .. }
        | Shape::TangentBivector { at, .. } => bounds.hold(*at),
        Shape::PointPair {
            centre,
            direction,
            radius,
            ..
        } => bounds.hold_about(*centre, direction.map(|d| d.abs() * radius)),
        Shape::Circle {
            centre,
            normal,
            radius,
            ..
        } => {
            // Along an axis a circle reaches as far as the sine of the angle to its normal.
            let reach = normal.map(|n| radius * (1.0 - n * n).max(0.0).sqrt());
            bounds.hold_about(*centre, reach);
        }
        Shape::Sphere { centre, radius, .. } => bounds.hold_about(*centre, [*radius; 3]),
        Shape::Line { .. } | Shape::Plane { .. } => {}
        Shape::Direction { vector } => {
            bounds.hold([0.0; 3]);
            bounds.hold(*vector);
        }
        Shape::Frame { origin, .. } => bounds.hold(*origin),
        Shape::Trajectory { points, frames } => {
            for point in points.iter().chain(frames.iter().map(|(origin, _)| origin)) {
                bounds.hold(*point);
            }
        }
    }
}
