//! Rays that hit triangles.

use super::{Hit, Ray, Surface};
use crate::cga3::Point;
use crate::scalar::Real;
use crate::vga3::Vector;

/// The triangle with these corners.
///
/// The line L passes through it where `L∧p∧q`, `L∧q∧r` and `L∧r∧p` have the same sign. They are
/// computed after a shear that maps the ray to a coordinate axis: each is then a difference of two
/// products, whose sign is right or zero, and the opposite for the neighbour of an edge.
impl<S: Real<Mask = bool>> Surface<S> for [Point<S>; 3] {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        let direction = Vector::from(ray.direction);
        let rotate = rotation_of_axes(direction);
        let along = rotate(direction);
        let (slope_x, slope_y) = (along.e1 / along.e3, along.e2 / along.e3);
        let from_origin = self.map(|corner| ray.origin.vector_to(corner));
        let [a, b, c] = from_origin.map(|corner| {
            let corner = rotate(corner);
            let x = corner.e1 - slope_x * corner.e3;
            let y = corner.e2 - slope_y * corner.e3;
            Vector::new(x, y, corner.e3)
        });
        let areas = Vector::new(area(b, c), area(c, a), area(a, b));
        let zero = S::zero();
        let [u, v, w] = areas.coordinates();
        let is_negative = u.less_than(zero) || v.less_than(zero) || w.less_than(zero);
        let is_positive = zero.less_than(u) || zero.less_than(v) || zero.less_than(w);
        if is_negative == is_positive {
            // Outside, or degenerate as seen along the ray.
            return None;
        }
        let height = areas.dot(Vector::new(a.e3, b.e3, c.e3));
        let distance = height / ((u + v + w) * along.e3);
        if !zero.less_than(distance) {
            return None;
        }
        let [p, q, r] = from_origin;
        let normal = (q - p).cross(r - p);
        Hit::of(ray, distance, normal, normal.dot(direction))
    }
}

/// The rotation of the coordinates by which the largest component of a direction becomes the third.
#[inline]
fn rotation_of_axes<S: Real<Mask = bool>>(direction: Vector<S>) -> impl Fn(Vector<S>) -> Vector<S> {
    let size = direction.abs();
    let is_first = size.e2.less_than(size.e1) && size.e3.less_than(size.e1);
    let is_second = !is_first && size.e3.less_than(size.e2);
    move |v: Vector<S>| {
        if is_first {
            Vector::new(v.e2, v.e3, v.e1)
        } else if is_second {
            Vector::new(v.e3, v.e1, v.e2)
        } else {
            v
        }
    }
}

/// Twice the signed area of the triangle with two corners and the origin, in the plane of the first
/// two coordinates.
#[inline]
fn area<S: Real>(a: Vector<S>, b: Vector<S>) -> S {
    a.e1 * b.e2 - a.e2 * b.e1
}
