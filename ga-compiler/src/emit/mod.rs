//! Back ends.

#[cfg(feature = "count")]
pub use crate::count;
mod case;
pub mod dot;
pub mod formula;
pub mod rust;
pub mod wgsl;
