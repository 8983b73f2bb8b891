//! What point pairs, circles and spheres have in common: centre, direction and squared radius.

use crate::cga3::{Direction, Point};
use crate::geometry::number::{are_numbers, is_number, is_regular};
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

/// Whether a round has a weight, the length of its direction, and all numbers are finite.
#[inline(always)]
pub(super) fn is_round<S: Real>(
    centre: Point<S>,
    direction: Direction<S>,
    radius_squared: S,
) -> S::Mask {
    let [x, y, z] = centre.coordinates();
    let [u, v, w] = direction.vector();
    let is_zero = u.is_zero() & v.is_zero() & w.is_zero();
    !is_zero & are_numbers([x, y, z, u, v, w, radius_squared])
}

/// The radius; `None` where the square is negative or not a number.
#[inline(always)]
pub(super) fn radius<S: Real>(radius_squared: S) -> Maybe<S, S> {
    let is_real = !radius_squared.less_than(S::zero()) & is_number(radius_squared);
    is_real.when(radius_squared.sqrt())
}

/// The vector of a length in a direction; `None` where that is zero or not finite. A negative
/// square of the length gives NaN, in those lanes alone.
#[inline(always)]
pub(super) fn of_length<S: Real>(
    direction: Direction<S>,
    length_squared: S,
) -> Maybe<Vector<S>, S> {
    let direction = Vector::from(direction.vector());
    let square = direction.length_squared();
    let factor = length_squared / square;
    (is_regular(factor.abs()) & is_regular(square))
        .when(direction * factor.sqrt())
        .or_else_of(
            (direction.coordinates(), length_squared),
            |(direction, length_squared)| {
                let unit = unit_axis_of_any(direction);
                unit.map(|unit| Vector::from(unit) * length_squared.sqrt())
            },
        )
}

/// The vector of length 1 along an axis; `None` where that is zero or not finite.
#[inline(always)]
pub(super) fn unit_axis<S: Real>(axis: [S; 3]) -> Maybe<Vector<S>, S> {
    let vector = Vector::from(axis);
    let square = vector.length_squared();
    is_regular(square)
        .when(vector * square.sqrt().recip())
        .or_else_of(axis, |axis| unit_axis_of_any(axis).map(Vector::from))
}

/// The same for an axis whose square is too large or too small.
#[cold]
#[inline(never)]
fn unit_axis_of_any<S: Real>(axis: [S; 3]) -> Maybe<[S; 3], S> {
    Vector::from(axis).normalized().map(Vector::coordinates)
}
