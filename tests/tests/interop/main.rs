//! Types and traits of other crates.

mod approx;
mod bytemuck;
mod every_type;
mod glam;
mod nalgebra;
mod num_traits;
mod plain;
mod serde;
