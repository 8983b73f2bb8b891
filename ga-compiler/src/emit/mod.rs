//! Back ends.

#[cfg(feature = "count")]
pub mod count;
pub mod dot;
pub mod formula;
pub mod rust;
pub(crate) mod stage;
pub mod wgsl;
