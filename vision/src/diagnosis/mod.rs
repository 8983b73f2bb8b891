//! What is wrong with a pair of views that should be rectified.
//!
//! In rectified views the two images of a point are in one row, whatever its depth. If the right
//! camera is rotated by ρ about its axis, zooms by s and is displaced vertically, then the row in
//! the left view is a linear function of the pixel in the right one,
//!
//! ```text
//! v_left = (−sin ρ · u_right + cos ρ · v_right)/s + c
//! ```
//!
//! with pixels counted from the middle of the picture. Depth moves a point along u alone, so it
//! plays no part, and the three numbers follow from matched points without a calibration. They are
//! found by random sampling and then by least squares over the pairs that agree.
//!
//! Where both views are rotated by a quarter turn, the two images of a point are in one column.
//!
//! What this does not explain, such as a perspective distortion by axes that are not parallel,
//! stays in [`Diagnosis::residual_rms`].
//!
//! ```
//! use ga_vision::diagnosis::{Diagnosis, DiagnosisOptions};
//! use ga_vision::feature::PixelPair;
//!
//! // The right view is 3 pixels too low, at disparities from 5 to 24.
//! let pairs: Vec<PixelPair> = (0..20)
//!     .map(|k| {
//!         let (u, v) = (f64::from(k * 37 % 200), f64::from(k * 53 % 150));
//!         PixelPair { left: [u, v], right: [u - 5.0 - f64::from(k), v + 3.0] }
//!     })
//!     .collect();
//! let found = Diagnosis::new(&pairs, [200, 150], DiagnosisOptions::default())?;
//! assert!((found.vertical_offset - 3.0).abs() < 1e-9);
//! assert!(found.rotation.abs() < 1e-12 && (found.zoom - 1.0).abs() < 1e-12);
//! assert!(!found.is_rectified());
//! # Ok::<(), ga_vision::ViewGeometryError>(())
//! ```

pub mod of_match;
pub mod row_model;

use crate::feature::PixelPair;
use crate::geometry_error::ViewGeometryError;
use ga_numerics::order_statistics::{Sorted, median};
use ga_numerics::ransac::Search;
use row_model::{RowModel, Rows};
use serde::{Serialize, Serializer};

/// The vertical disparity, in pixels, that nearly all points of rectified views stay below.
pub const RECTIFIED_LIMIT: f64 = 1.0;

/// The part of the pairs that must agree on a model.
const LEAST_AGREEMENT: f64 = 0.3;
/// The part of the pairs that are in one column where the views are rotated by a quarter turn.
const IN_COLUMNS: f64 = 0.5;
/// By how many pixels the rows of points in one column differ, from a tenth to nine tenths of them,
/// where the views are rotated: by the depth of the points, not by an offset of the views.
const DIFFERENT_ROWS: f64 = 4.0;
/// Points whose columns differ by less than this number of pixels are in one column.
const COLUMN_TOLERANCE: f64 = 1.5;

/// How a pair of views is diagnosed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagnosisOptions {
    /// A pair of points agrees with a model that explains its rows within this number of pixels.
    pub threshold: f64,
    /// Equal seeds give equal results.
    pub seed: u64,
}

impl Default for DiagnosisOptions {
    /// A threshold of 1.5 pixels, seed 1.
    fn default() -> Self {
        Self {
            threshold: 1.5,
            seed: 1,
        }
    }
}

/// How the right view deviates from a rectified one, in pixels and radians; in JSON, angles are in
/// degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Diagnosis {
    /// By how much the middle row of the left view is lower in the middle of the right view.
    #[serde(rename = "vertical_offset_px")]
    pub vertical_offset: f64,
    /// The angle ρ by which the right view is rotated, from u towards v: clockwise.
    #[serde(rename = "rotation_degrees", serialize_with = "in_degrees")]
    pub rotation: f64,
    /// The magnification s of the right view against the left.
    pub zoom: f64,
    /// The vertical disparities `v_right − v_left` of the agreeing pairs.
    #[serde(flatten)]
    pub vertical: VerticalDisparity,
    /// The root of the mean squared difference of rows that the model does not explain.
    #[serde(rename = "unexplained_rms_px")]
    pub residual_rms: f64,
    /// The disparities `u_left − u_right` of the agreeing pairs.
    #[serde(flatten)]
    pub disparity: HorizontalDisparity,
    /// How many pairs were given.
    #[serde(rename = "matches")]
    pub pairs: usize,
    /// How many agree with the model; the others are taken for mismatches.
    #[serde(rename = "matches_used")]
    pub agreeing: usize,
    /// Whether the images of most points are in one column and not in one row: both views are
    /// rotated by a quarter turn. Then the numbers above mean little.
    #[serde(rename = "sideways")]
    pub is_sideways: bool,
}

