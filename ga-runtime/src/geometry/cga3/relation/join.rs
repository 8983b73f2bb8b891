//! Joins: the smallest primitive that contains two others.
//!
//! In blades the join of two primitives that share nothing is their outer product: `p∧q∧ei` is the
//! line through two points, `p∧L` the plane of a point and a line, `C∧p` a sphere. Where they share
//! a subspace the outer product vanishes, and the join is found by cases. These are the possible
//! results, from general to special positions:
//!
//! - Point and point: line; point. Point and point pair: circle; line; pair. Point and line: plane;
//!   line. Point and circle: sphere; plane; circle.
//! - Pair and pair: sphere; plane; circle; line; pair. Pair and line: plane; line; space. Pair and
//!   circle: sphere; plane; circle; space.
//! - Line and line: plane; line; space. Line and circle: plane; space.
//! - Circle and circle: sphere; plane; circle; space.
//! - Point, pair, line or circle and a plane or sphere: space, or the plane or sphere if it
//!   contains the other.
//!
//! So a circle and a point in its plane give that plane, collinear points a line, and where one
//! contains the other, the join is that one. Skew lines, a line and a circle that are not coplanar,
//! and circles without a common sphere join to all of space, and so do two surfaces unless they
//! coincide.
//!
//! The distance of the tolerance decides whether one lies on the other, as in
//! [`incidence`](super::incidence), and its angle decides whether lines are parallel. A point pair,
//! a circle or a sphere whose radius is not larger than the distance is treated as its centre.
//!
//! Either operand may be in dual form; the result is in direct form and has weight 1. Where the
//! outer product of both direct forms, in the order of the call, does not vanish (for two points:
//! the outer product with infinity), the result is a positive multiple of it. Otherwise the result
//! has the orientation of the operand that it equals or, for lines and circles in one plane, of the
//! first of them.
//!
//! It is `None` where one of the two is not a [`Figure`], or where the join is beyond the range of
//! the scalar.
//!
//! ```
//! use ga_runtime::cga3::{Circle, Line, Point};
//! use ga_runtime::geometry::relation::{Tolerance, join::Join};
//!
//! let tolerance = Tolerance::default();
//! let [p, q, r] = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-2.0, 0.0, 0.0]].map(Point::from);
//! assert!(matches!(p.join(q, tolerance), Some(Join::Line(_))));
//! assert_eq!(p.join(p, tolerance), Some(Join::Point(p)));
//!
//! let circle = Circle::through(p, q, r);
//! match circle.join(Point::new(0.0, 0.0, 4.0), tolerance) {
//!     Some(Join::Sphere(sphere)) => assert_eq!(sphere.radius(), Some(2.5)),
//!     other => panic!("{other:?}"),
//! }
//! assert!(matches!(circle.join(Point::default(), tolerance), Some(Join::Plane(_))));
//! let axis = Line::from_point_direction(p, [0.0, 0.0, 1.0]);
//! assert_eq!(axis.join(circle, tolerance), Some(Join::Space));
//! ```

use super::figure_distance::{distance, from_place, searched};
use super::figure_incidence::is_on;
use super::tolerance::{angle_within, within};
use super::{Figure, Primitive, Tolerance, hypotenuse, parallel};
use crate::cga3::{
    Bivector, Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint,
    Line, MotorGenerator, Plane, Point, PointPair, Quadvector, Sphere, Trivector,
};
use crate::scalar::Real;
use crate::vga3::Vector;

/// The smallest primitive that contains two others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Join<S> {
    /// A point: both primitives are this point.
    Point(Point<S>),
    /// A point pair, which contains the other primitive.
    PointPair(PointPair<S>),
    /// A line.
    Line(Line<S>),
    /// A circle.
    Circle(Circle<S>),
    /// A plane.
    Plane(Plane<S>),
    /// A sphere.
    Sphere(Sphere<S>),
    /// All of space: nothing smaller contains both.
    Space,
}

macro_rules! joins {
    ($($Primitive:ident)*) => {$(
        impl<S: Real<Mask = bool>> $Primitive<S> {
            /// The smallest primitive that contains this one and the other; see
            /// [`join`](crate::geometry::relation::join). `None` where one is not a figure or the
            /// join is beyond the range of the scalar.
            #[must_use]
            pub fn join<T: Primitive<S>>(self, other: T, tolerance: Tolerance<S>) -> Option<Join<S>> {
                join(self.figure()?, other.figure()?, tolerance)
            }
        }
    )*};
}

