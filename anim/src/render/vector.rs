//! Componentwise operations on Euclidean triples, for code that works on plain coordinates.

pub(crate) type Vector = [f64; 3];

pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn subtract(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scale(a: Vector, s: f64) -> Vector {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// `a + s b`.
pub(crate) fn add_scaled(a: Vector, b: Vector, s: f64) -> Vector {
    [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s]
}

/// `a` for `t = 0`, `b` for `t = 1`.
pub(crate) fn mix(a: Vector, b: Vector, t: f64) -> Vector {
    add_scaled(scale(a, 1.0 - t), b, t)
}

pub(crate) fn multiply(a: Vector, b: Vector) -> Vector {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(crate) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// `None` for a vector without a direction: zero, not finite, or so short or long that its square
/// is.
pub(crate) fn normalized(a: Vector) -> Option<Vector> {
    let length = length(a);
    (length.is_normal()).then(|| scale(a, 1.0 / length))
}

/// Hermite step: 0 up to `low`, 1 from `high` on, smooth between.
pub(crate) fn smooth_step(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
