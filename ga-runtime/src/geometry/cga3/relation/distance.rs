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
//! The result is `None` where one of the two is not a [`Figure`](super::Figure): where its weight
//! is zero, it is imaginary, or it is not finite.
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

use super::{FromPoint, Primitive};
use crate::cga3::{
    Bivector, Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint,
    Line, MotorGenerator, Plane, Point, PointPair, Quadvector, Sphere, Trivector,
};
use crate::scalar::{Maybe, Real};

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
