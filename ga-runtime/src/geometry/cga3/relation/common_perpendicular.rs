//! The common perpendicular of two lines: the shortest way from one to the other.

use super::distance::across;
use super::tolerance::within;
use super::{Figure, Primitive, Tolerance, parallel};
use crate::cga3::{Line, Point};
use crate::geometry::vector3::{are_numbers, cross, difference, dot, length, scaled, sum};
use crate::scalar::Real;

/// The common perpendicular of two lines, with its feet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommonPerpendicular<S> {
    /// The perpendicular through both feet, with a direction of length 1.
    pub line: Line<S>,
    /// Its feet, on the first line and on the second.
    pub feet: [Point<S>; 2],
    /// The distance of the feet, which is that of the lines.
    pub distance: S,
}

impl<S: Real<Mask = bool>> Line<S> {
    /// The line that meets this one and another at right angles, with its feet on both and their
    /// distance.
    ///
    /// With the dual lines ℓ and k it is the axis of the motor `k ℓ⁻¹`, along the bivector part of
    /// the commutator `(ℓk − kℓ)/2`. Its direction is that of `d × e`, for d and e the directions
    /// of this line and the other: it leads from the one to the other or back, as the lines are
    /// wound.
    ///
    /// Lines parallel within `tolerance.angle` have many. The one through this line's point nearest
    /// to the origin is given, and leads to the other line. `None` where they are parallel and not
    /// farther apart than `tolerance.distance`, where one is no line, or where a foot is beyond the
    /// range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Point};
    /// use ga_runtime::geometry::relation::Tolerance;
    /// let x = Line::from_point_direction(Point::new(0.0, 0.0, 1.0), [1.0, 0.0, 0.0]);
    /// let y = Line::from_point_direction(Point::new(5.0, 0.0, 4.0), [0.0, 2.0, 0.0]);
    /// let between = x.common_perpendicular(y, Tolerance::default()).unwrap();
    /// assert_eq!(between.distance, 3.0);
    /// assert_eq!(between.feet, [Point::new(5.0, 0.0, 1.0), Point::new(5.0, 0.0, 4.0)]);
    /// assert_eq!(between.line.direction(), [0.0, 0.0, 1.0]);
    /// ```
    #[must_use]
    pub fn common_perpendicular(
        self,
        other: Self,
        tolerance: Tolerance<S>,
    ) -> Option<CommonPerpendicular<S>> {
        let Figure::Line {
            point: p,
            direction: d,
        } = self.figure()?
        else {
            return None;
        };
        let Figure::Line {
            point: q,
            direction: e,
        } = other.figure()?
        else {
            return None;
        };
        let between = difference(q, p);
        let normal = cross(d, e);
        let sine = length(normal);
        let angle = sine.atan2(dot(d, e).abs());
        if within(angle, tolerance.angle) || sine.less_than(parallel()) {
            let way = across(between, d);
            let distance = length(way);
            if within(distance, tolerance.distance) {
                return None;
            }
            return assemble(p, sum(p, way), way.map(|x| x / distance), distance);
        }
        let normal = normal.map(|x| x / sine);
        // p + s d and q + t e differ by a multiple of the normal.
        let first = sum(p, scaled(d, dot(cross(between, e), normal) / sine));
        let second = sum(q, scaled(e, dot(cross(between, d), normal) / sine));
        assemble(first, second, normal, dot(between, normal).abs())
    }
}

fn assemble<S: Real<Mask = bool>>(
    first: [S; 3],
    second: [S; 3],
    direction: [S; 3],
    distance: S,
) -> Option<CommonPerpendicular<S>> {
    let line = Line::from_point_direction(Point::from(first), direction);
    let finite = are_numbers(first)
        && are_numbers(second)
        && are_numbers(line.moment())
        && are_numbers(direction)
        && distance.is_finite();
    finite.then(|| CommonPerpendicular {
        line,
        feet: [first, second].map(Point::from),
        distance,
    })
}
