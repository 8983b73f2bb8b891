//! Rays that hit triangles.

use super::{Hit, Ray, Surface};
use crate::cga3::Point;
use crate::scalar::{Lanes, Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

/// The triangle with these corners.
///
/// The line L passes through it where `L∧p∧q`, `L∧q∧r` and `L∧r∧p` have the same sign. They are
/// computed after a shear that maps the ray to a coordinate axis: each is then a difference of two
/// products, whose sign is right or zero, and the opposite for the neighbour of an edge.
impl<S: Real> Surface<S> for [Point<S>; 3] {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        let direction = Vector::from(ray.direction);
        let axis = main_axis(direction);
        let along = rotated(direction, axis);
        let slopes = [along.e1 / along.e3, along.e2 / along.e3];
        let from_origin = self.map(|corner| ray.origin.vector_to(corner));
        let corners = sheared(from_origin.map(|corner| rotated(corner, axis)), slopes);
        let areas = areas(corners);
        let is_crossed = is_inside(areas)
            .when(())
            .filter(|()| is_around_ray(corners));
        is_crossed.and_then(|()| {
            let distance = distance(areas, corners, along.e3);
            let is_ahead = S::zero().less_than(distance);
            is_ahead.when(()).and_then(|()| {
                // Not from the origin: a triangle without area has no normal as seen from anywhere.
                let normal = normal(self.map(Vector::from));
                Hit::of(ray, distance, normal, normal.dot(direction))
            })
        })
    }
}

/// A ray made ready for tests with many triangles, of which it takes several at a time in
/// [`Lanes`]; built by [`Ray::triangle_test`].
///
/// Each test decides as [`Ray::first_hit`] does for the corners of the triangle, and finds the same
/// distance, bit for bit. So there is no gap between triangles that share an edge.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_runtime::geometry::ray::Ray;
/// use ga_runtime::scalar::Lanes;
///
/// let ray = Ray::new(Point::new(1.0, 1.0, 3.0), [0.0, 0.0, -1.0]).unwrap();
/// // Two triangles at different heights; the second one has its corner r beside the ray.
/// let p = [[0.0, 0.0], [0.0, 0.0], [1.0, 2.0]].map(Lanes::from_array);
/// let q = [[4.0, 4.0], [0.0, 0.0], [1.0, 2.0]].map(Lanes::from_array);
/// let r = [[0.0, 4.0], [4.0, 0.5], [1.0, 2.0]].map(Lanes::from_array);
/// let crossing = ray.triangle_test().crossing(&[p, q, r]);
/// assert_eq!(crossing.is_hit.to_array(), [true, false]);
/// assert_eq!(crossing.distance[0], 2.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TriangleTest<S> {
    origin: [S; 3],
    slopes: [S; 2],
    along: S,
    /// The coordinates in the order in which the one along the ray comes last.
    axes: [usize; 3],
}

/// Where the line of a ray crosses triangles, one in each lane.
#[derive(Clone, Copy, Debug)]
pub struct Crossing<S: Real> {
    /// Whether the ray hits the triangle, at a distance of more than zero.
    pub is_hit: S::Mask,
    /// The distance along the ray. It has a meaning only where the triangle is hit.
    pub distance: S,
    /// The barycentric coordinates of the point times their sum, in the order of the corners. They
    /// have a meaning only where the triangle is hit.
    pub areas: [S; 3],
    /// The inner product of the direction with the normal `(q − p) × (r − p)` of the corners: less
    /// than zero where the ray comes from the front.
    pub slope: S,
}

impl<S: Real<Mask = bool>> Ray<S> {
    /// The ray made ready for tests with many triangles.
    #[inline]
    #[must_use]
    pub fn triangle_test(self) -> TriangleTest<S> {
        let direction = Vector::from(self.direction);
        let axis = main_axis(direction);
        let along = rotated(direction, axis);
        TriangleTest {
            origin: rotated(self.origin.into(), axis).coordinates(),
            slopes: [along.e1 / along.e3, along.e2 / along.e3],
            along: along.e3,
            axes: match axis {
                [true, _] => [1, 2, 0],
                [_, true] => [2, 0, 1],
                _ => [0, 1, 2],
            },
        }
    }
}

impl<S: Real<Mask = bool>> TriangleTest<S> {
    /// Where the ray crosses the triangles with these corners, given as the coordinates x, y and z
    /// of the first, second and third corners.
    #[inline(always)]
    #[must_use]
    pub fn crossing<const N: usize>(
        &self,
        corners: &[[Lanes<S, N>; 3]; 3],
    ) -> Crossing<Lanes<S, N>> {
        // Written out: closures over arrays of lanes are not always inlined.
        let [x, y, z] = self.axes;
        let [o1, o2, o3] = self.origin;
        let origin = Vector::from([Lanes::splat(o1), Lanes::splat(o2), Lanes::splat(o3)]);
        let [a, b, c] = corners;
        let from_origin = [
            Vector::from([a[x], a[y], a[z]]) - origin,
            Vector::from([b[x], b[y], b[z]]) - origin,
            Vector::from([c[x], c[y], c[z]]) - origin,
        ];
        let slopes = [Lanes::splat(self.slopes[0]), Lanes::splat(self.slopes[1])];
        let corners = sheared(from_origin, slopes);
        let areas = areas(corners);
        let along = Lanes::splat(self.along);
        let distance = distance(areas, corners, along);
        let is_ahead = Lanes::splat(S::zero()).less_than(distance);
        let mut is_hit = is_inside(areas) & is_ahead & (distance * distance).is_finite();
        // Few triangles come this far.
        if is_hit.any() {
            is_hit = is_hit
                & is_around_ray(corners)
                & has_normal([Vector::from(*a), Vector::from(*b), Vector::from(*c)]);
        }
        Crossing {
            is_hit,
            distance,
            areas: areas.coordinates(),
            slope: slope(areas, along),
        }
    }
}

