//! Distances between any two primitives.
//!
//! `a.distance_to(b)` is the least distance of a point of a from a point of b, zero where they
//! meet; `b.distance_to(a)` is the same. Spheres are surfaces here: a point inside is at a distance
//! from the sphere.
//!
//! | | point | line | plane | sphere, centre c, radius r | circle |
//! | --- | --- | --- | --- | --- | --- |
//! | point | `√(−2 P·Q)` | to its foot | height `h` | `∣∣p − c∣ − r∣` | `√((ρ − r)² + h²)` |
//! | line | | common perpendicular | zero unless parallel | `max(d − r, 0)` | least over it |
//! | plane | | | zero unless parallel | `max(∣h∣ − r, 0)` | `max(∣h∣ − r sin θ, 0)` |
//! | sphere | | | | `max(d − r − s, ∣r − s∣ − d, 0)` | by its nearest and farthest point from c |
//! | circle | | | | | least over one of them |
//!
//! A pair counts as its two points. The stationary points of the distance from a line to a circle
//! are roots of a quartic, those from circle to circle of a polynomial of degree 8 (Vranek, Journal
//! of Graphics Tools 7 (2002); Eberly, Distance to Circles in 3D); the least one is found by
//! halving under a proven bound instead, to the accuracy of the scalar. Directions whose sine is
//! below 16 ε count as parallel.
//!
//! `a.signed_distance_to(b)` has a sign where there is a side to tell:
//!
//! - plane and point, pair, parallel line, circle: positive on the side of the normal, zero where
//!   the plane is met or crossed.
//! - plane a and parallel plane b: where b lies along the normal of a.
//! - sphere and point, pair, line, plane, circle: negative as far as it reaches into the ball:
//!   least distance from the centre less r.
//! - sphere and sphere: `d − r − s`, negative where the balls overlap.
//! - all others: none, as [`distance_to`](crate::cga3::Line::distance_to).
//!
//! In blades, for `x·X` with a dual plane n + d ei of unit normal and with a dual sphere σ = c −
//! ½r² ei: `P·π = n·p − d` and `P·σ = ½(r² − ∣p − c∣²)`.
//!
//! `None` where one of the two is not a [`Figure`]: weight zero, imaginary, not finite.
//!
//! ```
//! use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
//!
//! let sphere = Sphere::from_centre_radius(Point::new(0.0, 0.0, 3.0), 2.0);
//! let ground =
//!     Plane::through(Point::default(), Point::new(1.0, 0.0, 0.0), Point::new(0.0, 1.0, 0.0));
//! assert_eq!(sphere.distance_to(ground), Some(1.0));
//! assert_eq!(Point::new(0.0, 0.0, 2.5).distance_to(sphere), Some(1.5));
//! assert_eq!(Point::new(0.0, 0.0, 2.5).signed_distance_to(sphere), Some(-1.5));
//!
//! let axis = Line::through(Point::default(), Point::new(0.0, 0.0, 1.0));
//! let ring = Circle::from_centre_normal_radius(Point::default(), [0.0, 0.0, 1.0], 2.0).unwrap();
//! assert!((axis.distance_to(ring).unwrap() - 2.0_f64).abs() < 1e-15);
//! ```

use super::least::{circle_to_circle, line_to_circle};
use super::{Figure, Primitive, hypotenuse, parallel};
use crate::cga3::{
    Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint, Line,
    MotorGenerator, Plane, Point, PointPair, Sphere,
};
use crate::scalar::Real;
use crate::vga3::Vector;

macro_rules! distances {
    ($($Primitive:ident)*) => {$(
        impl<S: Real<Mask = bool>> $Primitive<S> {
            /// The least distance from the other primitive, in the units of the coordinates, zero
            /// where they meet; see [`distance`](crate::geometry::relation::distance) for all
            /// pairs. `None` where either is not a figure or the distance is beyond the range of
            /// the scalar.
            #[must_use]
            pub fn distance_to<T: Primitive<S>>(self, other: T) -> Option<S> {
                distance(self.figure()?, other.figure()?)
            }

            /// The distance with a sign where there is a side to tell: planes by their normal,
            /// spheres negative inside; see [`distance`](crate::geometry::relation::distance) for
            /// all pairs. `None` as for [`distance_to`](Self::distance_to).
            #[must_use]
            pub fn signed_distance_to<T: Primitive<S>>(self, other: T) -> Option<S> {
                signed_distance(self.figure()?, other.figure()?)
            }
        }
    )*};
}

distances! {
    Point FlatPoint PointPair Line Plane Circle Sphere
    DualFlatPoint DualPointPair MotorGenerator DualPlane DualCircle DualSphere
}

