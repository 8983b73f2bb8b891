//! What point pairs, circles and spheres have in common: centre, direction and squared radius.

use crate::cga3::{Direction, Point};
use crate::geometry::number::{are_numbers, is_number, is_regular};
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

/// Whether a round has a weight, the length of its direction, and all numbers are finite.
#[inline(always)]
pub(super) fn is_round<S: Ring>(
    centre: Point<S>,
    direction: Direction<S>,
    radius_squared: S,
) -> bool {
    let [x, y, z] = centre.coordinates();
    let direction = direction.vector();
    let [u, v, w] = direction;
    direction != [S::zero(); 3] && are_numbers([x, y, z, u, v, w, radius_squared])
}

/// The radius; `None` where the square is negative or not a number.
#[inline(always)]
pub(super) fn radius<S: Real<Mask = bool>>(radius_squared: S) -> Option<S> {
    let is_real = !radius_squared.less_than(S::zero()) && is_number(radius_squared);
    is_real.then(|| radius_squared.sqrt())
}

/// The vector of a length in a direction; `None` where that is zero or not finite.
#[inline(always)]
pub(super) fn of_length<S: Real<Mask = bool>>(
    direction: Direction<S>,
    length_squared: S,
) -> Option<Vector<S>> {
    let direction = Vector::from(direction.vector());
    let square = direction.length_squared();
    let factor = length_squared / square;
    if is_regular(factor) && is_regular(square) {
        return Some(direction * factor.sqrt());
    }
    let unit = unit_axis_of_any(direction.coordinates())?;
    Some(Vector::from(unit) * length_squared.sqrt())
}

/// The vector of length 1 along an axis; `None` where that is zero or not finite.
#[inline(always)]
pub(super) fn unit_axis<S: Real<Mask = bool>>(axis: [S; 3]) -> Option<Vector<S>> {
    let vector = Vector::from(axis);
    let square = vector.length_squared();
    if is_regular(square) {
        return Some(vector * square.sqrt().recip());
    }
    unit_axis_of_any(axis).map(Vector::from)
}

/// The same for an axis whose square is too large or too small.
#[cold]
#[inline(never)]
fn unit_axis_of_any<S: Real<Mask = bool>>(axis: [S; 3]) -> Option<[S; 3]> {
    Vector::from(axis).normalized().map(Vector::coordinates)
}
