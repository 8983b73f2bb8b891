//! Elements of cga3, constructed from plain vectors.

use ga_runtime::cga3::{Circle, Line, Motor, Plane, Point, PointPair, Sphere};
use ga_runtime::scalar::Ring;

use super::{Vector, along, frame, unit_of};

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

/// The sphere with this centre and radius.
pub fn sphere(c: Vector, r: f64) -> Sphere<f64> {
    Sphere::from_centre_radius(point(c), r)
}

/// The circle with this centre, normal and radius.
pub fn circle(c: Vector, n: Vector, r: f64) -> Circle<f64> {
    Circle::from_centre_normal_radius(point(c), n, r).expect("a circle")
}

/// The point pair p ∧ q.
pub fn pair(p: Vector, q: Vector) -> PointPair<f64> {
    point(p) ^ point(q)
}

/// The sphere with this centre and squared radius, which may be negative.
pub fn sphere_of_square(c: Vector, squared: f64) -> Sphere<f64> {
    Sphere::from_centre_radius_squared(point(c), squared)
}

/// The circle with this squared radius, which may be negative: the intersection of a plane with a
/// sphere whose centre lies in the plane.
pub fn circle_of_square(c: Vector, n: Vector, squared: f64) -> Circle<f64> {
    plane(c, n) & sphere_of_square(c, squared)
}

/// The point of a circle at this angle.
pub fn on_circle(c: Vector, n: Vector, r: f64, angle: f64) -> Vector {
    let [u, v] = frame(unit_of(n));
    along(along(c, r * angle.cos(), u), r * angle.sin(), v)
}

/// The coefficients of a motor, in the order of its type.
pub fn motor_coefficients<S: Ring>(m: Motor<S>) -> [S; 8] {
    [
        m.scalar(),
        m.e12(),
        m.e13(),
        m.e23(),
        m.e1i(),
        m.e2i(),
        m.e3i(),
        m.e123i(),
    ]
}

/// The motor with these coefficients, which are not checked.
pub fn motor_of<S: Ring>([scalar, e12, e13, e23, e1i, e2i, e3i, e123i]: [S; 8]) -> Motor<S> {
    Motor::new_unchecked(scalar, e12, e13, e23, e1i, e2i, e3i, e123i)
}
