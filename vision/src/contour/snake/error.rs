//! What a snake cannot work with.

use ga_image::plane::PlaneError;

/// Why a snake does not move.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SnakeError {
    /// There are too few points.
    #[error("{count} points are too few for a snake; at least {least} are needed")]
    TooFew {
        /// The number of points.
        count: usize,
        /// The least number.
        least: usize,
    },
    /// All points are at one place, or so near each other that the tension or the rigidity by the
    /// power of their distance is infinite.
    #[error("the points of a snake are {spacing} pixels apart on average")]
    NoLength {
        /// The mean distance of neighbouring points in pixels.
        spacing: f64,
    },
    /// A point is not in the picture.
    #[error(
        "point {index} of the contour, at ({}, {}), is outside the picture of {} × {} pixels",
        point[0], point[1], size[0], size[1]
    )]
    Outside {
        /// The point, counted from 0.
        index: usize,
        /// Where it is.
        point: [f64; 2],
        /// Columns and rows of the picture.
        size: [usize; 2],
    },
    /// A setting is not a number that it can be.
    #[error("the {setting} of a snake cannot be {value}")]
    Setting {
        /// The setting.
        setting: &'static str,
        /// Its value.
        value: f64,
    },
    /// The energy or its slope is infinite or not a number.
    #[error(
        "the energy of the snake is beyond the range of numbers: the tension of {tension}, the \
         rigidity of {rigidity} or the potential is too great"
    )]
    EnergyNotFinite {
        /// α.
        tension: f64,
        /// β.
        rigidity: f64,
    },
    /// The picture is too small for slopes.
    #[error("a picture of {width} × {height} pixels is too small for a snake")]
    TooSmall {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// A pixel is infinite or not a number.
    #[error("the pixel in column {column} and row {row} is not finite")]
    NotFinite {
        /// The column.
        column: usize,
        /// The row.
        row: usize,
    },
    /// The equations of a flow were not solved.
    #[error("the flow of the edges was not found in {steps} steps: a part of {residual} is left")]
    FlowNotConverged {
        /// How many steps were taken.
        steps: usize,
        /// The residual by the right-hand side.
        residual: f64,
    },
    /// The picture cannot be blurred so.
    #[error(transparent)]
    Sigma(#[from] PlaneError),
}
