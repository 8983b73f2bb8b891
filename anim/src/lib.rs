//! Placeholder.

pub mod atomic_write;
