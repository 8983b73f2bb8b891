//! How large programs and exponents may be.

/// How many steps a function may have, its operands included.
pub const MAX_STEPS: usize = 1 << 20;

/// The largest exponent, up to its sign.
pub(super) const MAX_EXPONENT: i128 = 1024;
