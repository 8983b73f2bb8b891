//! The common perpendicular of two lines: the shortest segment between them, with its line.

use super::tolerance::{angle_within, within};
use super::{Tolerance, parallel};
use crate::cga3::{Line, Point};
use crate::geometry::number::{are_numbers, is_moderate, is_number, is_regular};
use crate::scalar::Real;
use crate::vga3::Vector;

/// The common perpendicular of two lines, with the points where it meets them (its feet).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommonPerpendicular<S> {
    /// The line through both feet, with a direction of length 1.
    pub line: Line<S>,
    /// The feet: the one on the first line, then the one on the second.
    pub feet: [Point<S>; 2],
    /// The distance between the feet, which is the distance between the lines.
    pub distance: S,
    /// Whether the lines are parallel, so that this is one of many common perpendiculars.
    pub is_parallel: bool,
}

impl<S: Real<Mask = bool>> Line<S> {
    /// The line that meets this line and another at right angles, with its feet on both and the
    /// distance between them.
    ///
    /// With the dual lines ℓ and k it is the axis of the motor `k ℓ⁻¹`, along the bivector part of
    /// the commutator `(ℓk − kℓ)/2`. Its direction is that of `d × e`, for d and e the directions
    /// of this line and the other: it points from this line to the other or back, depending on the
    /// handedness of the two lines.
    ///
    /// Lines that are parallel within `tolerance.angle` have many common perpendiculars. The result
    /// is then the one through this line's point nearest to the origin, directed to the other line,
    /// and `is_parallel` is true. So it is, with any tolerance, for directions that differ by no
    /// more than their rounding.
    /// `None` where the lines are parallel and not farther apart than `tolerance.distance`, where
    /// one is not a line, or where a foot is beyond the range of the scalar.
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
    #[inline]
    #[must_use]
    pub fn common_perpendicular(
        self,
        other: Self,
        tolerance: Tolerance<S>,
    ) -> Option<CommonPerpendicular<S>> {
        let ((d, m), (e, n)) = (self.vectors(), other.vectors());
        let normal = d.cross(e);
        let squares @ [d_squared, e_squared, square] = [d, e, normal].map(Vector::length_squared);
        // Directions of any length are not normalized first, and each square divides only once.
        let [by_d, by_e, by_square] = squares.map(S::recip);
        let sine_squared = square * by_d * by_e;
        let least = tolerance.angle * tolerance.angle + parallel::<S>() * parallel::<S>();
        let (p, q) = (d.cross(m) * by_d, e.cross(n) * by_e);
        let between = q - p;
        // p + s d and q + t e differ by a multiple of the normal.
        let first = p + d * (between.cross(e).dot(normal) * by_square);
        let second = q + e * (between.cross(d).dot(normal) * by_square);
        let unit = normal * (square.sqrt() * by_square);
        let is_plain = is_regular(d_squared)
            & is_regular(e_squared)
            & is_regular(square)
            & least.less_than(sine_squared)
            & is_moderate(first.length_squared() + second.length_squared())
            & is_moderate(between.length_squared());
        if is_plain {
            return Some(CommonPerpendicular {
                line: Line::from_point_direction(first.into(), unit.into()),
                feet: [first, second].map(Point::from),
                distance: between.dot(unit).abs(),
                is_parallel: false,
            });
        }
        near_parallel(
            [d, m].map(Vector::coordinates),
            [e, n].map(Vector::coordinates),
            tolerance,
        )
    }
}

/// The common perpendicular of lines, each by direction and moment, that may be parallel or beyond
/// the regular range.
#[cold]
#[inline(never)]
fn near_parallel<S: Real<Mask = bool>>(
    [d, m]: [[S; 3]; 2],
    [e, n]: [[S; 3]; 2],
    tolerance: Tolerance<S>,
) -> Option<CommonPerpendicular<S>> {
    let (p, d) = Line::from_vectors(d.into(), m.into()).parts()?;
    let (q, e) = Line::from_vectors(e.into(), n.into()).parts()?;
    let between = q - p;
    let normal = d.cross(e);
    let sine = normal.length();
    let is_parallel = angle_within(sine, d.dot(e).abs(), tolerance.angle);
    if is_parallel || sine.less_than(parallel()) {
        let way = between.across(d);
        let distance = way.length();
        if within(distance, tolerance.distance) {
            return None;
        }
        return assemble([p, p + way], way.divided(distance), distance, true);
    }
    let normal = normal.divided(sine);
    // p + s d and q + t e differ by a multiple of the normal.
    let first = p + d * (between.cross(e).dot(normal) / sine);
    let second = q + e * (between.cross(d).dot(normal) / sine);
    assemble([first, second], normal, between.dot(normal).abs(), false)
}

#[inline]
fn assemble<S: Real<Mask = bool>>(
    feet: [Vector<S>; 2],
    direction: Vector<S>,
    distance: S,
    is_parallel: bool,
) -> Option<CommonPerpendicular<S>> {
    let line = Line::from_point_direction(feet[0].into(), direction.into());
    let [first, second] = feet.map(Vector::coordinates);
    let is_finite = are_numbers(first)
        && are_numbers(second)
        && are_numbers(line.moment())
        && are_numbers(direction.coordinates())
        && is_number(distance);
    is_finite.then(|| CommonPerpendicular {
        line,
        feet: feet.map(Point::from),
        distance,
        is_parallel,
    })
}
