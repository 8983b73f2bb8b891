//! Meets of spheres with lines, planes and each other.

use super::{Meet, circle, finite_point, less_square, pair, radius};
use crate::cga3::{
    Circle, Direction, DualPlane, DualSphere, Line, Plane, Point, PointPair, Sphere,
};
use crate::geometry::number::is_regular;
use crate::geometry::relation::Tolerance;
use crate::geometry::relation::figure::{regular_sphere, sphere_parts};
use crate::geometry::relation::tolerance::within;
use crate::scalar::Real;
use crate::vga3::Vector;

/// How a line and a sphere meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineAndSphere<S> {
    /// In two points, in the order in which the line passes them: a negative multiple of `L ∨ S`. A
    /// line extends both ways; for a ray, use only the points ahead of its origin.
    Points(PointPair<S>),
    /// The line touches the sphere, or passes through a sphere of radius zero.
    Tangent {
        /// The point of the line nearest to the centre.
        point: Point<S>,
        /// The unit direction of the line.
        direction: [S; 3],
    },
    /// They do not meet: the imaginary pair about the point of the line nearest to the centre.
    Imaginary(PointPair<S>),
}

/// How a plane and a sphere meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneAndSphere<S> {
    /// In a circle. Its normal is that of the plane for `sphere.meet(plane)`, the opposite for
    /// `plane.meet(sphere)`.
    Circle(Circle<S>),
    /// The plane touches the sphere, or contains a sphere of radius zero.
    Tangent {
        /// The point of the plane nearest to the centre.
        point: Point<S>,
        /// The unit normal, as that of the circle would be.
        normal: [S; 3],
    },
    /// They do not meet: the imaginary circle about the point of the plane nearest to the centre.
    Imaginary(Circle<S>),
}

/// How two spheres meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SphereAndSphere<S> {
    /// In a circle. Its normal points from the centre of the first to that of the second.
    Circle(Circle<S>),
    /// They touch, from the inside or from the outside.
    Tangent {
        /// The point where they touch, in the plane that the circle would be in.
        point: Point<S>,
        /// The unit normal of both, as that of the circle would be.
        normal: [S; 3],
    },
    /// They do not meet: the imaginary circle of all spheres through both, in the plane of points
    /// with equal power.
    Imaginary(Circle<S>),
    /// They have the same centre and different radii, and do not meet, not even at infinity.
    Concentric,
    /// They are the same sphere: the first is given.
    Coincident(Sphere<S>),
}

impl<S: Real<Mask = bool>> Meet<Sphere<S>> for Line<S> {
    type Scalar = S;
    type Outcome = LineAndSphere<S>;
    #[inline(always)]
    fn meet(self, sphere: Sphere<S>, tolerance: Tolerance<S>) -> Option<LineAndSphere<S>> {
        let (d, m) = self.vectors();
        let square = d.length_squared();
        if let Some((centre, squared)) = regular_sphere(sphere)
            && is_regular(square)
        {
            let inverse = square.sqrt().recip();
            let direction = d * inverse;
            // The moment about the centre.
            let moment = (m - centre.cross(d)) * inverse;
            let foot = centre + direction.cross(moment);
            let (radius, distance) = (squared.sqrt(), moment.length_squared().sqrt());
            let within = radius - distance;
            if tolerance.distance.less_than(within.abs())
                && let Some(pair) = PointPair::around(foot, direction, within * (radius + distance))
            {
                return Some(if within.less_than(S::zero()) {
                    LineAndSphere::Imaginary(pair)
                } else {
                    LineAndSphere::Points(pair)
                });
            }
        }
        let (centre, squared) = sphere_parts(sphere)?;
        let line = [d, m].map(Vector::coordinates);
        Some(
            match near_line_and_sphere(line, centre.into(), squared, tolerance)? {
                (Case::Tangent, c) => LineAndSphere::Tangent {
                    point: Point::new(c[0], c[1], c[2]),
                    direction: [c[3], c[4], c[5]],
                },
                (Case::Real, c) => LineAndSphere::Points(pair_of(c)),
                (Case::Imaginary, c) => LineAndSphere::Imaginary(pair_of(c)),
            },
        )
    }
}

/// The meet of a line, by direction and moment, and a sphere, by centre and squared radius.
#[cold]
#[inline(never)]
fn near_line_and_sphere<S: Real<Mask = bool>>(
    [d, m]: [[S; 3]; 2],
    centre: [S; 3],
    squared: S,
    tolerance: Tolerance<S>,
) -> Option<(Case, [S; 7])> {
    let centre = Vector::from(centre);
    let (start, direction) = Line::from_vectors(d.into(), m.into()).parts()?;
    let off = (centre - start).across(direction);
    let foot = centre - off;
    let distance = off.length();
    let is_tangent = |r: S| within(distance - r, tolerance.distance);
    if radius(squared, tolerance).is_some_and(is_tangent) {
        return tangent(foot, direction);
    }
    let half_squared = less_square(squared, distance);
    let PointPair {
        centre, direction, ..
    } = pair(foot, direction, half_squared)?;
    Some((
        Case::of(half_squared),
        numbers(centre, direction, half_squared),
    ))
}

