//! Normals of triangles and of vertices.

use ga_runtime::vga3::Vector;

/// The unit normal at each vertex: the mean of its triangles' normals, each weighted by the
/// triangle's area.
///
/// Triangles are oriented counter-clockwise seen from outside. A vertex without a triangle of
/// positive area gets the zero vector.
///
/// # Panics
///
/// When a triangle names a vertex that does not exist.
pub fn vertex_normals(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Vec<[f64; 3]> {
    let mut sums = vec![Vector::default(); positions.len()];
    for triangle in triangles {
        let corners = triangle.map(|v| v as usize);
        let normal = area_vector(corners.map(|v| Vector::from(positions[v])));
        for corner in corners {
            sums[corner] += normal;
        }
    }
    sums.into_iter()
        .map(|sum| sum.normalized().unwrap_or_default().coordinates())
        .collect()
}

/// The normal of a triangle with the length of twice its area, `(b − a) × (c − a)`.
#[must_use]
pub fn area_vector([a, b, c]: [Vector<f64>; 3]) -> Vector<f64> {
    (b - a).cross(c - a)
}
