//! Why curves cannot be resampled.

/// A curve that cannot be resampled as asked.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ResampleError {
    /// The tolerance is 0, negative, infinite or not a number.
    #[error("{0} is not a distance that a resampled curve may have")]
    Tolerance(f64),
    /// The tolerance is less than 16 times the distance between neighbouring numbers at the largest
    /// coordinate, so rounding alone may exceed it.
    #[error("a tolerance of {tolerance} is below {least}, which rounding needs for these values")]
    TooFine {
        /// The tolerance.
        tolerance: f64,
        /// The least tolerance for this curve.
        least: f64,
    },
    /// The value jumps at a key, and no polyline with vertices on the curve follows it.
    #[error("the curve jumps at key {key}")]
    Jump {
        /// The key, from 0.
        key: usize,
    },
    /// The tolerance is exceeded between a time and the next that a number of 64 bits can state.
    #[error("at {time} neighbouring times are too far apart for a tolerance of {tolerance}")]
    TimeTooCoarse {
        /// The time.
        time: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// More vertices are needed than the caller allows.
    #[error("a tolerance of {tolerance} needs more than {most} vertices")]
    TooMany {
        /// The tolerance.
        tolerance: f64,
        /// How many are allowed.
        most: usize,
    },
    /// The channels have no common times.
    #[error("channel {channel} has other times than the first")]
    Times {
        /// The channel, from 0.
        channel: usize,
    },
}