/// Vertical disparities of a pair of views, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct VerticalDisparity {
    /// The median.
    #[serde(rename = "vertical_disparity_median_px")]
    pub median: f64,
    /// The root of the mean square.
    #[serde(rename = "vertical_disparity_rms_px")]
    pub rms: f64,
    /// What 95 % of the absolute values stay below.
    #[serde(rename = "vertical_disparity_95_percent_px")]
    pub most: f64,
}

/// Disparities along the rows, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HorizontalDisparity {
    /// The least.
    #[serde(rename = "disparity_least_px")]
    pub least: f64,
    /// The median.
    #[serde(rename = "disparity_median_px")]
    pub median: f64,
    /// The greatest.
    #[serde(rename = "disparity_greatest_px")]
    pub greatest: f64,
}

/// What makes views other than rectified ones.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DiagnosisFault {
    /// The vertical disparities are too large.
    #[error(
        "the views are not rectified: 95 % of the vertical disparities are below {most:.3} px, and \
         should be below {RECTIFIED_LIMIT} px; the right view is rotated by {:.2}°, {offset:.2} px \
         lower and {zoom:.4} times as large",
        rotation.to_degrees()
    )]
    NotRectified {
        /// What 95 % of the absolute values stay below, in pixels.
        most: f64,
        /// [`Diagnosis::rotation`].
        rotation: f64,
        /// [`Diagnosis::vertical_offset`].
        offset: f64,
        /// [`Diagnosis::zoom`].
        zoom: f64,
    },
    /// Both views are rotated by a quarter turn.
    #[error(
        "the images of a point are in one column of both views and not in one row: the views seem \
         to be rotated by 90°"
    )]
    Sideways,
    /// Most disparities are negative.
    #[error("the disparities are negative: the views seem to be exchanged")]
    Exchanged,
}

impl DiagnosisFault {
    /// One word for programs.
    #[must_use]
    pub fn kind(self) -> &'static str {
        match self {
            Self::NotRectified { .. } => "not_rectified",
            Self::Sideways => "sideways",
            Self::Exchanged => "views_exchanged",
        }
    }
}

fn in_degrees<S: Serializer>(angle: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(angle.to_degrees())
}