impl<S: Real<Mask = bool>> Meet<Sphere<S>> for Plane<S> {
    type Scalar = S;
    type Outcome = PlaneAndSphere<S>;
    #[inline(always)]
    fn meet(self, sphere: Sphere<S>, tolerance: Tolerance<S>) -> Option<PlaneAndSphere<S>> {
        plane_and_sphere(self, sphere, tolerance, -S::one())
    }
}

impl<S: Real<Mask = bool>> Meet<Plane<S>> for Sphere<S> {
    type Scalar = S;
    type Outcome = PlaneAndSphere<S>;
    #[inline(always)]
    fn meet(self, plane: Plane<S>, tolerance: Tolerance<S>) -> Option<PlaneAndSphere<S>> {
        plane_and_sphere(plane, self, tolerance, S::one())
    }
}

#[inline(always)]
fn plane_and_sphere<S: Real<Mask = bool>>(
    plane: Plane<S>,
    sphere: Sphere<S>,
    tolerance: Tolerance<S>,
    sign: S,
) -> Option<PlaneAndSphere<S>> {
    let (n, number) = plane.vectors();
    let square = n.length_squared();
    if let Some((centre, squared)) = regular_sphere(sphere)
        && is_regular(square)
    {
        let inverse = square.sqrt().recip();
        let normal = n * inverse;
        let height = (n.dot(centre) - number) * inverse;
        let (radius, distance) = (squared.sqrt(), height.abs());
        let within = radius - distance;
        if tolerance.distance.less_than(within.abs())
            && let Some(circle) = Circle::around(
                centre - normal * height,
                normal * sign,
                within * (radius + distance),
            )
        {
            return Some(if within.less_than(S::zero()) {
                PlaneAndSphere::Imaginary(circle)
            } else {
                PlaneAndSphere::Circle(circle)
            });
        }
    }
    let (centre, squared) = sphere_parts(sphere)?;
    let (plane, sphere) = ((n.into(), number), (centre.into(), squared));
    Some(
        match near_plane_and_sphere(plane, sphere, tolerance, sign)? {
            (Case::Tangent, c) => PlaneAndSphere::Tangent {
                point: Point::new(c[0], c[1], c[2]),
                normal: [c[3], c[4], c[5]],
            },
            (Case::Real, c) => PlaneAndSphere::Circle(circle_of(c)),
            (Case::Imaginary, c) => PlaneAndSphere::Imaginary(circle_of(c)),
        },
    )
}

/// The meet of a plane, by normal and distance, and a sphere, by centre and squared radius.
#[cold]
#[inline(never)]
fn near_plane_and_sphere<S: Real<Mask = bool>>(
    (normal, number): ([S; 3], S),
    (centre, squared): ([S; 3], S),
    tolerance: Tolerance<S>,
    sign: S,
) -> Option<(Case, [S; 7])> {
    let plane = DualPlane::from_normal_distance(normal, number).undual();
    let (normal, distance) = plane.parts()?;
    let centre = Vector::from(centre);
    let height = centre.dot(normal) - distance;
    let foot = centre - normal * height;
    let normal = normal * sign;
    let is_tangent = |r: S| within(height.abs() - r, tolerance.distance);
    if radius(squared, tolerance).is_some_and(is_tangent) {
        return tangent(foot, normal);
    }
    let circle_squared = less_square(squared, height.abs());
    let Circle { centre, normal, .. } = circle(foot, normal, circle_squared)?;
    Some((
        Case::of(circle_squared),
        numbers(centre, normal, circle_squared),
    ))
}

/// The cases in which a sphere meets a line or a plane.
#[derive(Clone, Copy)]
enum Case {
    Tangent,
    Real,
    Imaginary,
}

impl Case {
    fn of<S: Real<Mask = bool>>(radius_squared: S) -> Self {
        if radius_squared.less_than(S::zero()) {
            Self::Imaginary
        } else {
            Self::Real
        }
    }
}

// Outlined code returns centre, direction and squared radius as an array, so that those of its
// callers stay in registers.

fn tangent<S: Real<Mask = bool>>(place: Vector<S>, way: Vector<S>) -> Option<(Case, [S; 7])> {
    let way = Direction::from_vector(way.into());
    Some((Case::Tangent, numbers(finite_point(place)?, way, S::zero())))
}

fn numbers<S: Real>(centre: Point<S>, direction: Direction<S>, squared: S) -> [S; 7] {
    let ([x, y, z], [u, v, w]) = (centre.coordinates(), direction.vector());
    [x, y, z, u, v, w, squared]
}

#[inline(always)]
fn pair_of<S: Real>([x, y, z, u, v, w, squared]: [S; 7]) -> PointPair<S> {
    PointPair::new(Point::new(x, y, z), Direction::new(u, v, w), squared)
}

