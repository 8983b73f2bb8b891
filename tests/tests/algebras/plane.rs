//! Plain vectors of two numbers.

use proptest::prelude::*;

pub(crate) type Vector = [f64; 2];

pub(crate) fn vector(size: f64) -> impl Strategy<Value = Vector> + Clone {
    prop::array::uniform2(-size..size)
}

/// The rotation of a vector by an angle, counterclockwise.
pub(crate) fn rotated([x, y]: Vector, angle: f64) -> Vector {
    let (sine, cosine) = angle.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y]
}

pub(crate) fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn times(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

pub(crate) fn length([x, y]: Vector) -> f64 {
    x.hypot(y)
}

/// The signed area of the parallelogram of two vectors.
pub(crate) fn area(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