joins! {
    Point FlatPoint PointPair Line Plane Circle Sphere Bivector Trivector Quadvector
    DualFlatPoint DualPointPair MotorGenerator DualPlane DualCircle DualSphere
}

/// The index of a figure in the order point, point pair, line, circle, plane, sphere.
fn rank<S>(figure: Figure<S>) -> usize {
    match figure {
        Figure::Point(_) => 0,
        Figure::PointPair(_) => 1,
        Figure::Line { .. } => 2,
        Figure::Circle { .. } => 3,
        Figure::Plane { .. } => 4,
        Figure::Sphere { .. } => 5,
    }
}

/// A figure, or its centre where it is not larger than the tolerance.
fn reduced<S: Real<Mask = bool>>(figure: Figure<S>, tolerance: Tolerance<S>) -> Figure<S> {
    match figure {
        Figure::PointPair([p, q]) if within((q - p).length(), tolerance.distance) => {
            Figure::Point(middle(p, q))
        }
        Figure::Circle { centre, radius, .. } | Figure::Sphere { centre, radius }
            if within(radius, tolerance.distance) =>
        {
            Figure::Point(centre)
        }
        _ => figure,
    }
}

fn join<S: Real<Mask = bool>>(
    a: Figure<S>,
    b: Figure<S>,
    tolerance: Tolerance<S>,
) -> Option<Join<S>> {
    let [a, b] = [a, b].map(|figure| reduced(figure, tolerance));
    // If one contains the other, it is the join; of two that coincide, the first.
    if is_on(b, a, tolerance) {
        return itself(a);
    }
    if is_on(a, b, tolerance) {
        return itself(b);
    }
    let (one, minus) = (S::one(), -S::one());
    if rank(b) < rank(a) {
        // The outer product changes sign where both grades are odd: point and line, point and
        // circle.
        let sign = match b {
            Figure::Point(_) => minus,
            _ => one,
        };
        return span(b, a, tolerance, sign);
    }
    span(a, b, tolerance, one)
}

/// The join of two figures in the order of their ranks, neither of which is on the other. The sign
/// is −1 if this order changes the sign of the outer product.
fn span<S: Real<Mask = bool>>(
    a: Figure<S>,
    b: Figure<S>,
    tolerance: Tolerance<S>,
    sign: S,
) -> Option<Join<S>> {
    use Figure::{Circle, Line, Point, PointPair};
    match (a, b) {
        (Point(p), Point(q)) => line(p, q - p),
        (Point(p), PointPair([q, r])) => three_points([q, r, p], tolerance),
        (Point(p), Line { point, direction }) => plane(p, (point - p).cross(direction) * sign),
        (
            Point(p),
            Circle {
                centre,
                normal,
                radius,
            },
        ) => {
            if within((p - centre).dot(normal), tolerance.distance) {
                return plane(centre, normal);
            }
            let above = Above::new(centre, normal, radius, p);
            above.to_sphere(-sign)
        }
        (PointPair(first), PointPair(second)) => four_points(first, second, tolerance),
        (PointPair(pair), Line { point, direction }) => {
            pair_and_line(pair, point, direction, tolerance)
        }
        (
            PointPair([p, q]),
            Circle {
                centre,
                normal,
                radius,
            },
        ) => {
            let height = |x: Vector<S>| (x - centre).dot(normal).abs();
            let (farther, other) = if height(p).less_than(height(q)) {
                (q, p)
            } else {
                (p, q)
            };
            if within(height(farther), tolerance.distance) {
                return plane(centre, normal);
            }
            Above::new(centre, normal, radius, farther).holding(Point(other), tolerance)
        }
        (
            Line { point, direction },
            Line {
                point: q,
                direction: e,
            },
        ) => two_lines([point, direction], [q, e], tolerance),
        (Line { .. }, Circle { centre, normal, .. }) => {
            let distance = normal.dot(centre);
            if is_on(a, Figure::Plane { normal, distance }, tolerance) {
                plane(centre, normal)
            } else {
                Some(Join::Space)
            }
        }
        (
            Circle {
                centre,
                normal,
                radius,
            },
            Circle { .. },
        ) => {
            let farthest = farthest_from_plane(b, centre, normal)?;
            if within((farthest - centre).dot(normal), tolerance.distance) {
                return plane(centre, normal);
            }
            Above::new(centre, normal, radius, farthest).holding(b, tolerance)
        }
        _ => Some(Join::Space),
    }
}

