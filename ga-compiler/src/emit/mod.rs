//! Back ends.

#[cfg(feature = "count")]
pub mod count;
pub mod rust;
