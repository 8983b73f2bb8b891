//! Relativity in sta: events, fields and Lorentz transformations, in units where the speed of light
//! is 1.

mod bivector;
mod complex;
mod matrix;
mod power;
mod rotor;
mod vector;
mod velocity;

pub use matrix::NotLorentz;
pub use velocity::{NotSlowerThanLight, relative_velocity, velocity_sum};
