//! How deep the calls and the formulas of a function may go.

/// How deep calls of functions may go.
pub(super) const MAX_CALL_DEPTH: usize = 64;

/// How many calls of functions may be copied into one function.
pub(super) const MAX_CALLS: usize = 4096;

/// How deep formulas may nest, counted through the calls of functions.
pub(super) const MAX_LEVELS: usize = 512;
