//! Modelling points at several levels, coarse to fine, from a disparity map (Cui, §2.1.2).
//!
//! Level 0 has a point for each pixel. A cell of level *k* covers up to 2ᵏ × 2ᵏ pixels, and its
//! point stands for all of them: it lies at their weighted centre, and has the disparity and the
//! slope of the plane that fits their disparities best. A plane in space has a disparity that is
//! affine in the pixel, so that on flat surfaces the points of all levels lie on the surface, and
//! one of a coarse level says as much as many of a fine one. [`ModellingPyramid::select`] takes
//! coarse points where a surface is flat and fine ones along its edges.
//!
//! The disparity of a point gives its depth, f B/(d + c_right − c_left), and the deviation σ of the
//! disparity that of the depth Z, to first order Z² σ/(f B). [`predicted_distance`] is the paper's
//! own measure, eq. 2.
//!
//! ```
//! use ga_image::plane::Plane;
//! use ga_camera::Intrinsics;
//! use ga_vision::disparity::DisparityMap;
//! use ga_vision::modelling_points::ModellingPyramid;
//! use ga_camera::rig::RectifiedRig;
//!
//! // A floor: the disparity grows by a quarter of a pixel from row to row.
//! let map = DisparityMap::new(Plane::from_fn(64, 32, |_, row| 8.0 + 0.25 * row as f32));
//! let pyramid = ModellingPyramid::new(&map, &Plane::filled(64, 32, 1.0), 4, 0.1)?;
//! let points = pyramid.select(0.1);
//! // 8 × 4 cells of 8 × 8 pixels suffice.
//! assert_eq!(points.len(), 32);
//! assert_eq!(points[0].disparity_px, 8.875);
//! assert!(points[0].slope[0].abs() < 1e-12 && (points[0].slope[1] - 0.25).abs() < 1e-12);
//!
//! let camera = Intrinsics::new([100.0, 100.0], [31.5, 15.5])?;
//! let rig = RectifiedRig::new(camera, camera, 0.1)?;
//! let place = points[0].place(&rig).unwrap();
//! assert_eq!(place.depth, 100.0 * 0.1 / 8.875);
//! assert!(place.surface.signed_distance(place.position).unwrap().abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod fit;
mod predicted_distance;

use ga_image::plane::{Plane, PlaneError, PlaneView, same_size};
use ga_runtime::cga3::{self, Point};

use crate::disparity::DisparityMap;
use fit::Fit;
use ga_camera::rig::RectifiedRig;
pub use predicted_distance::{DistanceControls, DistanceError, predicted_distance};

/// The greatest slope of the disparity on a surface.
const GRADIENT_LIMIT: f64 = 1.0;

/// Why a map has no modelling points.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModellingError {
    /// The map and the weights have different sizes.
    #[error("the disparities and their weights do not fit together: {0}")]
    Size(#[from] PlaneError),
    /// A weight is negative or not finite.
    #[error(
        "the weight {weight} of the pixel in column {column} and row {row} is negative or not finite"
    )]
    Weight {
        /// The weight.
        weight: f32,
        /// The column.
        column: usize,
        /// The row.
        row: usize,
    },
    /// The number of levels is not from 1 to 32.
    #[error("a pyramid has 1 to 32 levels, not {0}")]
    Levels(usize),
    /// The deviation of a pixel's disparity is negative or not finite.
    #[error("{0} px is not a standard deviation")]
    Deviation(f64),
}

/// What one cell of a level says about the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModellingPoint {
    /// The level; the cell has 2^level pixels along each side.
    pub level: usize,
    /// The column and the row of the cell in its level.
    pub cell: [usize; 2],
    /// How many pixels with a known disparity and a weight the cell has.
    pub pixels: usize,
    /// The weighted centre of these pixels in the left view.
    pub centre: [f64; 2],
    /// The disparity at the centre, in pixels.
    pub disparity_px: f64,
    /// By how much the disparity grows from column to column and from row to row.
    pub slope: [f64; 2],
    /// The root of the weighted mean square of the distances of the pixels' disparities from the
    /// plane of the cell.
    pub residual_px: f64,
    /// The standard deviation of the disparity: the residual and that of single pixels together. It
    /// does not shrink with their number, since errors of neighbouring pixels are not independent.
    pub deviation_px: f64,
}