pub(super) fn distance<S: Real<Mask = bool>>(a: Figure<S>, b: Figure<S>) -> Option<S> {
    use Figure::{Circle, Line, Plane, Point, PointPair, Sphere};
    let found = match (a, b) {
        (PointPair([p, q]), x) | (x, PointPair([p, q])) => {
            distance(Point(p), x)?.min(distance(Point(q), x)?)
        }
        (Sphere { centre, radius }, x) | (x, Sphere { centre, radius }) => {
            from_surface(from_sphere(x, centre)?, radius)
        }
        (Plane { normal, distance }, x) | (x, Plane { normal, distance }) => {
            gap(heights(x, normal, distance)).abs()
        }
        (Point(p), Point(q)) => p.distance(q),
        (Point(p), Line { point, direction }) | (Line { point, direction }, Point(p)) => {
            (p - point).across(direction).length()
        }
        (Point(p), circle @ Circle { .. }) | (circle @ Circle { .. }, Point(p)) => {
            from_sphere(circle, p)?[0]
        }
        (
            Line { point, direction },
            Line {
                point: q,
                direction: e,
            },
        ) => line_to_line([point, direction], [q, e]),
        (
            Line { point, direction },
            Circle {
                centre,
                normal,
                radius,
            },
        )
        | (
            Circle {
                centre,
                normal,
                radius,
            },
            Line { point, direction },
        ) => {
            let from = (centre - point).across(direction);
            line_to_circle(direction, from, normal, radius)
        }
        (
            Circle {
                centre,
                normal,
                radius,
            },
            Circle {
                centre: c,
                normal: m,
                radius: r,
            },
        ) => {
            let from = c - centre;
            // Along the smaller circle the other one looks smooth.
            if r.less_than(radius) {
                circle_to_circle(from, m, r, normal, radius)
            } else {
                circle_to_circle(-from, normal, radius, m, r)
            }
        }
    };
    found.is_finite().then_some(found)
}

/// The distance of two lines, each by a point and its unit direction.
fn line_to_line<S: Real<Mask = bool>>([p, d]: [Vector<S>; 2], [q, e]: [Vector<S>; 2]) -> S {
    let between = q - p;
    let normal = d.cross(e);
    let sine = normal.length();
    if sine.less_than(parallel()) {
        between.across(d).length()
    } else {
        (between.dot(normal) / sine).abs()
    }
}

/// The least distance from the surface of a sphere, for points that are between two distances from
/// its centre.
fn from_surface<S: Real<Mask = bool>>([least, most]: [S; 2], radius: S) -> S {
    let zero = S::zero();
    let outside = (least - radius).max(zero);
    // What is unbounded reaches out of every sphere.
    let inside = if most.is_finite() {
        radius - most
    } else {
        zero
    };
    outside.max(inside)
}

fn signed_distance<S: Real<Mask = bool>>(a: Figure<S>, b: Figure<S>) -> Option<S> {
    use Figure::{Plane, Sphere};
    let found = match (a, b) {
        (
            Sphere { centre, radius },
            Sphere {
                centre: c,
                radius: r,
            },
        ) => centre.distance(c) - radius - r,
        (Sphere { centre, radius }, x) | (x, Sphere { centre, radius }) => {
            from_sphere(x, centre)?[0] - radius
        }
        (Plane { normal, distance }, x) | (x, Plane { normal, distance }) => {
            gap(heights(x, normal, distance))
        }
        _ => return distance(a, b),
    };
    found.is_finite().then_some(found)
}

/// The least and the greatest distance of a figure's points from the centre of a sphere, or from a
/// sphere's surface negative within it; the greatest is infinite for what is unbounded.
pub(super) fn from_sphere<S: Real<Mask = bool>>(
    figure: Figure<S>,
    centre: Vector<S>,
) -> Option<[S; 2]> {
    let zero = S::zero();
    Some(match figure {
        Figure::Point(p) => [(p - centre).length(); 2],
        Figure::PointPair([p, q]) => {
            let [p, q] = [p, q].map(|p| (p - centre).length());
            [p.min(q), p.max(q)]
        }
        Figure::Line { .. } | Figure::Plane { .. } => {
            let least = distance(Figure::Point(centre), figure)?;
            [least, S::one() / zero]
        }
        Figure::Circle {
            centre: c,
            normal,
            radius,
        } => {
            let from = centre - c;
            let (height, reach) = (from.dot(normal), from.across(normal).length());
            [
                hypotenuse(reach - radius, height),
                hypotenuse(reach + radius, height),
            ]
        }
        Figure::Sphere { centre: c, radius } => {
            let between = (centre - c).length();
            let least = (between - radius).max(radius - between);
            [least, between + radius]
        }
    })
}

/// The least and the greatest height of a figure's points above a plane.
fn heights<S: Real<Mask = bool>>(figure: Figure<S>, normal: Vector<S>, distance: S) -> [S; 2] {
    let height = |p: Vector<S>| p.dot(normal) - distance;
    // All heights occur where a direction leaves the plane.
    let everywhere = [-S::one(), S::one()];
    let around = |middle: S, reach: S| [middle - reach, middle + reach];
    match figure {
        Figure::Point(p) => [height(p); 2],
        Figure::PointPair([p, q]) => {
            let [p, q] = [p, q].map(height);
            [p.min(q), p.max(q)]
        }
        Figure::Line { point, direction } => {
            if direction.dot(normal).abs().less_than(parallel()) {
                [height(point); 2]
            } else {
                everywhere
            }
        }
        Figure::Plane {
            normal: m,
            distance,
        } => {
            if normal.cross(m).length().less_than(parallel()) {
                [height(m * distance); 2]
            } else {
                everywhere
            }
        }
        Figure::Circle {
            centre,
            normal: m,
            radius,
        } => around(height(centre), normal.cross(m).length() * radius),
        Figure::Sphere { centre, radius } => around(height(centre), radius),
    }
}

/// The number nearest to zero between two.
fn gap<S: Real<Mask = bool>>([least, most]: [S; 2]) -> S {
    if S::zero().less_than(least) {
        least
    } else if most.less_than(S::zero()) {
        most
    } else {
        (least + most) * S::zero()
    }
}
