//! Euclidean geometry in pga2.
//!
//! Points and lines are homogeneous: a multiple of one is the same one, with another weight. A
//! point of weight zero is ideal, a direction. What divides by a weight comes back as an `Option`.

mod line;
mod motor;
mod point;
