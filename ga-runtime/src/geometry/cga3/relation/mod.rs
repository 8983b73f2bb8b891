//! Relations between primitives: incidence, nearest points, reflection, inversion, distance, angle,
//! meet and join.
//!
//! Everything here is an inherent method of [`Point`](crate::cga3::Point),
//! [`FlatPoint`](crate::cga3::FlatPoint), [`PointPair`](crate::cga3::PointPair),
//! [`Line`](crate::cga3::Line), [`Plane`](crate::cga3::Plane), [`Circle`](crate::cga3::Circle) and
//! [`Sphere`](crate::cga3::Sphere) and of their dual forms. This module contains the traits that
//! these methods are generic over and the types that they return.
//!
//! - [`incidence`]: `a.is_on(b, tolerance)` and `a.coincides_with(b, tolerance)`, whether a lies on
//!   b and whether both are the same; `a.is_parallel_to(b, tolerance)` and
//!   `a.is_perpendicular_to(b, tolerance)`, the same for directions.
//! - [`projection`]: `a.project_onto(b)` and `a.reject_from(b)`, the nearest point of b and the
//!   rest of a.
//! - [`reflection`]: `a.reflect_in(mirror)`, the image in a plane, a line or a point.
//! - [`inversion`]: `a.invert_in(sphere, tolerance)`, the image under inversion.
//! - [`distance`]: `a.distance_to(b)` and `a.signed_distance_to(b)`, the least distance, in the
//!   units of the coordinates.
//! - [`angle`]: `a.angle_to(b)`, the angle in radians, or the two [`CircleAngles`] of circles, and
//!   `a.inversive_distance_to(b)`.
//! - [`common_perpendicular`]: `a.common_perpendicular(b, tolerance)`, the shortest segment between
//!   two lines.
//! - [`meet`]: `a.meet(b, tolerance)`, the intersection, by cases.
//! - [`join`]: `a.join(b, tolerance)`, the smallest primitive that contains both.
//! - [`tangent`]: `a.tangent_plane_at(p, tolerance)`, `a.tangent_line_at(p, tolerance)`, what
//!   touches a sphere or a circle at a point of it.
//!
//! Distances, angles and tests first convert each primitive to a Euclidean [`Figure`] and subtract
//! positions before they square, so that they stay accurate far from the origin. Methods that
//! decide between cases by a comparison take a [`Tolerance`]. A primitive that is not a figure,
//! because its weight is zero, because it is imaginary or because it is not finite, gives `None`,
//! and `false` in a test.

pub mod angle;
mod circle_angles;
pub mod common_perpendicular;
pub mod distance;
mod figure;
mod figure_distance;
mod figure_incidence;
mod from_point;
pub mod incidence;
pub mod inversion;
pub mod join;
mod least;
pub mod meet;
mod primitive;
pub mod projection;
pub mod reflection;
mod sum;
pub mod tangent;
mod tolerance;

pub use angle::Extended;
pub use circle_angles::CircleAngles;
pub use common_perpendicular::CommonPerpendicular;
pub use figure::Figure;
pub use from_point::FromPoint;
pub use incidence::Directed;
pub use inversion::RoundOrFlat;
pub use join::Join;
pub use meet::Meet;
pub use primitive::Primitive;
pub use reflection::Mirror;
pub use tolerance::Tolerance;

use crate::scalar::Real;
use crate::vga3::Vector;

/// The hypotenuse of a right triangle, `√(a² + b²)`, without overflow or underflow on the way.
fn hypotenuse<S: Real>(a: S, b: S) -> S {
    Vector::new(a, b, S::zero()).length()
}

/// Directions are treated as parallel, where no tolerance is given, if the sine of their angle is
/// below 16 ε.
fn parallel<S: Real>() -> S {
    S::epsilon() * S::from_integer(16)
}
