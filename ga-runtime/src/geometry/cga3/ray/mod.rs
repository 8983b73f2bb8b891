//! Rays: half lines, and the first point at which they hit a surface.
//!
//! A ray begins at a point o and runs in a direction d of length 1. It is the part of the line
//! `o∧d∧ei` with the points `o + t d` for distances `t ≥ 0`. [`Ray::first_hit`] finds the nearest
//! of them on a surface, for distances `t > 0`:
//!
//! | surface | type | its front |
//! | --- | --- | --- |
//! | sphere | `Sphere`, `DualSphere` | the outside |
//! | plane | `Plane`, `DualPlane` | the side of its normal |
//! | disc, a circle with its inside | `Circle`, `DualCircle` | the side of its normal |
//! | triangle | `[Point; 3]`, its corners | where they are in counterclockwise order |
//! | any of these | [`Figure`](super::relation::Figure) | as above |
//!
//! A [`Hit`] has the distance, the point, the unit normal on the side from which the ray comes, and
//! which side that is. Weights and their signs do not matter, except that a plane or circle of
//! negative weight has the opposite normal.
//!
//! # What is a hit
//!
//! - A ray that only touches a sphere hits it there. A sphere of radius zero, an imaginary sphere
//!   and a figure without a surface are never hit.
//! - A ray that begins inside a sphere hits it from the back, where it leaves.
//! - A ray that begins on a surface does not hit it at its origin. After rounding, a point on a
//!   surface may lie on either side of it: let a ray that leaves a surface begin a little further
//!   on, with [`Ray::advance`].
//! - A ray parallel to a plane does not hit it, even where it runs within the plane.
//! - Triangles that share an edge have no gap: a ray through the edge hits at least one of them (S.
//!   Woop, C. Benthin and I. Wald, Watertight Ray/Triangle Intersection, JCGT 2, 2013). A
//!   degenerate triangle is never hit.
//! - A surface with a coefficient that is not finite, and a distance whose square is beyond the
//!   range of the scalar, count as a miss. No result is NaN.
//!
//! # Accuracy
//!
//! Positions are first subtracted from the origin of the ray, so that hits near it are accurate
//! far from the origin of the coordinates, and the squared radius is compared with the squared
//! distance of the line from the centre, which loses little for small spheres far away. A sphere
//! and a circle store their squared radius, so that it is as accurate far from the origin of the
//! coordinates as near it.
//!
//! # Many rays
//!
//! All of this is also for several rays in [`Lanes`](crate::scalar::Lanes), except that a
//! [`Figure`](super::relation::Figure) is a surface for single rays only. A hit is a
//! [`Maybe`](crate::scalar::Maybe), and the nearer of two is chosen by a mask:
//!
//! ```
//! use ga_runtime::cga3::{Plane, Point, Sphere};
//! use ga_runtime::geometry::ray::{Hit, Ray};
//! use ga_runtime::scalar::{Lanes, Optional, Real, Select};
//!
//! fn nearer<S: Real>((a, b): (Hit<S>, Hit<S>)) -> Hit<S> {
//!     Hit::select(a.distance.less_than(b.distance), a, b)
//! }
//!
//! let all = |x: f64| Lanes::splat(x);
//! let place = |x| Point::from([all(0.0), all(0.0), all(x)]);
//! let ball = Sphere::from_centre_radius(place(0.0), all(1.0));
//! let floor = Plane::from_point_normal(place(-3.0), [0.0, 0.0, 1.0].map(all));
//!
//! // Straight down from three places; to the side from a fourth.
//! let origin = Point::new(Lanes::from_array([0.0, 1.0, 2.0, 2.0]), all(0.0), all(5.0));
//! let down = Lanes::from_array([-2.0, -2.0, -2.0, 0.0]);
//! let rays = Ray::new(origin, [all(1.0) + down * all(0.5), all(0.0), down]);
//!
//! let ball = rays.and_then(|ray| ray.first_hit(ball));
//! let floor = rays.and_then(|ray| ray.first_hit(floor));
//! let first = ball.zip(floor).map(nearer).or_else(|| ball).or_else(|| floor);
//! let distances = first.map(|hit| hit.distance).unwrap_or(all(f64::INFINITY));
//! assert_eq!(distances.to_array(), [4.0, 5.0, 8.0, f64::INFINITY]);
//! ```
//!
//! [`Ray::triangle_test`] prepares one ray for many triangles.
//!
//! # Example
//!
//! ```
//! use ga_runtime::cga3::{Plane, Point, Sphere};
//! use ga_runtime::geometry::ray::{Ray, Side};
//!
//! let ray = Ray::new(Point::new(0.0_f64, 0.0, 5.0), [0.0, 0.0, -2.0]).unwrap();
//! let ball = Sphere::from_centre_radius(Point::default(), 1.0);
//! let floor = Plane::from_point_normal(Point::new(0.0, 0.0, -3.0), [0.0, 0.0, 1.0]);
//!
//! let hit = ray.first_hit(ball).unwrap();
//! assert_eq!(hit.distance, 4.0);
//! assert_eq!(hit.point.coordinates(), [0.0, 0.0, 1.0]);
//! assert_eq!(hit.normal.vector(), [0.0, 0.0, 1.0]);
//!
//! // The nearest of several surfaces. The floor is further away than the ball.
//! let hits = [ray.first_hit(ball), ray.first_hit(floor)];
//! let nearest = hits.into_iter().flatten().min_by(|a, b| a.distance.total_cmp(&b.distance));
//! assert_eq!(nearest, Some(hit));
//!
//! // The mirrored ray does not hit the ball again.
//! let mirrored = ray.reflect(&hit).advance(1e-9);
//! assert_eq!(mirrored.first_hit(ball), None);
//! // From the inside, the ball is hit from its back.
//! let inside = Ray::new(Point::default(), [1.0, 0.0, 0.0]).unwrap();
//! assert_eq!(inside.first_hit(ball).unwrap().side(), Side::Back);
//! ```

