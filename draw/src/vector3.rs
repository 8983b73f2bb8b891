//! Plain vectors of space.

pub(crate) type Vector3 = [f64; 3];

pub(crate) fn dot(a: Vector3, b: Vector3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector3, b: Vector3) -> Vector3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(crate) fn sum(a: Vector3, b: Vector3) -> Vector3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn difference(a: Vector3, b: Vector3) -> Vector3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scaled(a: Vector3, factor: f64) -> Vector3 {
    a.map(|x| x * factor)
}

/// `a + t b`.
pub(crate) fn along(a: Vector3, b: Vector3, t: f64) -> Vector3 {
    sum(a, scaled(b, t))
}

pub(crate) fn length(a: Vector3) -> f64 {
    dot(a, a).sqrt()
}

/// The vector with length 1; `None` for zero, and for what is not finite.
pub(crate) fn normalized(a: Vector3) -> Option<Vector3> {
    let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest == 0.0 || !a.iter().all(|x| x.is_finite()) {
        return None;
    }
    // Dividing by the largest first keeps the squares in range.
    let a = a.map(|x| x / largest);
    Some(scaled(a, length(a).recip()))
}

/// Two vectors that make a right-handed orthonormal basis with a unit vector: `u × v = n`. `u` lies
/// across `up` where that is possible.
pub(crate) fn basis_across(normal: Vector3, up: Vector3) -> [Vector3; 2] {
    let across = cross(up, normal);
    let u = if length(across) > 1e-6 {
        scaled(across, length(across).recip())
    } else {
        // The coordinate axis after the one that the normal is nearest to.
        let largest = (0..3).fold(0, |best, k| {
            if normal[k].abs() > normal[best].abs() {
                k
            } else {
                best
            }
        });
        let mut axis = [0.0; 3];
        axis[(largest + 1) % 3] = 1.0;
        let flat = along(axis, normal, -dot(axis, normal));
        scaled(flat, length(flat).recip())
    };
    [u, cross(normal, u)]
}

/// The point of a circle at an angle, by two orthonormal vectors in its plane.
pub(crate) fn on_circle(centre: Vector3, [u, v]: [Vector3; 2], radius: f64, angle: f64) -> Vector3 {
    let (sine, cosine) = angle.sin_cos();
    along(along(centre, u, radius * cosine), v, radius * sine)
}
