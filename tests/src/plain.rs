//! Plain vectors and primitives by points, for tests of geometry. Nothing here knows the algebra.

use std::f64::consts::TAU;

use ga_runtime::Element;
use ga_runtime::cga3::{Circle, Line, Plane, Point, PointPair, Sphere};
use ga_runtime::dense::Multivector;
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::testing::{algebra_of, to_dense};
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

/// The inner product.
pub fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

/// The cross product.
pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a − b.
pub fn minus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

/// a + s b.
pub fn along(a: Vector, s: f64, b: Vector) -> Vector {
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

/// Two unit vectors across a unit normal, right-handed with it.
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

/// The point with these coordinates.
pub fn point(p: Vector) -> Point<f64> {
    Point::from(p)
}

/// The line through p with direction d.
pub fn line(p: Vector, d: Vector) -> Line<f64> {
    Line::from_point_direction(point(p), d)
}

/// The plane through p with normal n.
pub fn plane(p: Vector, n: Vector) -> Plane<f64> {
    Plane::from_point_normal(point(p), n)
}

/// The sphere by its centre and radius.
pub fn sphere(c: Vector, r: f64) -> Sphere<f64> {
    Sphere::from_centre_radius(point(c), r)
}

/// The circle by its centre, normal and radius.
pub fn circle(c: Vector, n: Vector, r: f64) -> Circle<f64> {
    Circle::from_centre_normal_radius(point(c), n, r).expect("a circle")
}

/// The point pair of p and q.
pub fn pair(p: Vector, q: Vector) -> PointPair<f64> {
    point(p) ^ point(q)
}

/// The sphere with this squared radius, of either sign, by its five coefficients.
pub fn sphere_of_square(c: Vector, squared: f64) -> Sphere<f64> {
    let ei = (dot(c, c) - squared) / 2.0;
    ga_runtime::cga3::DualSphere::new(c[0], c[1], c[2], 1.0, ei).undual()
}

/// The circle with this squared radius, of either sign: the intersection of a plane with a sphere
/// whose centre lies in the plane.
pub fn circle_of_square(c: Vector, n: Vector, squared: f64) -> Circle<f64> {
    plane(c, n) & sphere_of_square(c, squared)
}

/// A point of a circle.
pub fn on_circle(c: Vector, n: Vector, r: f64, angle: f64) -> Vector {
    let [u, v] = frame(unit_of(n));
    along(along(c, r * angle.cos(), u), r * angle.sin(), v)
}

/// The tolerance of tests: 10⁻⁹, relative and absolute.
pub fn tolerance() -> Tolerance<f64> {
    Tolerance::new(1e-9, 1e-9)
}

/// Asserts that two numbers differ by no more than a bound.
#[track_caller]
pub fn near(found: f64, expected: f64, bound: f64) {
    assert!(
        (found - expected).abs() <= bound,
        "{found} is not {expected}, by {}",
        (found - expected).abs()
    );
}

/// Asserts that two vectors lie no further apart than a bound.
#[track_caller]
pub fn near_vector(found: Vector, expected: Vector, bound: f64) {
    let off = length(minus(found, expected));
    assert!(off <= bound, "{found:?} is not {expected:?}, by {off}");
}

/// All coefficients of an element, in the dense reference.
pub fn dense<T: Element<Scalar = f64>>(element: &T) -> Multivector<f64> {
    to_dense(&algebra_of(T::METRIC), element)
}

/// Asserts that two multivectors are equal within a part of the greatest coefficient.
#[track_caller]
pub fn near_dense(found: &Multivector<f64>, expected: &Multivector<f64>, bound: f64) {
    let size = |m: &Multivector<f64>| m.coefficients().iter().fold(0.0_f64, |s, x| s.max(x.abs()));
    let off = size(&(found - expected));
    assert!(
        off <= bound * size(expected).max(1.0),
        "{found}\nis not {expected}\nby {off}"
    );
}

/// Asserts that one multivector is a positive multiple of another.
#[track_caller]
pub fn positive_multiple(found: &Multivector<f64>, expected: &Multivector<f64>, bound: f64) {
    let norm = |m: &Multivector<f64>| m.coefficients().iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!(
        norm(expected) > 0.0 && norm(found) > 0.0,
        "{found} against {expected}"
    );
    near_dense(
        &found.scale(1.0 / norm(found)),
        &expected.scale(1.0 / norm(expected)),
        bound,
    );
}

/// The least value of a function of an angle, by dense sampling and golden sections about the least
/// samples.
pub fn least_by_sampling(samples: usize, function: impl Fn(f64) -> f64) -> f64 {
    let step = TAU / samples as f64;
    let values: Vec<f64> = (0..samples).map(|k| function(k as f64 * step)).collect();
    let mut best = f64::INFINITY;
    for k in 0..samples {
        let (before, after) = (
            values[(k + samples - 1) % samples],
            values[(k + 1) % samples],
        );
        if values[k] > before || values[k] > after {
            continue;
        }
        let (mut a, mut b) = ((k as f64 - 1.0) * step, (k as f64 + 1.0) * step);
        let ratio = (5.0_f64.sqrt() - 1.0) / 2.0;
        let (mut c, mut d) = (b - ratio * (b - a), a + ratio * (b - a));
        let (mut at_c, mut at_d) = (function(c), function(d));
        for _ in 0..80 {
            if at_c < at_d {
                (b, d, at_d) = (d, c, at_c);
                c = b - ratio * (b - a);
                at_c = function(c);
            } else {
                (a, c, at_c) = (c, d, at_d);
                d = a + ratio * (b - a);
                at_d = function(d);
            }
        }
        best = best.min(at_c).min(at_d).min(values[k]);
    }
    best
}
