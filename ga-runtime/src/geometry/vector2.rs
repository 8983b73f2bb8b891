//! Vectors of the plane as pairs of numbers, for cga2 and pga2, whose features do not include vga2.

use crate::scalar::{Maybe, Optional, Real, Ring};
use crate::vga3;

pub(super) fn dot<S: Ring>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[0] + a[1] * b[1]
}

/// The oriented area of two vectors, positive where the rotation from a to b is counterclockwise.
pub(super) fn area<S: Ring>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[1] - a[1] * b[0]
}

pub(super) fn scaled<S: Ring>(a: [S; 2], factor: S) -> [S; 2] {
    a.map(|x| x * factor)
}

pub(super) fn difference<S: Ring>(a: [S; 2], b: [S; 2]) -> [S; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The length, without intermediate overflow or underflow; NaN where a component is NaN.
pub(super) fn length<S: Real>([x, y]: [S; 2]) -> S {
    vga3::Vector::new(x, y, S::zero()).length()
}

/// The vector of length 1 in the same direction; `None` for zero, infinity and NaN.
pub(super) fn normalized<S: Real>([x, y]: [S; 2]) -> Maybe<[S; 2], S> {
    let unit = vga3::Vector::new(x, y, S::zero()).normalized();
    unit.map(|unit| [unit.e1, unit.e2])
}
