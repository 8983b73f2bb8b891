//! Points and triangles on the grid of pixels.

use ga_image::plane::Plane;
use ga_mesh::normals::area_vector;
use ga_numerics::order_statistics::Sorted;
use ga_runtime::batch;
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;
use serde::Serialize;

use crate::disparity::{DisparityMap, DisparityMapError};
use ga_camera::rig::RectifiedRig;

/// Which pixels become points, and which points are joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceOptions {
    /// The largest difference of disparities that does not cut the surface, in pixels for each
    /// pixel between the neighbours; see the [module](super#where-a-surface-is-cut).
    pub cut_px: f64,
    /// Every how many rows and columns there is a point.
    pub step: usize,
    /// The least and the greatest depth in metres, both included.
    pub depths: [f64; 2],
    /// The greatest standard deviation of a depth, as a part of it; see the
    /// [module](super#which-depths-noise-decides).
    pub depth_deviation: f64,
}

/// The standard deviation of the disparities of a matcher, in pixels: on the pairs motorcycle of
/// Middlebury and terrace of ETH3D, 68 % of the confirmed errors are below 0.19 to 0.26 px.
pub const DISPARITY_DEVIATION: f64 = 0.25;

impl Default for SurfaceOptions {
    /// A cut at 1 px, every pixel, all depths that deviate by at most a quarter, which are those of
    /// disparities of 1 px and more from that of infinity.
    fn default() -> Self {
        Self {
            cut_px: 1.0,
            step: 1,
            depths: [0.0, f64::INFINITY],
            depth_deviation: 0.25,
        }
    }
}

/// The points of a disparity map, and the triangles between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    points: Vec<Point<f64>>,
    pixels: Vec<[u32; 2]>,
    triangles: Vec<[u32; 3]>,
    size: [usize; 2],
    step: usize,
    uncertain: usize,
}

/// The depths of a surface in metres, under the names of JSON.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DepthSummary {
    /// The percentage of the pixels that are points, of those that could be by
    /// [`SurfaceOptions::step`].
    pub density: f64,
    /// The least depth.
    #[serde(rename = "nearest_metres")]
    pub nearest: f64,
    /// The median.
    #[serde(rename = "median_metres")]
    pub median: f64,
    /// The greatest depth.
    #[serde(rename = "farthest_metres")]
    pub farthest: f64,
    /// How many pixels are no points because their depth is too uncertain.
    #[serde(rename = "left_out_by_depth_deviation")]
    pub uncertain: usize,
}

/// The index of a pixel without a point.
const NONE: u32 = u32::MAX;

impl Surface {
    /// The points of all known disparities that are certain enough, row by row, in the frame of the
    /// left camera, and the triangles between those that belong together. Triangles are
    /// counterclockwise as seen from the camera.
    ///
    /// # Errors
    /// [`DisparityMapError`] for faulty options, and where no pixel is a point.
    pub fn new(
        map: &DisparityMap,
        rig: &RectifiedRig,
        options: &SurfaceOptions,
    ) -> Result<Self, DisparityMapError> {
        let SurfaceOptions {
            cut_px,
            step,
            depths: [near, far],
            depth_deviation,
        } = *options;
        if !(cut_px.is_finite() && cut_px > 0.0) {
            return Err(DisparityMapError::Cut(cut_px));
        }
        if step == 0 {
            return Err(DisparityMapError::Step);
        }
        if near.is_nan() || far.is_nan() || near > far {
            return Err(DisparityMapError::Depths(near, far));
        }
        if depth_deviation.is_nan() || depth_deviation <= 0.0 {
            return Err(DisparityMapError::DepthDeviation(depth_deviation));
        }
        let size = [map.width(), map.height()];
        let count = size.map(|count| count.div_ceil(step));
        if count[0].saturating_mul(count[1]) >= NONE as usize {
            return Err(DisparityMapError::TooMany(
                count[0].saturating_mul(count[1]),
            ));
        }
        let (mut points, mut pixels) = (Vec::new(), Vec::new());
        let mut uncertain = 0;
        let numbers = Plane::from_fn(count[0], count[1], |column, row| {
            let (column, row) = (column * step, row * step);
            let point = map.get(column, row).and_then(|disparity| {
                let disparity = f64::from(disparity);
                let point = rig.point([column as f64, row as f64], disparity)?;
                let [_, _, depth] = point.coordinates();
                let deviation = DISPARITY_DEVIATION / (disparity + rig.disparity_offset());
                let is_certain = deviation <= depth_deviation;
                let is_inside = depth >= near && depth <= far;
                uncertain += usize::from(is_inside && !is_certain);
                (is_inside && is_certain).then_some(point)
            });
            point.map_or(NONE, |point| {
                points.push(point);
                pixels.push([column as u32, row as u32]);
                points.len() as u32 - 1
            })
        });
        if points.is_empty() {
            let pixels = size[0] * size[1];
            return Err(DisparityMapError::Empty { pixels, uncertain });
        }
        let limit = cut_px * step as f64;
        let triangles = triangles(
            &numbers,
            |number| {
                let [column, row] = pixels[number as usize].map(|x| x as usize);
                map.get(column, row).map_or(f64::NAN, f64::from)
            },
            limit,
        );
        Ok(Self {
            points,
            pixels,
            triangles,
            size,
            step,
            uncertain,
        })
    }

