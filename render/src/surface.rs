//! Which triangle is seen at which sample, and how far away.

use crate::camera::{Camera, Lens};
use crate::clip::Clipper;
use crate::{Scene, Style, Vector, raster};

/// The visible surface at every sample of a picture.
pub(crate) struct Samples {
    pub(crate) width: usize,
    /// 1 / depth of the nearest surface; 0 where there is none.
    pub(crate) inverse_depth: Vec<f32>,
    /// The triangle seen, where `inverse_depth` is not 0.
    pub(crate) triangle: Vec<u32>,
    /// Each vertex in the camera's frame: right offset, up offset, depth.
    pub(crate) view: Vec<Vector>,
    pub(crate) lens: Lens,
}

impl Samples {
    pub(crate) fn draw(scene: &Scene, camera: &Camera, style: &Style) -> Self {
        let (columns, rows) = (
            style.width * style.supersampling,
            style.height * style.supersampling,
        );
        let (width, height) = (columns as usize, rows as usize);
        let lens = Lens::new(camera, columns, rows);
        let clipper = Clipper::new(
            camera.near(),
            lens.centre[0] / lens.focal,
            lens.centre[1] / lens.focal,
        );
        let mut inverse_depth = vec![0f32; width * height];
        let mut seen = vec![0u32; width * height];
        let view: Vec<Vector> = scene
            .positions
            .iter()
            .map(|&position| camera.view(position.into()))
            .collect();
        let project = |point: Vector| {
            let inverse = 1.0 / point.e3;
            let [column, row] = lens.project([point.e1, point.e2], inverse);
            [column, row, inverse]
        };

        for (index, triangle) in scene.triangles.iter().enumerate() {
            let polygon = clipper.clip(triangle.map(|v| view[v as usize]));
            let corners = polygon.corners();
            for i in 2..corners.len() {
                let fan = [corners[0], corners[i - 1], corners[i]].map(project);
                raster::fill(width, height, fan, |sample, inverse| {
                    if inverse > inverse_depth[sample] {
                        inverse_depth[sample] = inverse;
                        seen[sample] = index as u32;
                    }
                });
            }
        }
        Self {
            width,
            inverse_depth,
            triangle: seen,
            view,
            lens,
        }
    }
}

/// The barycentric coordinates at which a ray from the eye meets the plane of a triangle in the
/// camera's frame.
///
/// The ray direction is `Σ λᵢ pᵢ` up to scale, so by Cramer's rule `λᵢ ∝ det(ray, pⱼ, pₖ)`: exact
/// under perspective, wherever the corners lie. A triangle seen edge-on has no such place and gets
/// its middle.
pub(crate) fn barycentric(ray: Vector, [a, b, c]: [Vector; 3]) -> [f64; 3] {
    let volumes = [
        ray.dot(b.cross(c)),
        ray.dot(c.cross(a)),
        ray.dot(a.cross(b)),
    ];
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
