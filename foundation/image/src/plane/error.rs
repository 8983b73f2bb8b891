//! Sizes that do not fit.

/// Sizes that do not fit together.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SizeError {
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
}
