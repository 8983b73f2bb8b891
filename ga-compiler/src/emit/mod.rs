//! Back ends: Rust, WGSL, formulas, and graphs as pictures.

// Counting reads emitted code and is not a back end; this is its earlier path.
#[cfg(feature = "count")]
pub use crate::count;
pub mod dot;
pub mod formula;
pub mod rust;
pub mod wgsl;
