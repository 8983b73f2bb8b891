//! Distances between any two primitives.
//!
//! `a.distance_to(b)` is the least distance of a point of a from a point of b, zero where they
//! meet; `b.distance_to(a)` is the same. Spheres are surfaces here: a point inside is at a distance
//! from the sphere.
//!
//! | | point | line | plane | sphere, centre c, radius r | circle |
//! | --- | --- | --- | --- | --- | --- |
//! | point | `√(−2 P·Q)` | to its foot | height `h` | `∣∣p − c∣ − r∣` | `√((ρ − r)² + h²)` |
//! | line | | common perpendicular | zero unless parallel | `max(d − r, 0)` | least over the circle |
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
//! | pair | sign |
//! | --- | --- |
//! | plane and point, pair, parallel line, circle | positive on the side of the normal, zero where the plane is met or crossed |
//! | plane a and parallel plane b | where b lies along the normal of a |
//! | sphere and point, pair, line, plane, circle | negative as far as it reaches into the ball: least distance from the centre less r |
//! | sphere and sphere | `d − r − s`, negative where the balls overlap |
//! | all others | none, as [`distance_to`](crate::cga3::Line::distance_to) |
//!
//! In blades, for `x·X` with a dual plane n + d ei of unit normal and with a dual sphere σ = c −
//! ½r² ei: `P·π = n·p − d` and `P·σ = ½(r² − ∣p − c∣²)`.
//!
//! `None` where one of the two is no [`Figure`]: weight zero, imaginary, not finite.
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
use super::{Figure, Primitive, parallel};
use crate::cga3::{
    Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint, Line,
    MotorGenerator, Plane, Point, PointPair, Sphere,
};
use crate::geometry::vector3::{cross, difference, dot, length, scaled};
use crate::scalar::Real;

macro_rules! distances {
    ($($Primitive:ident)*) => {$(
        impl<S: Real<Mask = bool>> $Primitive<S> {
            /// The least distance from the other primitive, in the units of the coordinates, zero
            /// where they meet; see [`distance`](crate::geometry::relation::distance) for all
            /// pairs. `None` where either is no figure or the distance is beyond the range of the
            /// scalar.
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
    let zero = S::zero();
    let found = match (a, b) {
        (Figure::PointPair([p, q]), x) | (x, Figure::PointPair([p, q])) => {
            let [p, q] = [Figure::Point(p), Figure::Point(q)];
            distance(p, x)?.min(distance(q, x)?)
        }
        (Figure::Sphere { centre, radius }, x) | (x, Figure::Sphere { centre, radius }) => {
            let [least, most] = from_sphere(x, centre)?;
            let outside = (least - radius).max(zero);
            // What is unbounded reaches out of every sphere.
            let inside = if most.is_finite() {
                radius - most
            } else {
                zero
            };
            outside.max(inside)
        }
        (Figure::Plane { normal, distance }, x) | (x, Figure::Plane { normal, distance }) => {
            gap(heights(x, normal, distance)).abs()
        }
        (Figure::Point(p), Figure::Point(q)) => length(difference(p, q)),
        (Figure::Point(p), Figure::Line { point, direction })
        | (Figure::Line { point, direction }, Figure::Point(p)) => {
            length(across(difference(p, point), direction))
        }
        (
            Figure::Point(p),
            Figure::Circle {
                centre,
                normal,
                radius,
            },
        )
        | (
            Figure::Circle {
                centre,
                normal,
                radius,
            },
            Figure::Point(p),
        ) => {
            let from = difference(p, centre);
            let reach = length(across(from, normal));
            length([reach - radius, dot(from, normal), zero])
        }
        (
            Figure::Line {
                point: p,
                direction: d,
            },
            Figure::Line {
                point: q,
                direction: e,
            },
        ) => {
            let between = difference(q, p);
            let normal = cross(d, e);
            let sine = length(normal);
            if sine.less_than(parallel()) {
                length(across(between, d))
            } else {
                (dot(between, normal) / sine).abs()
            }
        }
        (
            Figure::Line { point, direction },
            Figure::Circle {
                centre,
                normal,
                radius,
            },
        )
        | (
            Figure::Circle {
                centre,
                normal,
                radius,
            },
            Figure::Line { point, direction },
        ) => {
            let from = across(difference(centre, point), direction);
            line_to_circle(direction, from, normal, radius)
        }
        (
            Figure::Circle {
                centre,
                normal,
                radius,
            },
            Figure::Circle {
                centre: c,
                normal: m,
                radius: r,
            },
        ) => {
            let from = difference(c, centre);
            // Along the smaller circle the other one looks smooth.
            if r.less_than(radius) {
                circle_to_circle(from, m, r, normal, radius)
            } else {
                circle_to_circle(from.map(|x| -x), normal, radius, m, r)
            }
        }
    };
    found.is_finite().then_some(found)
}

fn signed_distance<S: Real<Mask = bool>>(a: Figure<S>, b: Figure<S>) -> Option<S> {
    let found = match (a, b) {
        (
            Figure::Sphere {
                centre: p,
                radius: r,
            },
            Figure::Sphere {
                centre: q,
                radius: s,
            },
        ) => length(difference(p, q)) - r - s,
        (Figure::Sphere { centre, radius }, x) | (x, Figure::Sphere { centre, radius }) => {
            from_sphere(x, centre)?[0] - radius
        }
        (Figure::Plane { normal, distance }, x) | (x, Figure::Plane { normal, distance }) => {
            gap(heights(x, normal, distance))
        }
        _ => return distance(a, b),
    };
    found.is_finite().then_some(found)
}

/// The part of a vector across a unit direction.
pub(super) fn across<S: Real>(v: [S; 3], unit: [S; 3]) -> [S; 3] {
    difference(v, scaled(unit, dot(v, unit)))
}

/// The least and the greatest distance of a figure's points from the centre of a sphere, or from a
/// sphere's surface negative within it; the greatest is infinite for what is unbounded.
pub(super) fn from_sphere<S: Real<Mask = bool>>(
    figure: Figure<S>,
    centre: [S; 3],
) -> Option<[S; 2]> {
    let zero = S::zero();
    Some(match figure {
        Figure::Point(p) => [length(difference(p, centre)); 2],
        Figure::PointPair([p, q]) => {
            let [p, q] = [p, q].map(|p| length(difference(p, centre)));
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
            let from = difference(centre, c);
            let (height, reach) = (dot(from, normal), length(across(from, normal)));
            [
                length([reach - radius, height, zero]),
                length([reach + radius, height, zero]),
            ]
        }
        Figure::Sphere { centre: c, radius } => {
            let between = length(difference(centre, c));
            let least = (between - radius).max(radius - between);
            [least, between + radius]
        }
    })
}

/// The least and the greatest height of a figure's points above a plane.
fn heights<S: Real<Mask = bool>>(figure: Figure<S>, normal: [S; 3], distance: S) -> [S; 2] {
    let height = |p| dot(p, normal) - distance;
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
            if dot(direction, normal).abs().less_than(parallel()) {
                [height(point); 2]
            } else {
                everywhere
            }
        }
        Figure::Plane {
            normal: m,
            distance,
        } => {
            if length(cross(normal, m)).less_than(parallel()) {
                [height(scaled(m, distance)); 2]
            } else {
                everywhere
            }
        }
        Figure::Circle {
            centre,
            normal: m,
            radius,
        } => around(height(centre), length(cross(normal, m)) * radius),
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
