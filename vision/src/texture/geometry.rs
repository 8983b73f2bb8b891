//! Where texels are in a view.

use ga_runtime::batch;
use ga_runtime::cga3::{Direction, Point};
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::covered::Texel;
use super::target::Target;
use super::warp::{TriangleWarp, affine_error};
use ga_camera::{Camera, Lens};

/// The affine warp of a triangle is used where it is wrong by no more than this, in pixels;
/// elsewhere every texel is projected by itself.
pub(super) const AFFINE_TOLERANCE: f64 = 1.0 / 16.0;

/// The greatest ratio of the length of a texel to the average in its chart.
const MOST_STRETCH: f64 = 4.0;

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
    /// The sides of a texel in pixels; zero where the triangle has no area in the texture.
    texel: [[f64; 2]; 2],
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
    /// The sides of the texel in pixels.
    pub(super) sides: [[f64; 2]; 2],
}

impl Placed {
    /// How far the texel reaches from its middle along columns and rows, in pixels.
    pub(super) fn extents(&self) -> [f64; 2] {
        let [a, b] = self.sides;
        [0, 1].map(|axis| 0.5 * (a[axis].abs() + b[axis].abs()))
    }
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
                texel: [[0.0; 2]; 2],
            };
            let [Some(a), Some(b), Some(c)] = corners.map(|vertex| pixels[vertex]) else {
                return found;
            };
            let side = f64::from(size);
            let texels = target.coordinates[index].map(|place| place.map(|x| side * x));
            if let Some(warp) = TriangleWarp::new(texels, [a, b, c]) {
                found.texel = warp.columns();
            }
            let depths = corners.map(|vertex| positions[vertex].e3);
            // Slivers of the texture say nothing about the size of their texels.
            let focal = camera.intrinsics.focal();
            let distances = corners.map(|vertex| positions[vertex].length());
            let near = distances.into_iter().fold(f64::INFINITY, f64::min);
            let usual = target.chart_sides[target.charts[index] as usize] / side;
            let longest = MOST_STRETCH * focal[0].max(focal[1]) * usual / near;
            for edge in &mut found.texel {
                let length = edge[0].hypot(edge[1]);
                if length > longest {
                    *edge = edge.map(|x| x * longest / length);
                }
            }
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
            sides: triangle.texel,
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
}
