//! Meets of circles with lines, planes, spheres and each other.

use super::spheres::{power_plane, same_radius, touch};
use super::{Meet, finite_point, less_square, pair, radius};
use crate::cga3::{Circle, Line, Plane, Point, PointPair, Sphere};
use crate::geometry::cga3::relation::figure_distance::{from_place, from_sphere};
use crate::geometry::relation::figure::sphere_parts;
use crate::geometry::relation::from_point::circle_parts;
use crate::geometry::relation::tolerance::{angle_within, within};
use crate::geometry::relation::{Figure, Tolerance};
use crate::scalar::Real;
use crate::vga3::Vector;

/// How a line and a circle meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineAndCircle<S> {
    /// In two points, in the order in which the line passes them. Line and circle are in one plane.
    Points(PointPair<S>),
    /// The line touches the circle in its plane, or passes a circle of radius zero in its plane.
    Tangent {
        /// The point of the line nearest to the centre.
        point: Point<S>,
        /// The unit direction of the line.
        direction: [S; 3],
    },
    /// The line crosses the plane of the circle in a point of the circle.
    Point(Point<S>),
    /// They are in one plane and do not meet: the imaginary pair about the point of the line
    /// nearest to the centre.
    Imaginary(PointPair<S>),
    /// They are not in one plane and do not meet.
    Apart,
}

/// How a plane and a circle meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneAndCircle<S> {
    /// In two points. The vector from the first to the second is along `m × n`, with the normal n
    /// of the circle and m of the plane.
    Points(PointPair<S>),
    /// The plane touches the circle.
    Tangent {
        /// The point where they touch.
        point: Point<S>,
        /// The unit direction of the tangent, oriented as the pair would be.
        direction: [S; 3],
    },
    /// The plane of the circle crosses the plane in a line that does not meet the circle: the
    /// imaginary pair about the point of that line nearest to the centre.
    Imaginary(PointPair<S>),
    /// The plane of the circle is parallel to the plane.
    Parallel {
        /// The height of the circle above the plane.
        distance: S,
    },
    /// The circle lies in the plane; its radius may be zero.
    Contained(Circle<S>),
}

/// How a sphere and a circle meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SphereAndCircle<S> {
    /// In two points. The vector from the first to the second is along `w × n`, where w is the
    /// vector from the centre of the circle to that of the sphere and n is the normal of the
    /// circle.
    Points(PointPair<S>),
    /// They touch: the nearest or the farthest point of the circle from the centre is on the
    /// sphere.
    Tangent {
        /// The point where they touch.
        point: Point<S>,
        /// The unit direction of the tangent, oriented as the pair would be.
        direction: [S; 3],
    },
    /// They do not meet: the imaginary pair on the line of equal power in the plane of the circle.
    Imaginary(PointPair<S>),
    /// The axis of the circle passes through the centre of the sphere, and they do not meet, not
    /// even at infinity.
    Concentric,
    /// The circle lies on the sphere; its radius may be zero.
    Contained(Circle<S>),
}

/// How two circles meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CircleAndCircle<S> {
    /// In two points, in one plane or in two. The vector from the first point to the second is, in
    /// one plane, along `w × n`, where w is the vector from the first centre to the second and n is
    /// the first normal; in two planes it is along `m × n` with the first normal n and the second
    /// m.
    Points(PointPair<S>),
    /// They touch in a point, where they have a common tangent; they are in one plane or in two.
    Tangent {
        /// The point where they touch.
        point: Point<S>,
        /// The unit direction of the tangent, oriented as the pair would be.
        direction: [S; 3],
    },
    /// They are in two planes and cross in one point, or one has radius zero and is on the other.
    Point(Point<S>),
    /// They are in one plane and do not meet: the imaginary pair on the line of equal power.
    Imaginary(PointPair<S>),
    /// They are in two planes and do not meet.
    Apart,
    /// They have the same centre and plane and different radii.
    Concentric,
    /// They are the same circle: the first is given.
    Coincident(Circle<S>),
}

