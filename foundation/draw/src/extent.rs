//! The part of space that a scene takes up.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use crate::scene::Scene;
use crate::shape::Shape;

/// The ball that contains the finite elements of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    pub(crate) centre: Point<f64>,
    pub(crate) radius: f64,
    /// The corners of the box about the finite elements, in the coordinates of the picture.
    pub(crate) corners: [Vector<f64>; 2],
}

impl Extent {
    pub(crate) fn of(scene: &Scene) -> Self {
        let mut bounds = Bounds::default();
        for shape in scene.shapes() {
            finite(shape, &mut bounds);
        }
        if scene.axes || scene.grid {
            bounds.hold(Vector::default());
        }
        // Of a line or a plane, the point that is nearest to the other elements.
        let middle = bounds.middle();
        for shape in scene.shapes() {
            match *shape {
                Shape::Line { support, direction } => {
                    let support = Vector::from(support);
                    bounds.hold(support + direction * (middle - support).dot(direction));
                }
                Shape::Plane { support, normal } => {
                    let height = (Vector::from(support) - middle).dot(normal);
                    bounds.hold(middle + normal * height);
                }
                _ => {}
            }
        }
        let centre = bounds.middle();
        let radius = (bounds.high - centre).length();
        let from_origin = centre.length();
        let is_single = radius <= 1e-9 * from_origin || !radius.is_normal();
        let half = bounds.high - centre;
        // A single place gets a neighbourhood in proportion to its distance from the origin.
        let (radius, half) = if is_single {
            (1.0_f64.max(0.1 * from_origin), Vector::default())
        } else {
            (radius, half / radius)
        };
        Self {
            centre: centre.coordinates().into(),
            radius,
            corners: [-half, half],
        }
    }

    /// A place in the coordinates of the picture, in which the ball has radius 1 and the origin as
    /// its centre.
    pub(crate) fn place(&self, point: Point<f64>) -> Vector<f64> {
        (Vector::from(point) - Vector::from(self.centre)) / self.radius
    }
}

/// A box with edges parallel to the axes.
#[derive(Clone, Copy)]
struct Bounds {
    low: Vector<f64>,
    high: Vector<f64>,
}

impl Default for Bounds {
    fn default() -> Self {
        Self {
            low: Vector::from([f64::INFINITY; 3]),
            high: Vector::from([f64::NEG_INFINITY; 3]),
        }
    }
}

impl Bounds {
    fn hold(&mut self, point: Vector<f64>) {
        (self.low, self.high) = (self.low.min(point), self.high.max(point));
    }

    fn hold_about(&mut self, centre: Vector<f64>, extent: Vector<f64>) {
        self.hold(centre - extent);
        self.hold(centre + extent);
    }

    /// The centre of the box, or the origin for an empty box.
    fn middle(&self) -> Vector<f64> {
        if self.low.e1 > self.high.e1 {
            return Vector::default();
        }
        (self.low + self.high) * 0.5
    }
}

/// Extends the bounds to the parts of a shape that are finite.
fn finite(shape: &Shape, bounds: &mut Bounds) {
    match shape {
        Shape::Point { at }
        | Shape::FlatPoint { at }
        | Shape::TangentVector { at, .. }
        | Shape::TangentBivector { at, .. } => bounds.hold(Vector::from(*at)),
        Shape::PointPair {
            centre,
            direction,
            radius,
            ..
        } => bounds.hold_about(Vector::from(*centre), direction.abs() * *radius),
        Shape::Circle {
            centre,
            normal,
            radius,
            ..
        } => {
            // Along each axis a circle extends by the radius times the sine of the angle between
            // the axis and the normal.
            let sine = |n: f64| (1.0 - n * n).max(0.0).sqrt();
            let reach = Vector::from(normal.coordinates().map(sine)) * *radius;
            bounds.hold_about(Vector::from(*centre), reach);
        }
        Shape::Sphere { centre, radius, .. } => {
            bounds.hold_about(Vector::from(*centre), Vector::from([*radius; 3]))
        }
        Shape::Line { .. } | Shape::Plane { .. } => {}
        Shape::Direction { vector } => {
            bounds.hold(Vector::default());
            bounds.hold(*vector);
        }
        Shape::Frame { origin, .. } => bounds.hold(Vector::from(*origin)),
        Shape::Trajectory { points, frames } => {
            for point in points.iter().chain(frames.iter().map(|(origin, _)| origin)) {
                bounds.hold(Vector::from(*point));
            }
        }
    }
}