/// The corners after the shear along the axis of the ray that maps the ray to that axis. They are
/// given from the origin of the ray, with the largest component of its direction as the third
/// coordinate.
#[inline(always)]
fn sheared<S: Real>(corners: [Vector<S>; 3], slopes: [S; 2]) -> [Vector<S>; 3] {
    let shear = |corner: Vector<S>| {
        let x = corner.e1 - slopes[0] * corner.e3;
        let y = corner.e2 - slopes[1] * corner.e3;
        Vector::new(x, y, corner.e3)
    };
    let [a, b, c] = corners;
    [shear(a), shear(b), shear(c)]
}

/// Twice the areas of the triangles that the ray forms with two of the sheared corners, seen along
/// it, opposite to each corner.
#[inline(always)]
fn areas<S: Real>([a, b, c]: [Vector<S>; 3]) -> Vector<S> {
    Vector::new(area(b, c), area(c, a), area(a, b))
}

/// Whether the ray passes through the box around the sheared corners, as seen along it. Where a
/// triangle is seen edge-on, rounded areas also have one sign beside it, on the line of the edge.
#[inline(always)]
fn is_around_ray<S: Real>([a, b, c]: [Vector<S>; 3]) -> S::Mask {
    let zero = S::zero();
    let are_negative = |a: S, b: S, c: S| a.less_than(zero) & b.less_than(zero) & c.less_than(zero);
    let are_positive = |a: S, b: S, c: S| zero.less_than(a) & zero.less_than(b) & zero.less_than(c);
    !(are_negative(a.e1, b.e1, c.e1)
        | are_positive(a.e1, b.e1, c.e1)
        | are_negative(a.e2, b.e2, c.e2)
        | are_positive(a.e2, b.e2, c.e2))
}

/// A normal of a triangle, with twice its area as length.
#[inline(always)]
fn normal<S: Real>([p, q, r]: [Vector<S>; 3]) -> Vector<S> {
    (q - p).cross(r - p)
}

/// Whether a triangle has a normal that is finite and not zero, without which it is not a surface.
#[inline(always)]
fn has_normal<S: Real>(corners: [Vector<S>; 3]) -> S::Mask {
    let zero = S::zero();
    let [x, y, z] = normal(corners).abs().coordinates();
    let is_finite = x.is_finite() & y.is_finite() & z.is_finite();
    is_finite & (zero.less_than(x) | zero.less_than(y) | zero.less_than(z))
}

/// Whether the areas have one sign, as far as they have one, and are not all zero, as those of a
/// triangle are that is degenerate as seen along the ray.
#[inline(always)]
fn is_inside<S: Real>(areas: Vector<S>) -> S::Mask {
    let [u, v, w] = areas.coordinates();
    let zero = S::zero();
    let is_negative = u.less_than(zero) | v.less_than(zero) | w.less_than(zero);
    let is_positive = zero.less_than(u) | zero.less_than(v) | zero.less_than(w);
    (is_negative | is_positive) & !(is_negative & is_positive)
}

/// The distance along the ray: the mean of the corners' heights, weighted by the areas.
#[inline(always)]
fn distance<S: Real>(areas: Vector<S>, [a, b, c]: [Vector<S>; 3], along: S) -> S {
    areas.dot(Vector::new(a.e3, b.e3, c.e3)) / slope(areas, along)
}

/// The inner product of the direction with the normal of the triangle, whose component along the
/// axis of the ray the shear keeps.
#[inline(always)]
fn slope<S: Real>(areas: Vector<S>, along: S) -> S {
    (areas.e1 + areas.e2 + areas.e3) * along
}

/// Whether the largest component of a direction is the first, and whether it is the second.
#[inline]
fn main_axis<S: Real>(direction: Vector<S>) -> [S::Mask; 2] {
    let size = direction.abs();
    let is_first = size.e2.less_than(size.e1) & size.e3.less_than(size.e1);
    [is_first, !is_first & size.e3.less_than(size.e2)]
}

/// The rotation of the coordinates by which that component becomes the third.
#[inline]
fn rotated<S: Real>(v: Vector<S>, [is_first, is_second]: [S::Mask; 2]) -> Vector<S> {
    let (first, second) = (is_first.when(()), is_second.when(()));
    first
        .map(|()| Vector::new(v.e2, v.e3, v.e1))
        .or_else(|| second.map(|()| Vector::new(v.e3, v.e1, v.e2)))
        .unwrap_or(v)
}

/// Twice the signed area of the triangle with two corners and the origin, in the plane of the first
/// two coordinates.
#[inline(always)]
fn area<S: Real>(a: Vector<S>, b: Vector<S>) -> S {
    a.e1 * b.e2 - a.e2 * b.e1
}