/// The plane of a line and the point of a pair that is farther from it, if it contains the other
/// point.
fn pair_and_line<S: Real<Mask = bool>>(
    [p, q]: [Vector<S>; 2],
    point: Vector<S>,
    direction: Vector<S>,
    tolerance: Tolerance<S>,
) -> Option<Join<S>> {
    let [p_arm, q_arm] = [p, q].map(|x| (x - point).across(direction));
    let (farther, other) = if p_arm.length().less_than(q_arm.length()) {
        (q_arm, p)
    } else {
        (p_arm, q)
    };
    let normal = direction.cross(farther).normalized()?;
    if within((other - point).dot(normal), tolerance.distance) {
        plane(point, normal)
    } else {
        Some(Join::Space)
    }
}

/// The plane of two lines, each given by a point and its unit direction, if they are parallel or
/// meet.
fn two_lines<S: Real<Mask = bool>>(
    [p, d]: [Vector<S>; 2],
    [q, e]: [Vector<S>; 2],
    tolerance: Tolerance<S>,
) -> Option<Join<S>> {
    let normal = d.cross(e);
    if angle_within(normal.length(), d.dot(e).abs(), tolerance.angle) {
        return plane(p, d.cross(q - p));
    }
    let [first, second] =
        [(p, d), (q, e)].map(|(point, direction)| Figure::Line { point, direction });
    if within(distance(first, second, searched)?, tolerance.distance) {
        let midway = middle(p, p + along(q - p, normal));
        plane(midway, normal)
    } else {
        Some(Join::Space)
    }
}

/// The point of a circle that is farthest from a plane: along its steepest radius; any point if the
/// planes are parallel.
fn farthest_from_plane<S: Real<Mask = bool>>(
    circle: Figure<S>,
    place: Vector<S>,
    normal: Vector<S>,
) -> Option<Vector<S>> {
    let Figure::Circle {
        centre,
        normal: m,
        radius,
    } = circle
    else {
        return None;
    };
    let tilt = normal.across(m);
    let steepest = if tilt.length().less_than(parallel()) {
        m.orthonormal_pair()[0]
    } else {
        // Projected twice, to remove what rounding has left along the normal.
        tilt.normalized()?.across(m).normalized()?
    };
    let height = |x: Vector<S>| (x - place).dot(normal).abs();
    let [up, down] = [radius, -radius].map(|r| centre + steepest * r);
    Some(if height(up).less_than(height(down)) {
        down
    } else {
        up
    })
}

/// The sphere through a circle and a point off its plane.
struct Above<S> {
    centre: Vector<S>,
    radius: S,
    /// The height of the point above the plane of the circle, for the orientation.
    height: S,
}

impl<S: Real<Mask = bool>> Above<S> {
    fn new(centre: Vector<S>, normal: Vector<S>, radius: S, point: Vector<S>) -> Self {
        let from = point - centre;
        let height = from.dot(normal);
        // The centre of the sphere is t above that of the circle, where w² − 2 t h = r² with w from
        // there to the point.
        let reach = from.across(normal).length();
        let up = (height + (reach - radius) * ((reach + radius) / height)) * S::from_ratio(1, 2);
        Self {
            centre: centre + normal * up,
            radius: hypotenuse(up, radius),
            height,
        }
    }

    /// A multiple of circle∧point, positive or negative as the sign.
    fn to_sphere(&self, sign: S) -> Option<Join<S>> {
        sphere(self.centre, self.radius, self.height * sign)
    }

    /// The sphere if it contains a figure.
    fn holding(&self, figure: Figure<S>, tolerance: Tolerance<S>) -> Option<Join<S>> {
        let Self { centre, radius, .. } = *self;
        if is_on(figure, Figure::Sphere { centre, radius }, tolerance) {
            sphere(centre, radius, S::one())
        } else {
            Some(Join::Space)
        }
    }
}

fn three_points<S: Real<Mask = bool>>(
    [p, q, r]: [Vector<S>; 3],
    tolerance: Tolerance<S>,
) -> Option<Join<S>> {
    match through([p, q, r], tolerance)? {
        Some(Figure::Circle {
            centre,
            normal,
            radius,
        }) => circle(centre, normal, radius),
        _ => line(p, q - p),
    }
}

