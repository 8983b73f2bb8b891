//! Back ends: Rust, WGSL, formulas, and graphs as pictures.

// Counting reads emitted code and is not a back end; this is its earlier path.
#[cfg(feature = "count")]
pub use crate::count;
#[cfg(feature = "dot")]
pub mod dot;
pub mod formula;
mod item;
pub mod rust;
#[cfg(feature = "wgsl")]
pub mod wgsl;
