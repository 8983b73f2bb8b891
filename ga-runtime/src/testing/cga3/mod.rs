//! Strategies for the objects and motions of [`cga3`](crate::cga3), special positions included.
//!
//! [`member`](super::member) draws numbers: right for algebraic identities, but a random
//! `Trivector` of ten coefficients is not a circle. The strategies here draw geometric objects, and
//! include the special cases that break geometric code: coinciding points, half turns, angles near
//! zero, parallel lines, tangent spheres. About half of the cases are ordinary, so that a test of a
//! few hundred cases includes every special one. The page of each strategy lists them.
//!
//! `size` is the largest absolute value of a coordinate and must be positive and finite; a strategy
//! panics when it draws from an empty or infinite range. Every strategy is generic over the scalar:
//! numbers are drawn in `f64` and then rounded, so that "on one line" and "tangent" are true up to
//! rounding.
//!
//! ```
//! use ga_runtime::cga3::{Line, Motor, Point};
//! use ga_runtime::testing::{assert_close, cga3};
//! use proptest::prelude::*;
//!
//! // A motion keeps the distance of a point from a line.
//! let (motors, lines) = (cga3::motors(10.0), cga3::lines(10.0));
//! proptest!(|(motor in motors, line in lines, point in cga3::points(10.0))| {
//!     let (motor, line, point): (Motor<f64>, Line<f64>, Point<f64>) = (motor, line, point);
//!     let before = line.distance(point).unwrap();
//!     let after = motor.transform(line).distance(motor.transform(point)).unwrap();
//!     assert_close!(before, after, 1e-12, 100.0);
//! });
//! ```

mod flats;
mod numbers;
mod points;
mod rounds;
mod versors;

pub use flats::{flat_points, lines, pairs_of_lines, pairs_of_planes, planes};
pub use numbers::{angles, directions, weights};
pub use points::{point_configurations, points};
pub use rounds::{
    circles, circles_of_any_kind, pairs_of_spheres, point_pairs, point_pairs_of_any_kind, spheres,
    spheres_of_any_kind,
};
pub use versors::{dilators, motors, rotors, similarities, translators};