/// Where a modelling point is in space, in the frame of the left camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The point.
    pub position: Point<f64>,
    /// Its depth along the optical axis in metres, f B/(d + c_right − c_left).
    pub depth: f64,
    /// The standard deviation of the depth in metres, to first order.
    pub depth_deviation: f64,
    /// The plane of the surface there, of weight 1, with its normal towards the cameras.
    pub surface: cga3::Plane<f64>,
}

/// The modelling points of a disparity map at all levels.
#[derive(Clone, Debug)]
pub struct ModellingPyramid {
    map: Plane<f32>,
    weights: Plane<f32>,
    /// Those of level 1 and up.
    levels: Vec<Plane<Fit>>,
    pixel_deviation_px: f64,
}

impl ModellingPyramid {
    /// The points of a map at a number of levels; fewer where a level of a single cell is reached.
    /// A pixel has no part in any cell where its disparity is unknown or its weight is 0; a
    /// matcher's confidence may be the weight. `pixel_deviation_px` is the standard deviation of
    /// the disparity of a single pixel.
    ///
    /// # Errors
    ///
    /// Any [`ModellingError`].
    pub fn new<'a>(
        map: &DisparityMap,
        weights: impl Into<PlaneView<'a, f32>>,
        levels: usize,
        pixel_deviation_px: f64,
    ) -> Result<Self, ModellingError> {
        let weights = weights.into();
        same_size(map.view(), weights)?;
        for (row, values) in weights.rows().enumerate() {
            let wrong = |weight: &f32| !(*weight >= 0.0 && weight.is_finite());
            if let Some(column) = values.iter().position(wrong) {
                let weight = values[column];
                return Err(ModellingError::Weight {
                    weight,
                    column,
                    row,
                });
            }
        }
        if !(1..=32).contains(&levels) {
            return Err(ModellingError::Levels(levels));
        }
        if !(pixel_deviation_px >= 0.0 && pixel_deviation_px.is_finite()) {
            return Err(ModellingError::Deviation(pixel_deviation_px));
        }
        let mut pyramid = Self {
            map: map.plane().clone(),
            weights: weights.to_plane(),
            levels: Vec::new(),
            pixel_deviation_px,
        };
        while pyramid.levels() < levels {
            let finest = pyramid.levels() - 1;
            let [width, height] = pyramid.size(finest);
            if width.max(height) <= 1 {
                break;
            }
            let next = Plane::from_fn(width.div_ceil(2), height.div_ceil(2), |column, row| {
                let children = children([column, row]).map(|cell| pyramid.fit(finest, cell));
                children.into_iter().fold(Fit::default(), Fit::merged)
            });
            pyramid.levels.push(next);
        }
        Ok(pyramid)
    }

    /// How many levels there are.
    #[must_use]
    pub fn levels(&self) -> usize {
        1 + self.levels.len()
    }

    /// Columns and rows of the cells of a level; none beyond the last level.
    #[must_use]
    pub fn size(&self, level: usize) -> [usize; 2] {
        match level.checked_sub(1) {
            None => [self.map.width(), self.map.height()],
            Some(above) => self
                .levels
                .get(above)
                .map_or([0; 2], |plane| [plane.width(), plane.height()]),
        }
    }

    /// The point of the cell in a column and a row of a level; `None` where no pixel of the cell
    /// has a known disparity and a weight, and where there is no such cell.
    #[must_use]
    pub fn point(&self, level: usize, cell: [usize; 2]) -> Option<ModellingPoint> {
        let fit = self.fit(level, cell);
        let plane = fit.plane()?;
        let [u, v, disparity_px] = fit.mean();
        Some(ModellingPoint {
            level,
            cell,
            pixels: fit.pixels(),
            centre: [u, v],
            disparity_px,
            slope: plane.slope,
            residual_px: plane.residual,
            deviation_px: plane.residual.hypot(self.pixel_deviation_px),
        })
    }

    /// All points of a level, row by row.
    pub fn points(&self, level: usize) -> impl Iterator<Item = ModellingPoint> {
        let [width, height] = self.size(level);
        let cells = (0..height).flat_map(move |row| (0..width).map(move |column| [column, row]));
        cells.filter_map(move |cell| self.point(level, cell))
    }

    /// The disparity in pixels that the next coarser level predicts at the centre of a point: that
    /// of the plane of the cell in which it lies. `None` for points of the last level.
    #[must_use]
    pub fn predicted_disparity(&self, point: &ModellingPoint) -> Option<f64> {
        let coarse = self.point(point.level + 1, point.cell.map(|index| index / 2))?;
        let along = |axis: usize| coarse.slope[axis] * (point.centre[axis] - coarse.centre[axis]);
        Some(coarse.disparity_px + along(0) + along(1))
    }

    /// As few points as describe the surface: those of the coarsest cells whose residual is at most
    /// `tolerance_px` and whose slope is at most 1 px a pixel, and of single pixels where no
    /// coarser cell is flat enough. Every pixel that has a part in the pyramid lies in exactly one
    /// of their cells. For a negative tolerance, and for NaN, they are single pixels.
    ///
    /// A plane through a few pixels fits an edge as well as a surface. What tells them apart is the
    /// limit of the disparity gradient, beyond which people do not see one surface either (P. Burt
    /// and B. Julesz, A disparity gradient limit for binocular fusion, Science 208, 1980).
    #[must_use]
    pub fn select(&self, tolerance_px: f64) -> Vec<ModellingPoint> {
        let mut selected = Vec::new();
        let coarsest = self.levels() - 1;
        let [width, height] = self.size(coarsest);
        for row in 0..height {
            for column in 0..width {
                self.select_within(coarsest, [column, row], tolerance_px, &mut selected);
            }
        }
        selected
    }

    fn select_within(
        &self,
        level: usize,
        cell: [usize; 2],
        tolerance_px: f64,
        selected: &mut Vec<ModellingPoint>,
    ) {
        let Some(point) = self.point(level, cell) else {
            return;
        };
        let [a, b] = point.slope;
        let is_surface = a.hypot(b) <= GRADIENT_LIMIT && point.residual_px <= tolerance_px;
        if level == 0 || is_surface {
            selected.push(point);
            return;
        }
        for child in children(cell) {
            self.select_within(level - 1, child, tolerance_px, selected);
        }
    }

    /// What the pixels of a cell say; without a weight where there is no such cell.
    fn fit(&self, level: usize, cell @ [column, row]: [usize; 2]) -> Fit {
        let fit = match level.checked_sub(1) {
            None => {
                let pixel = self.map.get(column, row).zip(self.weights.get(column, row));
                pixel.map(|(disparity, weight)| Fit::of_pixel(cell, disparity, weight))
            }
            Some(above) => self
                .levels
                .get(above)
                .and_then(|plane| plane.get(column, row)),
        };
        fit.unwrap_or_default()
    }
}