fn four_points<S: Real<Mask = bool>>(
    [p, q]: [Vector<S>; 2],
    [r, s]: [Vector<S>; 2],
    tolerance: Tolerance<S>,
) -> Option<Join<S>> {
    let direction = (q - p).normalized()?;
    let off = |x: Vector<S>| (x - p).across(direction).length();
    // The point of the second pair that makes the better-conditioned triangle comes first;
    // exchanging the two points changes the sign.
    let (third, fourth, sign) = if off(r).less_than(off(s)) {
        (s, r, -S::one())
    } else {
        (r, s, S::one())
    };
    let Some(found) = through([p, q, third], tolerance)? else {
        return line(p, direction);
    };
    let Figure::Circle {
        centre,
        normal,
        radius,
    } = found
    else {
        return None;
    };
    let near = |x: S| within(x, tolerance.distance);
    if near(from_place(found, fourth)?) {
        circle(centre, normal, radius)
    } else if near((fourth - centre).dot(normal)) {
        plane(centre, normal)
    } else {
        Above::new(centre, normal, radius, fourth).to_sphere(sign)
    }
}

/// The circle through three points; `Some(None)` where the third is on the line through the others,
/// and `None` where the first two coincide.
fn through<S: Real<Mask = bool>>(
    [p, q, r]: [Vector<S>; 3],
    tolerance: Tolerance<S>,
) -> Option<Option<Figure<S>>> {
    let (u, v) = (q - p, r - p);
    let direction = u.normalized()?;
    if within(v.across(direction).length(), tolerance.distance) {
        return Some(None);
    }
    let normal = u.cross(v).normalized()?;
    // In the plane of the triangle: from p by half of the first side, then perpendicular to it up
    // to the point at equal distances from p and r.
    let side = normal.cross(direction);
    let (x, y) = (v.dot(direction), v.dot(side));
    let half = u.dot(direction) * S::from_ratio(1, 2);
    let up = (y + x * ((x - half - half) / y)) * S::from_ratio(1, 2);
    let centre = p + (direction * half + side * up);
    let radius = hypotenuse(half, up);
    let circle = Figure::Circle {
        centre,
        normal,
        radius,
    };
    let finite = centre.is_finite() && radius.is_finite();
    finite.then_some(Some(circle))
}

fn middle<S: Real>(p: Vector<S>, q: Vector<S>) -> Vector<S> {
    p + (q - p) * S::from_ratio(1, 2)
}

/// The component of a vector along another vector that is not zero.
fn along<S: Real<Mask = bool>>(v: Vector<S>, other: Vector<S>) -> Vector<S> {
    other.normalized().map_or(other, |unit| unit * v.dot(unit))
}

/// The primitive of a figure.
fn itself<S: Real<Mask = bool>>(figure: Figure<S>) -> Option<Join<S>> {
    match figure {
        Figure::Point(p) => Some(Join::Point(Point::from(p))),
        Figure::PointPair([p, q]) => {
            let half = (q - p).length() * S::from_ratio(1, 2);
            let centre = Point::from(middle(p, q));
            let pair =
                PointPair::from_centre_axis_radius_squared(centre, (q - p).into(), half * half);
            pair.map(Join::PointPair)
        }
        Figure::Line { point, direction } => line(point, direction),
        Figure::Circle {
            centre,
            normal,
            radius,
        } => circle(centre, normal, radius),
        Figure::Plane { normal, distance } => plane(normal * distance, normal),
        Figure::Sphere { centre, radius } => sphere(centre, radius, S::one()),
    }
}

fn line<S: Real<Mask = bool>>(point: Vector<S>, direction: Vector<S>) -> Option<Join<S>> {
    let line = Line::from_point_direction(point.into(), direction.normalized()?.into());
    Vector::from(line.moment())
        .is_finite()
        .then_some(Join::Line(line))
}

fn circle<S: Real<Mask = bool>>(
    centre: Vector<S>,
    normal: Vector<S>,
    radius: S,
) -> Option<Join<S>> {
    Circle::from_centre_normal_radius(centre.into(), normal.into(), radius).map(Join::Circle)
}

fn plane<S: Real<Mask = bool>>(point: Vector<S>, normal: Vector<S>) -> Option<Join<S>> {
    let plane = Plane::from_point_normal(point.into(), normal.normalized()?.into());
    plane.figure().map(|_| Join::Plane(plane))
}

/// The sphere about a centre, or minus it.
fn sphere<S: Real<Mask = bool>>(centre: Vector<S>, radius: S, sign: S) -> Option<Join<S>> {
    let sphere = Sphere::from_centre_radius(Point::from(centre), radius);
    let oriented = if sign.less_than(S::zero()) {
        -sphere
    } else {
        sphere
    };
    oriented.figure().map(|_| Join::Sphere(oriented))
}
