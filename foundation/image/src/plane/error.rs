//! Why an operation on planes is not possible.

/// Sizes that do not fit together, or parameters that an operation on planes does not have.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlaneError {
    /// The pixels do not fill, or do not suffice for, that many rows and columns.
    #[error("{length} pixels do not make {width} columns and {height} rows")]
    Length {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// The number of pixels.
        length: usize,
    },
    /// The rows of a view would overlap.
    #[error("rows of {width} pixels cannot begin {stride} pixels apart")]
    Stride {
        /// Pixels from one row to the next.
        stride: usize,
        /// Columns.
        width: usize,
    },
    /// Two planes that should have one size have two.
    #[error(
        "the sizes differ: {} × {} and {} × {}",
        first[0], first[1], second[0], second[1]
    )]
    Differs {
        /// Columns and rows of the first.
        first: [usize; 2],
        /// Columns and rows of the second.
        second: [usize; 2],
    },
    /// There are too few pixels for the operation.
    #[error("{width} × {height} pixels are too few; at least {least} × {least} are needed")]
    TooSmall {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// The least number of columns and of rows.
        least: usize,
    },
    /// A measure needs the range of the numbers, and it is not positive and finite.
    #[error("the range {range} of the numbers is not positive and finite")]
    Range {
        /// The length of the range, as text.
        range: String,
    },
    /// The thresholds of slopes are negative, not in order or not numbers.
    #[error(
        "the thresholds {low} and {high} of slopes are not two numbers from 0 on in ascending order"
    )]
    Thresholds {
        /// The lower threshold.
        low: f64,
        /// The upper threshold.
        high: f64,
    },
    /// A standard deviation that no Gaussian has, or one too large to cut off.
    #[error("σ = {sigma}, cut off at {truncate} σ, is not a Gaussian of radius 0 to 65536")]
    Gaussian {
        /// The standard deviation.
        sigma: f64,
        /// The radius divided by it.
        truncate: f64,
    },
    /// A weight is negative or not finite.
    #[error(
        "the weight {weight} in column {column} and row {row} is not a number from 0 to infinity"
    )]
    Weight {
        /// The column of the pixel.
        column: usize,
        /// The row of the pixel.
        row: usize,
        /// Its weight.
        weight: f32,
    },
    /// All weights that take part are zero.
    #[error("all weights are zero")]
    ZeroWeights,
}
