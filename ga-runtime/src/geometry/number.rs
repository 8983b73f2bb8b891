//! A test for finite numbers that needs only the operations of a ring.

use crate::scalar::Ring;

/// Whether a number is finite, in a ring that may have infinity and NaN: zero times infinity is
/// NaN, which is not equal to anything.
pub(super) fn is_number<S: Ring>(x: S) -> bool {
    x * S::zero() == S::zero()
}

/// Whether all components are finite.
pub(super) fn are_numbers<S: Ring, const N: usize>(components: [S; N]) -> bool {
    components.into_iter().all(is_number)
}
