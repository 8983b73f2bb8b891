//! Euclidean geometry in pga2.
//!
//! Points and lines are homogeneous: a multiple of an element is the same point or line with
//! another weight. A point of weight zero is ideal: it represents a direction. Methods that divide
//! by a weight return an `Option`.

mod line;
mod motor;
mod point;
