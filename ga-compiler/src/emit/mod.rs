//! Back ends: Rust, WGSL, formulas, and graphs as pictures.

#[cfg(feature = "count")]
pub use crate::count;
pub mod dot;
pub mod formula;
pub mod rust;
pub mod wgsl;
