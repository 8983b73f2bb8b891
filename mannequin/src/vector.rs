//! Plain arithmetic on coordinate triples, for the modules that make the surface.

pub(crate) type Vector = [f64; 3];

pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scale(a: Vector, s: f64) -> Vector {
    [a[0] * s, a[1] * s, a[2] * s]
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

pub(crate) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// `a` in unit length; a vector too short to have a direction stays as it is.
pub(crate) fn unit(a: Vector) -> Vector {
    let length = norm(a);
    if length > f64::MIN_POSITIVE {
        scale(a, 1.0 / length)
    } else {
        a
    }
}

/// The point a fraction `t` of the way from `a` to `b`.
pub(crate) fn mix(a: Vector, b: Vector, t: f64) -> Vector {
    add(a, scale(sub(b, a), t))
}

/// The mirror image in the plane x = 0, the body's plane of symmetry.
pub(crate) fn mirror(a: Vector) -> Vector {
    [-a[0], a[1], a[2]]
}