#[inline(always)]
fn circle_of<S: Real>([x, y, z, u, v, w, squared]: [S; 7]) -> Circle<S> {
    Circle::new(Point::new(x, y, z), Direction::new(u, v, w), squared)
}

impl<S: Real<Mask = bool>> Meet<Sphere<S>> for Sphere<S> {
    type Scalar = S;
    type Outcome = SphereAndSphere<S>;
    #[inline(always)]
    fn meet(self, other: Self, tolerance: Tolerance<S>) -> Option<SphereAndSphere<S>> {
        if let (Some((a, a_squared)), Some((b, b_squared))) =
            (regular_sphere(self), regular_sphere(other))
        {
            let way = b - a;
            let square = way.length_squared();
            let distance = square.sqrt();
            let inverse = distance.recip();
            let way = way * inverse;
            let along = (distance + (a_squared - b_squared) * inverse) * S::from_ratio(1, 2);
            let (r, s) = (a_squared.sqrt(), b_squared.sqrt());
            let is_far = |x: S| tolerance.distance.less_than(x.abs());
            // As in `power_plane`.
            let (radius, height) = if s.less_than(r) {
                (s, (distance - along).abs())
            } else {
                (r, along.abs())
            };
            let squared = (radius - height) * (radius + height);
            let is_apart =
                is_far(distance) & is_far(distance - (r + s)) & is_far(distance - (r - s).abs());
            if (is_regular(square) & is_apart)
                && let Some(circle) = Circle::around(a + way * along, way, squared)
            {
                return Some(if squared.less_than(S::zero()) {
                    SphereAndSphere::Imaginary(circle)
                } else {
                    SphereAndSphere::Circle(circle)
                });
            }
        }
        near_spheres([self.dual(), other.dual()], tolerance)
    }
}

/// The meet of spheres that may touch, or coincide, or have an imaginary radius.
#[cold]
#[inline(never)]
fn near_spheres<S: Real<Mask = bool>>(
    dual: [DualSphere<S>; 2],
    tolerance: Tolerance<S>,
) -> Option<SphereAndSphere<S>> {
    let [sphere, other] = dual.map(DualSphere::undual);
    let ((a, a_squared), (b, b_squared)) = (sphere_parts(sphere)?, sphere_parts(other)?);
    let way = b - a;
    let distance = way.length();
    if within(distance, tolerance.distance) || distance == S::zero() {
        return Some(if same_radius(a_squared, b_squared, tolerance) {
            SphereAndSphere::Coincident(sphere)
        } else {
            SphereAndSphere::Concentric
        });
    }
    let way = way.divided(distance);
    let (along, squared) = power_plane(distance, a_squared, b_squared);
    let place = a + way * along;
    if touch(distance, a_squared, b_squared, tolerance) {
        let point = finite_point(place)?;
        return Some(SphereAndSphere::Tangent {
            point,
            normal: way.into(),
        });
    }
    let circle = circle(place, way, squared)?;
    Some(if squared.less_than(S::zero()) {
        SphereAndSphere::Imaginary(circle)
    } else {
        SphereAndSphere::Circle(circle)
    })
}

/// Where two spheres meet, or two circles in one plane: the distance from the first of the centres,
/// towards the second, of the plane of points of equal power, `(d² + r² − s²)/(2 d)`, and the
/// squared radius there.
///
/// That is read about the smaller sphere: from the square of the larger it would have an error
/// that its own size does not explain.
#[inline]
pub(super) fn power_plane<S: Real<Mask = bool>>(
    distance: S,
    squared: S,
    other_squared: S,
) -> (S, S) {
    let along = (distance + (squared - other_squared) / distance) * S::from_ratio(1, 2);
    let (smaller, height) = if other_squared.less_than(squared) {
        (other_squared, distance - along)
    } else {
        (squared, along)
    };
    (along, less_square(smaller, height.abs()))
}

/// Whether two radii, both real or both imaginary, are equal within the tolerance.
#[inline]
pub(super) fn same_radius<S: Real<Mask = bool>>(a: S, b: S, tolerance: Tolerance<S>) -> bool {
    match (radius(a, tolerance), radius(b, tolerance)) {
        (Some(r), Some(s)) => within(r - s, tolerance.distance),
        (None, None) => within((-a).sqrt() - (-b).sqrt(), tolerance.distance),
        _ => false,
    }
}

/// Whether two spheres, or circles in one plane, touch from the inside or from the outside.
#[inline]
pub(super) fn touch<S: Real<Mask = bool>>(
    distance: S,
    squared: S,
    other_squared: S,
    tolerance: Tolerance<S>,
) -> bool {
    let radii = radius(squared, tolerance).zip(radius(other_squared, tolerance));
    radii.is_some_and(|(r, s)| {
        within(distance - (r + s), tolerance.distance)
            || within(distance - (r - s).abs(), tolerance.distance)
    })
}
