//! Numbers that are finite, where the scalar is a ring and cannot tell.

use crate::scalar::Ring;

/// Whether a number is finite, in a ring that has others: zero times infinity is not a number, and
/// that equals nothing.
pub(super) fn is_number<S: Ring>(x: S) -> bool {
    x * S::zero() == S::zero()
}

/// Whether all components are finite.
pub(super) fn are_numbers<S: Ring, const N: usize>(components: [S; N]) -> bool {
    components.into_iter().all(is_number)
}