/// The cells of the next finer level that make up a cell. Those at the right and lower border may
/// be missing.
fn children([column, row]: [usize; 2]) -> [[usize; 2]; 4] {
    [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[right, down]| [2 * column + right, 2 * row + down])
}

impl ModellingPoint {
    /// The side of the cell in pixels, 2^level: the spacing of the points of its level.
    #[must_use]
    pub fn spacing_px(&self) -> f64 {
        2f64.powi(self.level as i32)
    }

    /// Where the point is, as a rectified rig sees it; `None` where the depth is not positive and
    /// finite.
    #[must_use]
    pub fn place(&self, rig: &RectifiedRig) -> Option<Place> {
        let depth = rig.depth(self.disparity_px)?;
        let position = rig.point(self.centre, self.disparity_px)?;
        let (focal, principal) = (rig.left().focal(), rig.left().principal());
        let depth_deviation = depth * depth * self.deviation_px / (focal[0] * rig.baseline());
        // On the plane n·X = c, the disparity less that of infinity is f B (n·X)/(c Z), which is
        // affine in the pixel; its coefficients are those of n, up to a factor.
        let [a, b] = self.slope;
        let [u, v] = [0, 1].map(|axis: usize| self.centre[axis] - principal[axis]);
        let at_principal = self.disparity_px + rig.disparity_offset() - a * u - b * v;
        let normal = [-a * focal[0], -b * focal[1], -at_principal];
        let surface = cga3::Plane::from_point_normal(position, normal).normalized()?;
        depth_deviation.is_finite().then_some(Place {
            position,
            depth,
            depth_deviation,
            surface,
        })
    }

    /// The paper's predicted distance K (Cui, eq. 2) with the disparity as the visual deviation S
    /// and the spacing of the points of this level as the visual point spacing Q.
    ///
    /// # Errors
    ///
    /// Any [`DistanceError`].
    pub fn predicted_distance(&self, controls: DistanceControls) -> Result<f64, DistanceError> {
        predicted_distance(self.disparity_px, self.spacing_px(), controls)
    }
}
