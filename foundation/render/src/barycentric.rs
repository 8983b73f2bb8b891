//! Barycentric coordinates of where rays meet triangles.

use crate::Vector;

/// The barycentric coordinates at which a ray from the eye meets the plane of a triangle in the
/// camera's frame.
///
/// The ray direction is `Σ λᵢ pᵢ` up to scale, so by Cramer's rule `λᵢ ∝ det(ray, pⱼ, pₖ)`: exact
/// under perspective, wherever the corners lie. A triangle seen edge-on has no such place and gets
/// its middle.
pub(crate) fn barycentric(ray: Vector, corners: [Vector; 3]) -> [f64; 3] {
    weights(volumes(ray, corners))
}

/// `det(ray, pⱼ, pₖ)` for each corner of a triangle; linear in the ray.
pub(crate) fn volumes(ray: Vector, [a, b, c]: [Vector; 3]) -> [f64; 3] {
    [
        ray.dot(b.cross(c)),
        ray.dot(c.cross(a)),
        ray.dot(a.cross(b)),
    ]
}

/// The barycentric coordinates in proportion to these volumes.
pub(crate) fn weights(volumes: [f64; 3]) -> [f64; 3] {
    let total: f64 = volumes.iter().sum();
    let weights = volumes.map(|v| (v / total).clamp(0.0, 1.0));
    // Clamping keeps a sample on a sliver's rounded outline from being extrapolated.
    let sum: f64 = weights.iter().sum();
    if sum.is_normal() {
        weights.map(|w| w / sum)
    } else {
        [1.0 / 3.0; 3]
    }
}
