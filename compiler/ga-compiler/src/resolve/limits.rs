//! How many operands a function has, and how deep its calls and formulas may go.

/// How many multivectors the operands of a function may hold together. Each is drawn at many
/// points.
pub(super) const MAX_OPERANDS: usize = 1 << 14;

/// How deep calls of functions may go.
pub(super) const MAX_CALL_DEPTH: usize = 64;

/// How many calls of functions may be copied into one function.
pub(super) const MAX_CALLS: usize = 4096;

/// How deep formulas may nest, counted through the calls of functions.
pub(super) const MAX_LEVELS: usize = 512;
