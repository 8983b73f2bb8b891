//! Directions as plain vectors.

use ga_runtime::cga3::Point;

pub(super) fn minus(a: Point<f64>, b: Point<f64>) -> [f64; 3] {
    let (a, b) = (a.coordinates(), b.coordinates());
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(super) fn length(a: [f64; 3]) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

/// The vector of length 1 in the same direction, if there is one.
pub(super) fn unit(a: [f64; 3]) -> Option<[f64; 3]> {
    let length = length(a);
    (length.is_finite() && length > 0.0).then(|| a.map(|x| x / length))
}

/// The part of a vector that is across a unit vector.
pub(super) fn across(a: [f64; 3], unit: [f64; 3]) -> [f64; 3] {
    let along = dot(a, unit);
    std::array::from_fn(|k| a[k] - along * unit[k])
}

/// The rows of the matrix with these columns.
pub(super) fn rows(x: [f64; 3], y: [f64; 3], z: [f64; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|k| [x[k], y[k], z[k]])
}
