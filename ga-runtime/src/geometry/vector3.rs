//! Plain vectors of space, for what is read back.

use crate::scalar::{Real, Ring};

pub(super) fn dot<S: Ring>(a: [S; 3], b: [S; 3]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross<S: Ring>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(super) fn scaled<S: Ring>(a: [S; 3], factor: S) -> [S; 3] {
    a.map(|x| x * factor)
}

pub(super) fn sum<S: Ring>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn difference<S: Ring>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Whether a number is finite, in a ring that has others: zero times infinity is not a number, and
/// that equals nothing.
pub(super) fn is_number<S: Ring>(x: S) -> bool {
    x * S::zero() == S::zero()
}

/// Whether all components are finite.
pub(super) fn are_numbers<S: Ring>(a: [S; 3]) -> bool {
    a.into_iter().all(is_number)
}

/// The length, without overflow or underflow on the way; NaN where a component is NaN.
pub(super) fn length<S: Real>(a: [S; 3]) -> S {
    let largest = a[0].abs().max(a[1].abs()).max(a[2].abs());
    let is_regular = S::zero().less_than(largest) & largest.is_finite();
    // Zero, infinity and NaN stay what they are.
    let size = S::select(is_regular, largest, S::one());
    let unit = a.map(|x| x / size);
    dot(unit, unit).sqrt() * size
}

/// The vector of length 1 in the same direction; `None` for zero, infinity and NaN.
pub(super) fn normalized<S: Real<Mask = bool>>(a: [S; 3]) -> Option<[S; 3]> {
    let finite = a[0].is_finite() && a[1].is_finite() && a[2].is_finite();
    let largest = a[0].abs().max(a[1].abs()).max(a[2].abs());
    if !finite || !S::zero().less_than(largest) {
        return None;
    }
    let unit = a.map(|x| x / largest);
    let length = dot(unit, unit).sqrt();
    Some(unit.map(|x| x / length))
}
