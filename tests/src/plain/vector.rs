//! Vectors of three numbers.

use std::ops::{Add, Mul, Sub};

use proptest::prelude::*;

/// A vector by its components.
pub type Vector = [f64; 3];

/// The unit vector along x.
pub const X: Vector = [1.0, 0.0, 0.0];
/// The unit vector along y.
pub const Y: Vector = [0.0, 1.0, 0.0];
/// The unit vector along z.
pub const Z: Vector = [0.0, 0.0, 1.0];
/// The origin, and the zero vector.
pub const O: Vector = [0.0; 3];

/// What components are added and multiplied as: `f64`, or a number of more digits.
pub trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Number for T {}

/// The inner product.
pub fn dot<T: Number>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The cross product.
pub fn cross<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a + b.
pub fn plus<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    std::array::from_fn(|k| a[k] + b[k])
}

/// a − b.
pub fn minus<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// a multiplied by a factor.
pub fn times<T: Number>(a: [T; 3], factor: T) -> [T; 3] {
    a.map(|x| x * factor)
}

/// a + s b.
pub fn along<T: Number>(a: [T; 3], s: T, b: [T; 3]) -> [T; 3] {
    std::array::from_fn(|k| a[k] + s * b[k])
}

/// The Euclidean length.
pub fn length(a: Vector) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

/// The unit vector of the same direction.
pub fn unit_of(a: Vector) -> Vector {
    a.map(|x| x / length(a))
}

/// The rotation of x by an angle about a unit axis, by Rodrigues' formula.
pub fn rotated(axis: Vector, angle: f64, x: Vector) -> Vector {
    let (sine, cosine) = angle.sin_cos();
    let (side, share) = (cross(axis, x), dot(axis, x) * (1.0 - cosine));
    std::array::from_fn(|k| x[k] * cosine + side[k] * sine + axis[k] * share)
}

/// Two unit vectors perpendicular to a unit normal, right-handed with it.
pub fn frame(normal: Vector) -> [Vector; 2] {
    let axis = if normal[0].abs() < 0.6 { X } else { Y };
    let u = unit_of(cross(axis, normal));
    [u, cross(normal, u)]
}

/// Vectors with components within ± `size`.
pub fn vector(size: f64) -> impl Strategy<Value = Vector> + Clone {
    prop::array::uniform3(-size..size)
}

/// Unit vectors.
pub fn unit() -> impl Strategy<Value = Vector> + Clone {
    vector(1.0).prop_filter_map("too short to have a direction", |v| {
        (length(v) > 0.1).then(|| unit_of(v))
    })
}
