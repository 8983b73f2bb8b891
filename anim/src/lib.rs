//! Three-dimensional animation on conformal geometric algebra.

pub mod atomic_write;
pub mod bvh;
pub mod gltf;
pub mod mesh;
pub mod obj;
mod read_error;
pub mod render;
pub mod rig;
pub mod sheet;
pub mod skeleton;
pub mod weights;

pub use read_error::ReadError;
