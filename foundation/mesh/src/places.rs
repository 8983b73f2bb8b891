//! Boxes around positions, and positions that are equal.

use ga_runtime::vga3::Vector;
use rustc_hash::{FxBuildHasher, FxHashMap};

/// The least and the greatest coordinates of points: opposite corners of their bounding box, with
/// sides along the axes. `None` without points.
///
/// ```
/// use ga_runtime::vga3::Vector;
/// let points = [[0.0, 2.0, 5.0], [1.0, -3.0, 5.0]].map(Vector::from);
/// let [low, high] = ga_mesh::bounds(points).unwrap();
/// assert_eq!([low, high].map(Vector::coordinates), [[0.0, -3.0, 5.0], [1.0, 2.0, 5.0]]);
/// ```
pub fn bounds(points: impl IntoIterator<Item = Vector<f64>>) -> Option<[Vector<f64>; 2]> {
    let boxes = points.into_iter().map(|point| [point; 2]);
    boxes.reduce(|[low, high], [a, b]| [low.min(a), high.max(b)])
}

/// A key that is equal for positions that are equal, bit for bit but for the sign of zero.
pub(crate) fn place_key(position: [f64; 3]) -> [u64; 3] {
    // Adding zero makes the two zeros equal.
    position.map(|x| (x + 0.0).to_bits())
}

/// For each position, the index of the first one that is equal to it: files split vertices where
/// normals or texture coordinates differ, and the surface is nevertheless connected there.
pub(crate) fn first_of_equal(positions: impl ExactSizeIterator<Item = [f64; 3]>) -> Vec<u32> {
    let mut first = FxHashMap::with_capacity_and_hasher(positions.len(), FxBuildHasher);
    let numbered = (0..).zip(positions);
    numbered
        .map(|(index, position)| *first.entry(place_key(position)).or_insert(index))
        .collect()
}