    /// The points in metres.
    #[must_use]
    pub fn points(&self) -> &[Point<f64>] {
        &self.points
    }

    /// The pixel of the left view, column and row, that shows each point.
    #[must_use]
    pub fn pixels(&self) -> &[[u32; 2]] {
        &self.pixels
    }

    /// The triangles, by the numbers of their corners among the points.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The width and height of the left view in pixels.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// How many pixels are points, and how deep they are: along e3, which is the axis of the left
    /// camera before the surface is [`moved`](Self::moved).
    #[must_use]
    pub fn summary(&self) -> DepthSummary {
        let [columns, rows] = self.size.map(|count| count.div_ceil(self.step));
        let mut depths: Vec<f64> = self.points.iter().map(|point| point.e3()).collect();
        let sorted = Sorted::new(&mut depths);
        let quantile = |share| sorted.map_or(f64::NAN, |sorted| sorted.quantile(share));
        DepthSummary {
            density: 100.0 * self.points.len() as f64 / (columns * rows) as f64,
            nearest: quantile(0.0),
            median: quantile(0.5),
            farthest: quantile(1.0),
            uncertain: self.uncertain,
        }
    }

    /// The same surface moved.
    #[must_use]
    pub fn moved(mut self, motor: &Motor<f64>) -> Self {
        batch::transform(motor, &mut self.points);
        self
    }

    /// The unit normal of each point, towards the camera: the mean of those of its triangles,
    /// weighted by area. `None` for a point without a triangle.
    #[must_use]
    pub fn normals(&self) -> Vec<Option<Vector<f64>>> {
        let mut sums = vec![Vector::default(); self.points.len()];
        for triangle in &self.triangles {
            let corners = triangle.map(|corner| corner as usize);
            let normal = area_vector(corners.map(|corner| Vector::from(self.points[corner])));
            for corner in corners {
                sums[corner] += normal;
            }
        }
        sums.into_iter().map(Vector::normalized).collect()
    }

    /// The least box along the axes that holds all points: its two corners.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let first = Vector::from(self.points[0]);
        let grow = |[low, high]: [Vector<f64>; 2], point: &Point<f64>| {
            let place = Vector::from(*point);
            [low.min(place), high.max(place)]
        };
        let bounds = self.points.iter().fold([first, first], grow);
        bounds.map(Vector::coordinates)
    }

    /// The part of the surface that has triangles: points without one are left out, and numbers
    /// change accordingly. `None` where there are no triangles.
    #[must_use]
    pub fn without_single_points(&self) -> Option<Self> {
        let mut numbers = vec![NONE; self.points.len()];
        for corner in self.triangles.iter().flatten() {
            numbers[*corner as usize] = 0;
        }
        let (mut points, mut pixels) = (Vec::new(), Vec::new());
        let all = self.points.iter().zip(&self.pixels).zip(&mut numbers);
        for ((point, pixel), number) in all.filter(|(_, number)| **number != NONE) {
            *number = points.len() as u32;
            points.push(*point);
            pixels.push(*pixel);
        }
        let renumbered = |triangle: &[u32; 3]| triangle.map(|corner| numbers[corner as usize]);
        (!points.is_empty()).then(|| Self {
            triangles: self.triangles.iter().map(renumbered).collect(),
            points,
            pixels,
            size: self.size,
            step: self.step,
            uncertain: self.uncertain,
        })
    }
}

/// The triangles of a grid of numbered points whose disparities differ by no more than a limit.
fn triangles(numbers: &Plane<u32>, disparity: impl Fn(u32) -> f64, limit: f64) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    let difference = |a: u32, b: u32| (disparity(a) - disparity(b)).abs();
    for row in 1..numbers.height() {
        let (upper, lower) = (numbers.row(row - 1), numbers.row(row));
        for column in 1..numbers.width() {
            // a d
            // b c
            let square = [
                upper[column - 1],
                lower[column - 1],
                lower[column],
                upper[column],
            ];
            let [a, b, c, d] = square;
            let missing = square.iter().filter(|number| **number == NONE).count();
            let halves = match missing {
                0 if difference(a, c) <= difference(b, d) => [Some([a, b, c]), Some([a, c, d])],
                0 => [Some([a, b, d]), Some([b, c, d])],
                1 => {
                    let gap = square.iter().position(|number| *number == NONE);
                    let after = gap.unwrap_or(0) + 1;
                    [Some([0, 1, 2].map(|k| square[(after + k) % 4])), None]
                }
                _ => [None, None],
            };
            let joined = |[p, q, r]: &[u32; 3]| {
                [(*p, *q), (*q, *r), (*r, *p)]
                    .into_iter()
                    .all(|(from, to)| difference(from, to) <= limit)
            };
            triangles.extend(halves.into_iter().flatten().filter(joined));
        }
    }
    triangles
}
