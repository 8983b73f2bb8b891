//! Three-dimensional animation on conformal geometric algebra.

pub mod atomic_write;
pub mod mesh;
pub mod skeleton;
pub mod weights;
