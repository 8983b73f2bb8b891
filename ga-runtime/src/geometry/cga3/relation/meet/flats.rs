//! Meets of lines and planes.

use super::{Meet, finite_point};
use crate::cga3::{Direction, DualDirection, DualPlane, Line, Plane, Point};
use crate::geometry::number::{are_numbers, is_regular};
use crate::geometry::relation::tolerance::{angle_within, within};
use crate::geometry::relation::{CommonPerpendicular, Tolerance};
use crate::scalar::Real;
use crate::vga3::Vector;

/// How two lines meet. Their vee product is zero unless they are skew, and then a scalar times ei;
/// it does not determine an orientation here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineAndLine<S> {
    /// They cross in a point: the midpoint between the feet of their common perpendicular.
    Point(Point<S>),
    /// They are parallel and meet at infinity.
    Parallel {
        /// The unit direction of the first line: their common point at infinity.
        direction: Direction<S>,
        /// The distance of the lines.
        distance: S,
    },
    /// They are skew: neither parallel nor crossing.
    Skew(CommonPerpendicular<S>),
    /// They are the same line: the first is given.
    Coincident(Line<S>),
}

/// How a line and a plane meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineAndPlane<S> {
    /// The line crosses the plane in a point.
    Point(Point<S>),
    /// They are parallel and meet at infinity.
    Parallel {
        /// The unit direction of the line: their common point at infinity.
        direction: Direction<S>,
        /// The distance of the line, positive on the side of the normal.
        distance: S,
    },
    /// The line lies in the plane.
    Contained(Line<S>),
}

/// How two planes meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneAndPlane<S> {
    /// They cross in a line.
    Line(Line<S>),
    /// They are parallel and meet at infinity.
    Parallel {
        /// Their common line at infinity, as the free bivector perpendicular to the unit normal of
        /// the first plane.
        attitude: DualDirection<S>,
        /// The signed distance of the second plane along the normal of the first.
        distance: S,
    },
    /// They are the same plane: the first is given.
    Coincident(Plane<S>),
}

impl<S: Real<Mask = bool>> Meet<Line<S>> for Line<S> {
    type Scalar = S;
    type Outcome = LineAndLine<S>;
    fn meet(self, other: Self, tolerance: Tolerance<S>) -> Option<LineAndLine<S>> {
        let ((p, d), (q, e)) = (self.parts()?, other.parts()?);
        if angle_within(d.cross(e).length(), d.dot(e).abs(), tolerance.angle) {
            let distance = (q - p).across(d).length();
            if !distance.is_finite() {
                return None;
            }
            return Some(if within(distance, tolerance.distance) {
                LineAndLine::Coincident(self)
            } else {
                let direction = Direction::from(d);
                LineAndLine::Parallel {
                    direction,
                    distance,
                }
            });
        }
        let between = self.common_perpendicular(other, tolerance)?;
        if !within(between.distance, tolerance.distance) {
            return Some(LineAndLine::Skew(between));
        }
        let [a, b] = between.feet.map(Vector::from);
        let middle = a + (b - a) * S::from_ratio(1, 2);
        finite_point(middle).map(LineAndLine::Point)
    }
}

impl<S: Real<Mask = bool>> Meet<Plane<S>> for Line<S> {
    type Scalar = S;
    type Outcome = LineAndPlane<S>;
    #[inline(always)]
    fn meet(self, plane: Plane<S>, tolerance: Tolerance<S>) -> Option<LineAndPlane<S>> {
        let ((d, m), (n, number)) = (self.vectors(), plane.vectors());
        let slope = d.dot(n);
        // The squared sine of the angle, times the squared lengths, against that of the bound.
        let bound = tolerance.angle * tolerance.angle * (d.length_squared() * n.length_squared());
        if is_regular(slope * slope) && bound.less_than(slope * slope) {
            let place = (n.cross(m) + d * number).divided(slope);
            if are_numbers(place.coordinates()) {
                return Some(LineAndPlane::Point(place.into()));
            }
        }
        line_and_plane([d, m].map(Vector::coordinates), n.into(), number, tolerance)
    }
}