mod ahead;
mod distances;
mod hit;
mod motion;
mod round;
mod surface;
mod triangle;

pub use hit::{Hit, Side};
pub use surface::Surface;
pub use triangle::{Crossing, TriangleTest};

use crate::cga3::{Direction, Line, Point};
use crate::scalar::{Maybe, Optional, Real, Ring, Select};
use crate::vga3::Vector;

/// A ray: the points `o + t d`, `t ≥ 0`, of a line `o∧d∧ei`, where o is its origin and d its
/// direction, of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<S> {
    origin: Point<S>,
    direction: Direction<S>,
}

impl<S: Ring> Ray<S> {
    /// The point at which the ray begins.
    #[inline]
    #[must_use]
    pub fn origin(self) -> Point<S> {
        self.origin
    }

    /// The direction `d∧ei`, of length 1 up to rounding.
    #[inline]
    #[must_use]
    pub fn direction(self) -> Direction<S> {
        self.direction
    }

    /// The line of the ray, `o∧d∧ei`, of weight 1.
    ///
    /// ```
    /// use ga_runtime::cga3::{Infinity, Point};
    /// use ga_runtime::geometry::ray::Ray;
    /// let (p, q) = (Point::new(1.0, 2.0, 0.0), Point::new(1.0, 2.0, 1.0));
    /// assert_eq!(Ray::through(p, q).unwrap().line(), p ^ q ^ Infinity);
    /// ```
    #[inline]
    #[must_use]
    pub fn line(self) -> Line<S> {
        Line::from_point_direction(self.origin, self.direction.vector())
    }

    /// The point at a distance from the origin, `o + t d`. A negative distance gives a point of the
    /// line behind the origin.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::ray::Ray;
    /// let ray = Ray::new(Point::new(1.0, 0.0, 0.0), [0.0, 5.0, 0.0]).unwrap();
    /// assert_eq!(ray.at(3.0), Point::new(1.0, 3.0, 0.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn at(self, distance: S) -> Point<S> {
        (Vector::from(self.origin) + Vector::from(self.direction) * distance).into()
    }

    /// The ray that begins a distance further on, in the same direction.
    ///
    /// Points computed on a surface lie a little beside it. A ray that leaves a surface is advanced
    /// by more than that error, so that it does not hit the same point again: `1e-9` suits `f64`
    /// and scenes of size 1 to 100.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::ray::Ray;
    /// let ray = Ray::new(Point::default(), [0.0, 0.0, 1.0]).unwrap();
    /// assert_eq!(ray.advance(2.0).origin(), Point::new(0.0, 0.0, 2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn advance(self, distance: S) -> Self {
        Self::new_unchecked(self.at(distance), self.direction)
    }

    /// The distance along the ray of the foot of the perpendicular from a point, `(p − o)·d`;
    /// negative for a point behind the origin.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::ray::Ray;
    /// let ray = Ray::new(Point::new(1.0, 0.0, 0.0), [1.0, 0.0, 0.0]).unwrap();
    /// assert_eq!(ray.depth(Point::new(4.0, 7.0, 0.0)), 3.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn depth(self, point: Point<S>) -> S {
        self.origin.vector_to(point).dot(self.direction.into())
    }

    /// A ray from a direction that is known to have length 1. With another length, distances are in
    /// units of that length, and hits are wrong.
    #[inline]
    #[must_use]
    pub const fn new_unchecked(origin: Point<S>, direction: Direction<S>) -> Self {
        Self { origin, direction }
    }
}

impl<S: Real> Ray<S> {
    /// The ray from a point in a direction, which need not have length 1: an array `[x, y, z]`, a
    /// [`Vector`] or a [`Direction`]. `None` where the direction is zero, or a number is not
    /// finite.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::ray::Ray;
    /// let ray = Ray::new(Point::new(1.0, 2.0, 3.0), [0.0, 3.0, 4.0]).unwrap();
    /// assert_eq!(ray.direction().vector(), [0.0, 0.6, 0.8]);
    /// assert_eq!(Ray::new(Point::new(1.0, 2.0, 3.0), [0.0, 0.0, 0.0]), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn new(origin: Point<S>, direction: impl Into<Vector<S>>) -> Maybe<Self, S> {
        let direction = direction.into().normalized();
        direction
            .filter(|_| Vector::from(origin).is_finite())
            .map(|direction| Self::new_unchecked(origin, direction.into()))
    }

    /// The ray from one point through another. `None` where they coincide, or a number is not
    /// finite.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::ray::Ray;
    /// let (eye, target) = (Point::new(0.0, 0.0, 5.0), Point::new(0.0, 0.0, 1.0));
    /// let ray = Ray::through(eye, target).unwrap();
    /// assert_eq!(ray.direction().vector(), [0.0, 0.0, -1.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn through(origin: Point<S>, point: Point<S>) -> Maybe<Self, S> {
        Self::new(origin, origin.vector_to(point))
    }
}

impl<S: Real> Select for Ray<S> {
    type Mask = S::Mask;

    #[inline]
    fn select(mask: S::Mask, if_true: Self, if_false: Self) -> Self {
        Self::new_unchecked(
            Point::select(mask, if_true.origin, if_false.origin),
            Direction::select(mask, if_true.direction, if_false.direction),
        )
    }
}
