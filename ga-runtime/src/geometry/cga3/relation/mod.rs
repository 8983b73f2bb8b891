//! Relations between primitives: incidence, nearest points, reflection, inversion, distance, angle,
//! meet and join.
//!
//! Everything here is an inherent method of [`Point`](crate::cga3::Point),
//! [`FlatPoint`](crate::cga3::FlatPoint), [`PointPair`](crate::cga3::PointPair),
//! [`Line`](crate::cga3::Line), [`Plane`](crate::cga3::Plane), [`Circle`](crate::cga3::Circle) and
//! [`Sphere`](crate::cga3::Sphere) in direct form and, but for meet and join, of their dual forms;
//! this module holds the traits that these methods are generic over and the types that they return.
//!
//! - `a.is_on(b, tolerance)`, `a.coincides_with(b, tolerance)`: whether a is part of b, whether
//!   both are one; see [`incidence`].
//! - `a.is_parallel_to(b, tolerance)`, `a.is_perpendicular_to(b, tolerance)`: the same for
//!   directions; see [`incidence`].
//! - `a.project_onto(b)`, `a.reject_from(b)`: the nearest point of b, and what is left of a; see
//!   [`projection`].
//! - `a.reflect_in(mirror)`: the image in a plane, a line or a point; see [`reflection`].
//! - `a.invert_in(sphere, tolerance)`: the image under inversion; see [`inversion`].
//! - `a.distance_to(b)`, `a.signed_distance_to(b)`: the least distance, in the units of the
//!   coordinates; see [`distance`].
//! - `a.angle_to(b)`, `a.inversive_distance_to(b)`: the angle in radians; see [`angle`].
//! - `a.common_perpendicular(b, tolerance)`: the shortest way between two lines; see
//!   [`common_perpendicular`].
//! - `a.meet(b, tolerance)`: what both share, by cases; see [`meet`].
//! - `a.join(b, tolerance)`: the least primitive that holds both; see [`join`].
//!
//! Measures and tests read each primitive as a plain Euclidean [`Figure`] first and take
//! differences of places before squares, so that points and flats stay accurate far from the
//! origin. The radius of a round is known only as its blade knows it, r² to within some ε of the
//! centre's squared distance from the origin. What is decided by comparing takes a [`Tolerance`]. A
//! primitive that is not a figure, because its weight is zero, it is imaginary or not finite, gives
//! `None`, and `false` in a test.

pub mod angle;
pub mod common_perpendicular;
pub mod distance;
mod figure;
pub mod incidence;
pub mod inversion;
pub mod join;
mod least;
pub mod meet;
pub mod projection;
pub mod reflection;
mod tolerance;

pub use angle::Extended;
pub use common_perpendicular::CommonPerpendicular;
pub use figure::{Figure, Primitive};
pub use incidence::Directed;
pub use inversion::RoundOrFlat;
pub use join::Join;
pub use meet::Meet;
pub use reflection::Mirror;
pub use tolerance::Tolerance;

use crate::scalar::Real;
use crate::vga3::Vector;

/// The longer side of a right triangle, `√(a² + b²)`, without overflow or underflow on the way.
fn hypotenuse<S: Real>(a: S, b: S) -> S {
    Vector::new(a, b, S::zero()).length()
}

/// Directions whose sine differs from zero by less count as parallel where no tolerance is given:
/// 16 ε.
fn parallel<S: Real>() -> S {
    S::epsilon() * S::from_integer(16)
}