/// The meet of a line, by direction and moment, and a plane.
#[cold]
#[inline(never)]
fn line_and_plane<S: Real<Mask = bool>>(
    [d, m]: [[S; 3]; 2],
    normal: [S; 3],
    number: S,
    tolerance: Tolerance<S>,
) -> Option<LineAndPlane<S>> {
    let line = Line::from_vectors(d.into(), m.into());
    let plane = DualPlane::from_normal_distance(normal, number).undual();
    let ((point, direction), (normal, distance)) = (line.parts()?, plane.parts()?);
    let slope = direction.dot(normal);
    let height = point.dot(normal) - distance;
    let cosine = direction.cross(normal).length();
    if !angle_within(slope.abs(), cosine, tolerance.angle) {
        let place = point - direction * (height / slope);
        return finite_point(place).map(LineAndPlane::Point);
    }
    if within(height, tolerance.distance) {
        return Some(LineAndPlane::Contained(line));
    }
    let direction = Direction::from(direction);
    let outcome = LineAndPlane::Parallel {
        direction,
        distance: height,
    };
    height.is_finite().then_some(outcome)
}

impl<S: Real<Mask = bool>> Meet<Plane<S>> for Plane<S> {
    type Scalar = S;
    type Outcome = PlaneAndPlane<S>;
    #[inline(always)]
    fn meet(self, other: Self, tolerance: Tolerance<S>) -> Option<PlaneAndPlane<S>> {
        let ((n, d), (m, e)) = (self.vectors(), other.vectors());
        let along = n.cross(m);
        let square = along.length_squared();
        // The squared sine of the angle, times the squared lengths, against that of the bound.
        let bound = tolerance.angle * tolerance.angle * (n.length_squared() * m.length_squared());
        if is_regular(square) && bound.less_than(square) {
            // For any point p of the line, p × (n × m) = (p·m) n − (p·n) m.
            let length = square.sqrt();
            let moment = (n * e - m * d).divided(length);
            if are_numbers(moment.coordinates()) {
                let line = Line::from_vectors(along.divided(length), moment);
                return Some(PlaneAndPlane::Line(line));
            }
        }
        plane_and_plane([n, m].map(Vector::coordinates), [d, e], tolerance)
    }
}

/// The meet of planes, by their normals and distances.
#[cold]
#[inline(never)]
fn plane_and_plane<S: Real<Mask = bool>>(
    normals: [[S; 3]; 2],
    numbers: [S; 2],
    tolerance: Tolerance<S>,
) -> Option<PlaneAndPlane<S>> {
    let plane = |k: usize| DualPlane::from_normal_distance(normals[k], numbers[k]).undual();
    let (plane, other) = (plane(0), plane(1));
    let ((n, d), (m, e)) = (plane.parts()?, other.parts()?);
    let along = n.cross(m);
    let sine = along.length();
    if angle_within(sine, n.dot(m).abs(), tolerance.angle) {
        let distance = n.dot(m * e) - d;
        if within(distance, tolerance.distance) {
            return Some(PlaneAndPlane::Coincident(plane));
        }
        let attitude = DualDirection::from_normal(n.into());
        let outcome = PlaneAndPlane::Parallel { attitude, distance };
        return distance.is_finite().then_some(outcome);
    }
    let direction = along.divided(sine);
    // The point of the line nearest to the origin: (d m × u + e u × n) / sin with u the
    // direction.
    let place = m.cross(direction) * d + direction.cross(n) * e;
    let line = Line::from_point_direction(place.divided(sine).into(), direction.into());
    Vector::from(line.moment())
        .is_finite()
        .then_some(PlaneAndPlane::Line(line))
}
