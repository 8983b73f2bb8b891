//! How large a program may be.

/// How many steps a function may have, its operands included.
pub const MAX_STEPS: usize = 1 << 20;
