//! Euclidean geometry in cga3: what each type is built from, and what can be read back from it.
//!
//! Everything here is an inherent method of a type of [`cga3`](crate::cga3). Coordinates are arrays `[x, y, z]`, angles are in
//! radians and right-handed. What may not exist comes back as an `Option`, and so does what may be beyond the range of the scalar: what is read back is
//! finite or `None`. What is built holds products of up to three coordinates, which very large ones take beyond the range.

mod circle;
mod dilator;
mod direction;
mod dual_motion;
mod dual_round;
mod flat_point;
mod kind;
mod line;
mod motor;
mod plane;
mod point;
mod point_pair;
mod rotor;
mod round;
mod screw;
mod sphere;
mod translator;
mod vector3;

pub use kind::Kind;