impl<S: Real<Mask = bool>> Meet<Circle<S>> for Line<S> {
    type Scalar = S;
    type Outcome = LineAndCircle<S>;
    fn meet(self, circle: Circle<S>, tolerance: Tolerance<S>) -> Option<LineAndCircle<S>> {
        let ((start, direction), (centre, normal, squared)) =
            (self.parts()?, circle_parts(circle)?);
        let near = |x: S| within(x, tolerance.distance);
        let off = (centre - start).across(direction);
        let foot = centre - off;
        let slope = direction.dot(normal);
        let cosine = direction.cross(normal).length();
        let is_flat = angle_within(slope.abs(), cosine, tolerance.angle);
        if is_flat && near(off.dot(normal)) {
            let distance = off.length();
            if radius(squared, tolerance).is_some_and(|r| near(distance - r)) {
                let point = finite_point(foot)?;
                return Some(LineAndCircle::Tangent {
                    point,
                    direction: direction.into(),
                });
            }
            let half_squared = less_square(squared, distance);
            let pair = pair(foot, direction, half_squared)?;
            return Some(if half_squared.less_than(S::zero()) {
                LineAndCircle::Imaginary(pair)
            } else {
                LineAndCircle::Points(pair)
            });
        }
        let real = radius(squared, tolerance);
        if is_flat || real.is_none() {
            return Some(LineAndCircle::Apart);
        }
        let place = foot + direction * (off.dot(normal) / slope);
        let point = finite_point(place)?;
        let away = (place - centre).length();
        Some(if real.is_some_and(|r| near(away - r)) {
            LineAndCircle::Point(point)
        } else {
            LineAndCircle::Apart
        })
    }
}

impl<S: Real<Mask = bool>> Meet<Circle<S>> for Plane<S> {
    type Scalar = S;
    type Outcome = PlaneAndCircle<S>;
    fn meet(self, circle: Circle<S>, tolerance: Tolerance<S>) -> Option<PlaneAndCircle<S>> {
        let ((m, distance), (centre, normal, squared)) = (self.parts()?, circle_parts(circle)?);
        let near = |x: S| within(x, tolerance.distance);
        let height = centre.dot(m) - distance;
        let along = m.cross(normal);
        let sine = along.length();
        let real = radius(squared, tolerance);
        if real.is_some_and(|r| near(height.abs() + sine * r)) {
            return Some(PlaneAndCircle::Contained(circle));
        }
        if angle_within(sine, normal.dot(m).abs(), tolerance.angle) {
            return Some(if near(height) {
                PlaneAndCircle::Contained(circle)
            } else {
                PlaneAndCircle::Parallel { distance: height }
            });
        }
        // The point of the circle nearest to the plane, or farthest from it, is on its steepest
        // radius.
        let direction = along.divided(sine);
        let descent = normal.cross(direction);
        let reach = height / sine;
        let foot = centre - descent * reach;
        let touches = |r: S| near(height.abs() - r * sine);
        if real.is_some_and(touches) {
            let point = finite_point(foot)?;
            return Some(PlaneAndCircle::Tangent {
                point,
                direction: direction.into(),
            });
        }
        let half_squared = less_square(squared, reach.abs());
        let pair = pair(foot, direction, half_squared)?;
        Some(if half_squared.less_than(S::zero()) {
            PlaneAndCircle::Imaginary(pair)
        } else {
            PlaneAndCircle::Points(pair)
        })
    }
}

impl<S: Real<Mask = bool>> Meet<Circle<S>> for Sphere<S> {
    type Scalar = S;
    type Outcome = SphereAndCircle<S>;
    fn meet(self, circle: Circle<S>, tolerance: Tolerance<S>) -> Option<SphereAndCircle<S>> {
        let ((c, sphere_squared), (centre, normal, squared)) =
            (sphere_parts(self)?, circle_parts(circle)?);
        let near = |x: S| within(x, tolerance.distance);
        let from = c - centre;
        let flat = from.across(normal);
        let off = flat.length();
        let radii = radius(squared, tolerance).zip(radius(sphere_squared, tolerance));
        // The distances of the nearest and the farthest point of the circle from the sphere.
        let gaps = radii.and_then(|(r, s)| {
            let figure = Figure::Circle {
                centre,
                normal,
                radius: r,
            };
            Some(from_sphere(figure, c)?.map(|x| x - s))
        });
        if gaps.is_some_and(|[least, most]| near(least) && near(most)) {
            return Some(SphereAndCircle::Contained(circle));
        }
        if near(off) || off == S::zero() {
            return Some(SphereAndCircle::Concentric);
        }
        let out = flat.divided(off);
        let direction = out.cross(normal);
        if let Some(([least, most], (r, _))) = gaps.zip(radii)
            && (near(least) || near(most))
        {
            let reach = if near(least) { r } else { -r };
            let point = finite_point(centre + out * reach)?;
            return Some(SphereAndCircle::Tangent {
                point,
                direction: direction.into(),
            });
        }
        let cut = less_square(sphere_squared, from.dot(normal).abs());
        let (along, half_squared) = power_plane(off, squared, cut);
        let pair = pair(centre + out * along, direction, half_squared)?;
        Some(if half_squared.less_than(S::zero()) {
            SphereAndCircle::Imaginary(pair)
        } else {
            SphereAndCircle::Points(pair)
        })
    }
}

