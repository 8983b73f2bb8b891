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
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

macro_rules! distances {
    ($($Primitive:ident)*) => {$(
        impl<S: Real> $Primitive<S> {
            /// The least distance to the other primitive, in the units of the coordinates, zero
            /// where they meet; see [`distance`](crate::geometry::relation::distance) for all
            /// pairs. `None` where either is not a figure or the distance is beyond the range of
            /// the scalar.
            #[inline]
            #[must_use]
            pub fn distance_to<T: Primitive<S>>(self, other: T) -> Maybe<S, S>
            where
                Self: Primitive<S>,
            {
                Primitive::distance_from(self, other)
            }

            /// The distance with a sign where one of the two has sides: positive on the side of a
            /// plane's normal, negative inside a sphere; see
            /// [`distance`](crate::geometry::relation::distance) for all pairs. `None` as for
            /// [`distance_to`](Self::distance_to).
            #[inline]
            #[must_use]
            pub fn signed_distance_to<T: Primitive<S>>(self, other: T) -> Maybe<S, S>
            where
                Self: Primitive<S>,
            {
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

/// How the least distance of two figures is found that no formula gives: those of a circle from a
/// line and from another circle.
pub(super) type Search<S> = fn(Figure<S>, Figure<S>) -> Maybe<S, S>;

pub(super) fn distance<S: Real>(a: Figure<S>, b: Figure<S>, search: Search<S>) -> Maybe<S, S> {
    use Figure::{Circle, Line, Plane, Point, PointPair, Sphere};
    let always = S::Mask::splat(true);
    match (a, b) {
        (PointPair([p, q]), x) | (x, PointPair([p, q])) => {
            let both = from_place(x, p).zip(from_place(x, q));
            both.map(|(to_p, to_q)| to_p.min(to_q))
        }
        (Sphere { centre, radius }, x) | (x, Sphere { centre, radius }) => {
            from_sphere(x, centre).map(|between| from_surface(between, radius))
        }
        (Plane { normal, distance }, x) | (x, Plane { normal, distance }) => {
            always.when(height(x, normal, distance).abs())
        }
        (Point(p), x) | (x, Point(p)) => from_place(x, p),
        (
            Line { point, direction },
            Line {
                point: q,
                direction: e,
            },
        ) => always.when(line_to_line([point, direction], [q, e])),
        (Line { .. } | Circle { .. }, Circle { .. }) | (Circle { .. }, Line { .. }) => search(a, b),
    }
    .filter(|distance| distance.is_finite())
}

fn finite<S: Real>(x: S) -> Maybe<S, S> {
    x.is_finite().when(x)
}

/// The least distance of a figure from a place.
pub(super) fn from_place<S: Real>(figure: Figure<S>, place: Vector<S>) -> Maybe<S, S> {
    finite(match figure {
        Figure::Point(p) => p.distance(place),
        Figure::PointPair(pair) => {
            let [to_p, to_q] = pair.map(|p| finite(p.distance(place)));
            return to_p.zip(to_q).map(|(to_p, to_q)| to_p.min(to_q));
        }
        Figure::Line { point, direction } => (place - point).across(direction).length(),
        Figure::Plane { normal, distance } => (place.dot(normal) - distance).abs(),
        Figure::Circle {
            centre,
            normal,
            radius,
        } => from_circle(place - centre, normal, radius)[0],
        Figure::Sphere { centre, radius } => (place.distance(centre) - radius).abs(),
    })
}

/// The [`Search`] for single numbers.
pub(super) fn searched<S: Real<Mask = bool>>(a: Figure<S>, b: Figure<S>) -> Option<S> {
    use Figure::{Circle, Line};
    match (a, b) {
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
            Some(line_to_circle(direction, from, normal, radius))
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
            Some(if r.less_than(radius) {
                circle_to_circle(from, m, r, normal, radius)
            } else {
                circle_to_circle(-from, normal, radius, m, r)
            })
        }
        _ => None,
    }
}

/// The distance between two lines, each given by a point and its unit direction.
fn line_to_line<S: Real>([p, d]: [Vector<S>; 2], [q, e]: [Vector<S>; 2]) -> S {
    let between = q - p;
    let normal = d.cross(e);
    let sine = normal.length();
    let parallel = sine
        .less_than(parallel())
        .when(())
        .map(|()| between.across(d).length());
    parallel.unwrap_or((between.dot(normal) / sine).abs())
}

/// The least distance from the surface of a sphere, for points whose distance from its centre is
/// between two bounds.
fn from_surface<S: Real>([least, most]: [S; 2], radius: S) -> S {
    let zero = S::zero();
    let outside = (least - radius).max(zero);
    // Unbounded figures extend beyond every sphere.
    let inside = S::select(most.is_finite(), radius - most, zero);
    outside.max(inside)
}

pub(super) fn signed_distance<S: Real>(
    a: Figure<S>,
    b: Figure<S>,
    search: Search<S>,
) -> Maybe<S, S> {
    use Figure::{Plane, Sphere};
    match (a, b) {
        (
            Sphere { centre, radius },
            Sphere {
                centre: c,
                radius: r,
            },
        ) => finite(centre.distance(c) - radius - r),
        (Sphere { centre, radius }, x) | (x, Sphere { centre, radius }) => {
            let from_centre = from_sphere(x, centre);
            from_centre.and_then(|[least, _]| finite(least - radius))
        }
        (Plane { normal, distance }, x) | (x, Plane { normal, distance }) => {
            finite(height(x, normal, distance))
        }
        _ => distance(a, b, search),
    }
}

/// The least and the greatest distance of a figure's points from the centre of a sphere, or from
/// its surface, negative inside it; the greatest is infinite for unbounded figures.
pub(super) fn from_sphere<S: Real>(figure: Figure<S>, centre: Vector<S>) -> Maybe<[S; 2], S> {
    let always = S::Mask::splat(true);
    match figure {
        Figure::Point(p) => always.when([(p - centre).length(); 2]),
        Figure::PointPair([p, q]) => {
            let [p, q] = [p, q].map(|p| (p - centre).length());
            always.when([p.min(q), p.max(q)])
        }
        Figure::Line { .. } | Figure::Plane { .. } => {
            from_place(figure, centre).map(|least| [least, S::one() / S::zero()])
        }
        Figure::Circle {
            centre: c,
            normal,
            radius,
        } => always.when(from_circle(centre - c, normal, radius)),
        Figure::Sphere { centre: c, radius } => {
            let between = (centre - c).length();
            let least = (between - radius).max(radius - between);
            always.when([least, between + radius])
        }
    }
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

/// The height of a figure's point that is nearest to a plane, zero where it meets the plane.
// Outlined, since within its caller lengths would be calls.
#[inline(never)]
fn height<S: Real>(figure: Figure<S>, normal: Vector<S>, distance: S) -> S {
    let height = |p: Vector<S>| p.dot(normal) - distance;
    // All heights occur where a direction is not parallel to the plane.
    let parallel = |sine: S| sine.less_than(parallel()).when(());
    let around = |middle: S, reach: S| gap([middle - reach, middle + reach]);
    match figure {
        Figure::Point(p) => height(p),
        Figure::PointPair([p, q]) => {
            let [p, q] = [p, q].map(height);
            gap([p.min(q), p.max(q)])
        }
        Figure::Line { point, direction } => parallel(direction.dot(normal).abs())
            .map(|()| height(point))
            .unwrap_or(S::zero()),
        Figure::Plane {
            normal: m,
            distance,
        } => parallel(normal.cross(m).length())
            .map(|()| height(m * distance))
            .unwrap_or(S::zero()),
        Figure::Circle {
            centre,
            normal: m,
            radius,
        } => around(height(centre), normal.cross(m).length() * radius),
        Figure::Sphere { centre, radius } => around(height(centre), radius),
    }
}

/// The number nearest to zero in an interval.
fn gap<S: Real>([least, most]: [S; 2]) -> S {
    let zero = S::zero();
    let around_zero = S::select(most.less_than(zero), most, (least + most) * zero);
    S::select(zero.less_than(least), least, around_zero)
}
