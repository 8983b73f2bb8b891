//! Three-dimensional animation on conformal geometric algebra.

pub mod atomic_write;
pub mod mesh;
pub mod obj;
mod read_error;
pub mod skeleton;
pub mod weights;

pub use read_error::ReadError;
