//! Three-dimensional animation on conformal geometric algebra.

pub mod atomic_write;
pub mod bvh;
pub mod clip;
pub mod gltf;
pub mod mesh;
pub mod obj;
pub mod pose;
mod read_error;
pub mod render;
pub mod retarget;
pub mod rig;
pub mod sheet;
pub mod skeleton;
pub mod skin;
pub mod weights;

pub use read_error::ReadError;