impl Diagnosis {
    /// The diagnosis of views with a size in columns and rows from pairs of points, of which some
    /// may be wrong.
    ///
    /// # Errors
    /// [`ViewGeometryError`] for fewer than three pairs, points on one line, numbers that are not
    /// finite, and pairs that do not agree.
    pub fn new(
        pairs: &[PixelPair],
        size: [usize; 2],
        options: DiagnosisOptions,
    ) -> Result<Self, ViewGeometryError> {
        let threshold = options.threshold;
        if !(threshold > 0.0 && threshold.is_finite()) {
            return Err(ViewGeometryError::MatchThreshold(threshold));
        }
        let rows = Rows::new(pairs, size)?;
        let search = Search {
            threshold,
            confidence: 0.9999,
            least_samples: 50,
            samples: 5000,
            seed: options.seed,
        };
        let best = search.run(&rows, 1);
        let mut model = best.first().ok_or(ViewGeometryError::OnOneLine)?.model;
        // Least squares over the agreeing pairs, which may change which ones agree.
        for _ in 0..5 {
            let agreeing = rows.agreeing(&model, threshold);
            let next = rows.fitted(&agreeing);
            let Some(next) = next.filter(RowModel::is_plausible) else {
                break;
            };
            let is_settled = next == model;
            model = next;
            if is_settled {
                break;
            }
        }
        let agreeing = rows.agreeing(&model, threshold);
        let least = (LEAST_AGREEMENT * pairs.len() as f64).max(RowModel::NEEDED as f64);
        let in_column = |pair: &&PixelPair| (pair.left[0] - pair.right[0]).abs() < COLUMN_TOLERANCE;
        let in_columns = pairs.iter().filter(in_column);
        let mut vertical: Vec<f64> = in_columns
            .map(|pair| pair.right[1] - pair.left[1])
            .collect();
        let in_columns = vertical.len() as f64;
        let explained = agreeing.len() as f64;
        let are_in_columns = in_columns > IN_COLUMNS * pairs.len() as f64;
        let are_few = 2.0 * explained < in_columns;
        if explained < least && !(are_in_columns && are_few) {
            return Err(ViewGeometryError::NoMatchConsensus {
                agreeing: agreeing.len(),
                pairs: pairs.len(),
            });
        }
        let mut found = Self::of(pairs, &rows, &model, &agreeing);
        let sorted = Sorted::new(&mut vertical);
        let range = sorted.map_or(0.0, |sorted| sorted.quantile(0.9) - sorted.quantile(0.1));
        let are_different = range > DIFFERENT_ROWS && !found.is_rectified();
        found.is_sideways = are_in_columns && (are_few || are_different);
        Ok(found)
    }

    fn of(pairs: &[PixelPair], rows: &Rows, model: &RowModel, agreeing: &[usize]) -> Self {
        let chosen = || agreeing.iter().map(|&index| &pairs[index]);
        let vertical = chosen().map(|pair| pair.right[1] - pair.left[1]);
        let mut vertical: Vec<f64> = vertical.collect();
        let mut sizes: Vec<f64> = vertical.iter().map(|v| v.abs()).collect();
        let disparity = chosen().map(|pair| pair.left[0] - pair.right[0]);
        let mut disparity: Vec<f64> = disparity.collect();
        let [sizes, disparity] = [&mut sizes, &mut disparity].map(|values| {
            let sorted = Sorted::new(values);
            move |share| sorted.map_or(0.0, |sorted| sorted.quantile(share))
        });
        let residuals = agreeing.iter().map(|&index| rows.residual(model, index));
        Self {
            pairs: pairs.len(),
            agreeing: agreeing.len(),
            vertical_offset: model.vertical_offset(),
            rotation: model.rotation(),
            zoom: model.zoom(),
            vertical: VerticalDisparity {
                rms: root_mean_square(vertical.iter().copied()),
                median: median(&mut vertical).unwrap_or(0.0),
                most: sizes(0.95),
            },
            residual_rms: root_mean_square(residuals),
            disparity: HorizontalDisparity {
                least: disparity(0.0),
                median: disparity(0.5),
                greatest: disparity(1.0),
            },
            is_sideways: false,
        }
    }

    /// Whether the views are rectified for a dense matcher: 95 % of the vertical disparities are
    /// below [`RECTIFIED_LIMIT`].
    #[must_use]
    pub fn is_rectified(&self) -> bool {
        self.vertical.most < RECTIFIED_LIMIT
    }

    /// Whether most points are further right in the right view, as if the views were exchanged.
    #[must_use]
    pub fn is_exchanged(&self) -> bool {
        self.disparity.median < 0.0
    }

    /// What is wrong with the views.
    #[must_use]
    pub fn faults(&self) -> Vec<DiagnosisFault> {
        if self.is_sideways {
            return vec![DiagnosisFault::Sideways];
        }
        let uneven = (!self.is_rectified()).then_some(DiagnosisFault::NotRectified {
            most: self.vertical.most,
            rotation: self.rotation,
            offset: self.vertical_offset,
            zoom: self.zoom,
        });
        let exchanged = self.is_exchanged().then_some(DiagnosisFault::Exchanged);
        uneven.into_iter().chain(exchanged).collect()
    }
}

fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0usize), |(sum, count), x| (sum + x * x, count + 1));
    (sum / count.max(1) as f64).sqrt()
}
