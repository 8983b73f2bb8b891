//! Smooth normals from positions alone.

use super::vector::{Vector, add, cross, normalized, subtract};

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
    let mut sums = vec![[0.0; 3]; positions.len()];
    for triangle in triangles {
        let corners = triangle.map(|v| v as usize);
        let normal = scaled_normal(corners.map(|v| positions[v]));
        for corner in corners {
            sums[corner] = add(sums[corner], normal);
        }
    }
    sums.into_iter()
        .map(|sum| normalized(sum).unwrap_or_default())
        .collect()
}

/// The normal of a triangle, as long as twice its area.
pub(super) fn scaled_normal([a, b, c]: [Vector; 3]) -> Vector {
    cross(subtract(b, a), subtract(c, a))
}