impl<S: Real<Mask = bool>> Meet<Circle<S>> for Circle<S> {
    type Scalar = S;
    type Outcome = CircleAndCircle<S>;
    fn meet(self, other: Self, tolerance: Tolerance<S>) -> Option<CircleAndCircle<S>> {
        let (a, n, a_squared) = circle_parts(self)?;
        let (b, m, b_squared) = circle_parts(other)?;
        let near = |x: S| within(x, tolerance.distance);
        let from = b - a;
        let sine = n.cross(m).length();
        let is_flat = angle_within(sine, n.dot(m).abs(), tolerance.angle)
            || near(sine * a_squared.max(b_squared).max(S::zero()).sqrt());
        if !is_flat {
            return in_two_planes(self, other, tolerance);
        }
        if !near(from.dot(n)) {
            return Some(CircleAndCircle::Apart);
        }
        let flat = from.across(n);
        let off = flat.length();
        if near(off) || off == S::zero() {
            return Some(if same_radius(a_squared, b_squared, tolerance) {
                CircleAndCircle::Coincident(self)
            } else {
                CircleAndCircle::Concentric
            });
        }
        let out = flat.divided(off);
        let direction = out.cross(n);
        let (along, half_squared) = power_plane(off, a_squared, b_squared);
        let place = a + out * along;
        if touch(off, a_squared, b_squared, tolerance) {
            let point = finite_point(place)?;
            return Some(CircleAndCircle::Tangent {
                point,
                direction: direction.into(),
            });
        }
        let pair = pair(place, direction, half_squared)?;
        Some(if half_squared.less_than(S::zero()) {
            CircleAndCircle::Imaginary(pair)
        } else {
            CircleAndCircle::Points(pair)
        })
    }
}

/// The points of the first circle in the plane of the second that are on the second.
fn in_two_planes<S: Real<Mask = bool>>(
    first: Circle<S>,
    second: Circle<S>,
    tolerance: Tolerance<S>,
) -> Option<CircleAndCircle<S>> {
    let (b, m, squared) = circle_parts(second)?;
    let Some(r) = radius(squared, tolerance) else {
        return Some(CircleAndCircle::Apart);
    };
    let plane = Plane::from_point_normal(b.into(), m.into());
    let figure = Figure::Circle {
        centre: b,
        normal: m,
        radius: r,
    };
    let is_on = |p: Point<S>| {
        let distance = from_place(figure, p.into());
        distance.is_some_and(|x| within(x, tolerance.distance))
    };
    Some(match plane.meet(first, tolerance)? {
        PlaneAndCircle::Points(pair) => {
            let [p, q] = pair.endpoints()?;
            match (is_on(p), is_on(q)) {
                (true, true) => CircleAndCircle::Points(pair),
                (true, false) => CircleAndCircle::Point(p),
                (false, true) => CircleAndCircle::Point(q),
                (false, false) => CircleAndCircle::Apart,
            }
        }
        PlaneAndCircle::Tangent { point, direction } if is_on(point) => {
            // The tangents coincide where that of the first, which is in both planes, is
            // perpendicular to the radius of the second.
            let arm = (Vector::from(point) - b).normalized();
            let tangent = Vector::from(direction);
            let lean = arm.map(|arm| arm.dot(tangent).abs().atan2(arm.cross(tangent).length()));
            if lean.is_none_or(|lean| within(lean, tolerance.angle)) {
                CircleAndCircle::Tangent { point, direction }
            } else {
                CircleAndCircle::Point(point)
            }
        }
        // A circle of radius zero.
        PlaneAndCircle::Contained(_) if is_on(first.centre()?) => {
            CircleAndCircle::Point(first.centre()?)
        }
        _ => CircleAndCircle::Apart,
    })
}
