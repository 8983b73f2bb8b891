//! Cells of space, by which what is near to a place is found.

use crate::Vector;

/// The cell in which a point lies, of a grid of cubes with edges of this length.
pub(super) fn cell(point: Vector, edge: f64) -> [i64; 3] {
    let coordinates = point.coordinates();
    coordinates.map(|coordinate| (coordinate / edge).floor() as i64)
}
