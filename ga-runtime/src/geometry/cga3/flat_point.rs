//! Flat points.

use crate::cga3::{FlatPoint, Infinity, Point};
use crate::geometry::number::{are_numbers, is_number};
use crate::scalar::{Field, Ring};

impl<S: Ring> From<Point<S>> for FlatPoint<S> {
    /// The flat point `p∧ei`.
    #[inline]
    fn from(point: Point<S>) -> Self {
        point ^ Infinity
    }
}

impl<S: Field> FlatPoint<S> {
    /// The point of `p∧ei`; `None` for a direction, whose weight eoi is zero, or beyond the range
    /// of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Infinity, Point};
    /// let p = Point::new(1.0, 2.0, 3.0);
    /// assert_eq!((p ^ Infinity).to_point(), Some(p));
    /// ```
    #[inline]
    #[must_use]
    pub fn to_point(self) -> Option<Point<S>> {
        if !self.eoi.is_invertible() {
            return None;
        }
        let place = [self.e1i, self.e2i, self.e3i];
        let inverse = self.eoi.recip();
        let [x, y, z] = place.map(|x| x * inverse);
        // The sum is a number only if each of them is.
        if is_number(x + y + z) {
            return Some(Point::new(x, y, z));
        }
        divided(place, self.eoi).map(Point::from)
    }
}

/// Coordinates divided by a weight whose inverse is beyond the range of the scalar, or of which the
/// sum is.
#[cold]
#[inline(never)]
fn divided<S: Field>(place: [S; 3], weight: S) -> Option<[S; 3]> {
    let place = place.map(|x| x / weight);
    are_numbers(place).then_some(place)
}
