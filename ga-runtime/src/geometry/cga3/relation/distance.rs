//! Distances between any two primitives.
//!
//! `a.distance_to(b)` is the least distance between a point of a and a point of b, zero where they
//! meet; `b.distance_to(a)` is the same. Spheres are surfaces here: a point inside a sphere has a
//! positive distance from it.
//!
//! - Point p to point q: `√(−2 P·Q) = ∣p − q∣`.
//! - Point to line: the distance to its foot. Point to plane: the height `∣h∣`.
//! - Point p to sphere with centre c and radius r: `∣∣p − c∣ − r∣`.
//! - Point to circle of radius r: `√((ρ − r)² + h²)`, with h the height above the plane of the
//!   circle and ρ the distance from its axis.
//! - Line to line: the length of the common perpendicular. Line to plane, plane to plane: zero
//!   unless they are parallel.
//! - Line to sphere: `max(d − r, 0)`, with d the distance of the centre.
//! - Line to circle, circle to circle: the least value along one circle.
//! - Plane to sphere: `max(∣h∣ − r, 0)`, with h the height of the centre.
//! - Plane to circle: `max(∣h∣ − r sin θ, 0)`, with θ the angle between the planes.
//! - Sphere to sphere with radii r and s: `max(d − r − s, ∣r − s∣ − d, 0)`, with d the distance of
//!   the centres.
//! - Sphere to circle: from the nearest and the farthest point of the circle from the centre.
//!
//! A point pair is treated as its two points. The stationary points of the distance from a line to
//! a circle are roots of a quartic, those from circle to circle of a polynomial of degree 8
//! (Vranek, Journal of Graphics Tools 7 (2002); Eberly, Distance to Circles in 3D); here the least
//! distance is found by bisection under a proven bound instead, to the accuracy of the scalar.
//! Directions whose angle has a sine below 16 ε are treated as parallel.
//!
//! `a.signed_distance_to(b)` has a sign where one of the two has sides:
//!
//! - Plane and point, point pair, parallel line or circle: positive on the side of the normal, zero
//!   where they meet.
//! - Plane a and parallel plane b: positive where b lies on the side of the normal of a.
//! - Sphere and point, point pair, line, plane or circle: the least distance from the centre minus
//!   r, so negative where it enters the ball.
//! - Sphere and sphere: `d − r − s`, negative where the balls overlap.
//! - All others: no sign, as [`distance_to`](crate::cga3::Line::distance_to).
//!
//! In blades, a point P has the inner product `P·π = n·p − d` with the dual plane `π = n + d ei` of
//! unit normal n, and `P·σ = ½(r² − ∣p − c∣²)` with the dual sphere `σ = c − ½r² ei`.
//!
//! The result is `None` where one of the two is not a [`Figure`]: where its weight is zero, it is
//! imaginary, or it is not finite.
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
use super::{Figure, FromPoint, Primitive, hypotenuse, parallel};
use crate::cga3::{
    Bivector, Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint,
    Line, MotorGenerator, Plane, Point, PointPair, Quadvector, Sphere, Trivector,
};
use crate::scalar::{Maybe, Real};
use crate::vga3::Vector;

macro_rules! distances {
    ($($Primitive:ident)*) => {$(
        impl<S: Real<Mask = bool>> $Primitive<S> {
            /// The least distance to the other primitive, in the units of the coordinates, zero
            /// where they meet; see [`distance`](crate::geometry::relation::distance) for all
            /// pairs. `None` where either is not a figure or the distance is beyond the range of
            /// the scalar.
            #[inline]
            #[must_use]
            pub fn distance_to<T: Primitive<S>>(self, other: T) -> Option<S> {
                Primitive::distance_from(self, other)
            }

            /// The distance with a sign where one of the two has sides: positive on the side of a
            /// plane's normal, negative inside a sphere; see
            /// [`distance`](crate::geometry::relation::distance) for all pairs. `None` as for
            /// [`distance_to`](Self::distance_to).
            #[inline]
            #[must_use]
            pub fn signed_distance_to<T: Primitive<S>>(self, other: T) -> Option<S> {
                Primitive::signed_distance_from(self, other)
            }
        }
    )*};
}

distances! {
    FlatPoint PointPair Line Plane Circle Sphere Bivector Trivector Quadvector
    DualFlatPoint DualPointPair MotorGenerator DualPlane DualCircle DualSphere
}

impl<S: Real> Point<S> {
    /// The least distance to the other primitive, in the units of the coordinates, zero where they
    /// meet; see [`distance`](crate::geometry::relation::distance) for all pairs. `None` where
    /// either is not a figure or the distance is beyond the range of the scalar.
    #[inline]
    #[must_use]
    pub fn distance_to<T: FromPoint<S>>(self, other: T) -> Maybe<S, S> {
        other.distance_from_point(self.into())
    }

    /// The distance with a sign where the other has sides: positive on the side of a plane's
    /// normal, negative inside a sphere. `None` as for [`distance_to`](Self::distance_to).
    #[inline]
    #[must_use]
    pub fn signed_distance_to<T: FromPoint<S>>(self, other: T) -> Maybe<S, S> {
        other.signed_distance_from_point(self.into())
    }
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
            // Along the smaller circle the distance from the other one varies slowly.
            if r.less_than(radius) {
                circle_to_circle(from, m, r, normal, radius)
            } else {
                circle_to_circle(-from, normal, radius, m, r)
            }
        }
    };
    found.is_finite().then_some(found)
}

/// The distance between two lines, each given by a point and its unit direction.
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

/// The least distance from the surface of a sphere, for points whose distance from its centre is
/// between two bounds.
fn from_surface<S: Real<Mask = bool>>([least, most]: [S; 2], radius: S) -> S {
    let zero = S::zero();
    let outside = (least - radius).max(zero);
    // Unbounded figures extend beyond every sphere.
    let inside = if most.is_finite() {
        radius - most
    } else {
        zero
    };
    outside.max(inside)
}

pub(super) fn signed_distance<S: Real<Mask = bool>>(a: Figure<S>, b: Figure<S>) -> Option<S> {
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

/// The least and the greatest distance of a figure's points from the centre of a sphere, or from
/// its surface, negative inside it; the greatest is infinite for unbounded figures.
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
        } => from_circle(centre - c, normal, radius),
        Figure::Sphere { centre: c, radius } => {
            let between = (centre - c).length();
            let least = (between - radius).max(radius - between);
            [least, between + radius]
        }
    })
}

/// The least and the greatest distance of the points of a circle from a place, which is given from
/// the centre.
pub(super) fn from_circle<S: Real>(place: Vector<S>, normal: Vector<S>, radius: S) -> [S; 2] {
    let (height, reach) = (place.dot(normal), place.across(normal).length());
    [
        hypotenuse(reach - radius, height),
        hypotenuse(reach + radius, height),
    ]
}

/// The least and the greatest height of a figure's points above a plane.
fn heights<S: Real<Mask = bool>>(figure: Figure<S>, normal: Vector<S>, distance: S) -> [S; 2] {
    let height = |p: Vector<S>| p.dot(normal) - distance;
    // All heights occur where a direction is not parallel to the plane.
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

/// The number nearest to zero in an interval.
fn gap<S: Real<Mask = bool>>([least, most]: [S; 2]) -> S {
    if S::zero().less_than(least) {
        least
    } else if most.less_than(S::zero()) {
        most
    } else {
        (least + most) * S::zero()
    }
}
