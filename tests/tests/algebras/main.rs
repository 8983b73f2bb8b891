//! The geometry of the algebras beside cga3, compared with plain coordinates, matrices and the
//! dense reference.

mod cga2;
mod pga2;
mod pga3;
mod single;
mod sta;
mod vga2;
mod vga3;
mod vga3_vector;

use proptest::prelude::*;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn times(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Rodrigues' formula for a turn about a unit axis.
fn rodrigues(axis: Vector, angle: f64, x: Vector) -> Vector {
    let (sine, cosine) = angle.sin_cos();
    let along = times(axis, dot(axis, x) * (1.0 - cosine));
    plus(plus(times(x, cosine), times(cross(axis, x), sine)), along)
}

fn vector(size: f64) -> impl Strategy<Value = Vector> + Clone {
    prop::array::uniform3(-size..size)
}

fn unit() -> impl Strategy<Value = Vector> + Clone {
    vector(1.0).prop_filter_map("too short to have a direction", |v| {
        (length(v) > 0.1).then(|| times(v, 1.0 / length(v)))
    })
}

/// A vector across a unit vector, of length 1.
fn across(a: Vector) -> Vector {
    let other = if a[0].abs() < 0.7 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let v = cross(a, other);
    times(v, 1.0 / length(v))
}

fn largest_difference<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.into_iter().zip(b).fold(0.0, |most, (x, y)| {
        let difference = (x - y).abs();
        if difference.is_nan() {
            f64::NAN
        } else {
            difference.max(most)
        }
    })
}

/// Asserts that arrays agree within a tolerance; NaN agrees with nothing.
#[track_caller]
fn assert_near<const N: usize>(a: [f64; N], b: [f64; N], tolerance: f64) {
    let difference = largest_difference(a, b);
    assert!(
        difference <= tolerance,
        "{a:?} and {b:?} differ by {difference}"
    );
}
