//! Where texels are in a view.

use ga_runtime::batch;
use ga_runtime::cga3::{Direction, Point};
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::covered::Texel;
use super::target::Target;
use super::warp::{TriangleWarp, affine_error};
use crate::camera::{Camera, Lens};

/// The affine warp of a triangle is used where it is wrong by no more than this, in pixels;
/// elsewhere every texel is projected by itself.
pub(super) const AFFINE_TOLERANCE: f64 = 1.0 / 16.0;

/// The triangles of the surface as a camera sees them.
pub(super) struct Geometry<'a> {
    target: &'a Target,
    camera: Camera,
    /// The vertices in the camera's frame.
    positions: Vec<Vector<f64>>,
    triangles: Vec<Triangle>,
}

/// A triangle in a view.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    /// The unit normal in the camera's frame.
    normal: Vector<f64>,
    /// From the barycentric coordinates of the second and third corners to pixels, where that is
    /// accurate.
    warp: Option<TriangleWarp>,
    /// How many pixels the side of a texel is long.
    pixels: f64,
}

/// A texel in a view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    /// The point in the camera's frame.
    pub(super) point: Vector<f64>,
    /// The normal in the camera's frame.
    pub(super) normal: Vector<f64>,
    /// The cosine of the angle of incidence; positive where the front is seen.
    pub(super) cosine: f64,
    pub(super) pixel: [f64; 2],
    /// How many pixels the side of the texel is long.
    pub(super) pixels: f64,
}

impl<'a> Geometry<'a> {
    pub(super) fn new(target: &'a Target, camera: Camera, size: u32) -> Self {
        let mut points: Vec<Point<f64>> = target.positions.iter().map(|&p| p.into()).collect();
        batch::transform(&camera.world_to_camera, &mut points);
        let positions: Vec<Vector<f64>> = points.into_iter().map(Vector::from).collect();
        let pixels: Vec<Option<[f64; 2]>> = positions
            .par_iter()
            .map(|&place| camera.intrinsics.project(place.into()).ok())
            .collect();
        let is_pinhole = matches!(camera.intrinsics.lens(), Lens::Pinhole);
        let triangle = |index: usize| {
            let corners = target.triangles[index].map(|vertex| vertex as usize);
            let normal = Direction::from_vector(target.normals[index].coordinates());
            let normal = camera.world_to_camera.transform(normal);
            let mut found = Triangle {
                normal: normal.into(),
                warp: None,
                pixels: 1.0,
            };
            let [Some(a), Some(b), Some(c)] = corners.map(|vertex| pixels[vertex]) else {
                return found;
            };
            let side = f64::from(size);
            let texels = target.coordinates[index].map(|place| place.map(|x| side * x));
            if let Some(warp) = TriangleWarp::new(texels, [a, b, c]) {
                found.pixels = warp.area_ratio().sqrt();
            }
            let depths = corners.map(|vertex| positions[vertex].e3);
            if is_pinhole && affine_error(depths, [a, b, c]) <= AFFINE_TOLERANCE {
                let barycentric = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
                found.warp = TriangleWarp::new(barycentric, [a, b, c]);
            }
            found
        };
        let triangles = (0..target.triangles.len()).into_par_iter().map(triangle);
        Self {
            target,
            camera,
            triangles: triangles.collect(),
            positions,
        }
    }

    /// The texel in the view; `None` where the surface faces away, has no normal, or the lens does
    /// not see the point.
    pub(super) fn place(&self, texel: &Texel) -> Option<Placed> {
        let triangle = &self.triangles[texel.triangle as usize];
        let corners = self.target.triangles[texel.triangle as usize];
        let [a, b, c] = corners.map(|vertex| self.positions[vertex as usize]);
        let [v, w] = texel.weights.map(f64::from);
        let point = a * (1.0 - v - w) + b * v + c * w;
        let cosine = -triangle.normal.dot(point) / point.length();
        // A comparison with NaN is false.
        if cosine.is_nan() || cosine <= 0.0 {
            return None;
        }
        let pixel = match &triangle.warp {
            Some(warp) => warp.at([v, w]),
            None => self.camera.intrinsics.project(point.into()).ok()?,
        };
        Some(Placed {
            point,
            normal: triangle.normal,
            cosine,
            pixel,
            pixels: triangle.pixels,
        })
    }

    /// How many triangles face the camera, and for how many of them the affine warp is used.
    pub(super) fn warps(&self) -> [usize; 2] {
        let corners = self.target.triangles.iter();
        let mut counts = [0; 2];
        for (triangle, corners) in self.triangles.iter().zip(corners) {
            if triangle.normal.dot(self.positions[corners[0] as usize]) < 0.0 {
                counts[0] += 1;
                counts[1] += usize::from(triangle.warp.is_some());
            }
        }
        counts
    }

    /// The most pixels along the side of a texel.
    pub(super) fn most_pixels(&self) -> f64 {
        let pixels = self.triangles.iter().map(|triangle| triangle.pixels);
        pixels.fold(1.0, f64::max)
    }
}
