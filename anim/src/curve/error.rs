//! What can be wrong with the keys of a curve.

use super::value::Value;

/// Keys that do not form a curve, or a curve that cannot be resampled as asked. Keys and channels
/// count from 0.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CurveError {
    /// There are fewer keys than this kind of curve needs.
    #[error("{found} keys, but this curve needs at least {needed}")]
    TooFewKeys {
        /// How many keys there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// Two lists that belong together have different lengths.
    #[error("{found} {what} for {times} times")]
    Length {
        /// What the other list holds.
        what: &'static str,
        /// How many times there are.
        times: usize,
        /// How many elements the other list has.
        found: usize,
    },
    /// The time of a key is infinite or not a number.
    #[error("the time of key {key} is {time}")]
    Time {
        /// The key.
        key: usize,
        /// Its time.
        time: f64,
    },
    /// The time of a key is not after that of the key before it.
    #[error("key {key} at {time} is not after the key before it, at {before}")]
    NotRising {
        /// The key.
        key: usize,
        /// Its time.
        time: f64,
        /// The time of the key before it.
        before: f64,
    },
    /// A value, slope or handle of a key is infinite or not a number.
    #[error("{what} of key {key}, channel {channel}, is {value}")]
    NotFinite {
        /// What the number is.
        what: &'static str,
        /// The key.
        key: usize,
        /// The channel of the value.
        channel: usize,
        /// The number.
        value: f64,
    },
    /// A periodic curve does not end at the value at which it begins.
    #[error(
        "a periodic curve ends where it begins, but channel {channel} goes from {first} to {last}"
    )]
    NotPeriodic {
        /// The channel.
        channel: usize,
        /// Its value at the first key.
        first: f64,
        /// Its value at the last key.
        last: f64,
    },
    /// Slopes are given for a spline whose ends have none.
    #[error("this spline does not take slopes at its ends")]
    SlopesNotTaken,
    /// A handle of a Bézier key is not between the key and its neighbour in time.
    #[error("a handle of key {key} is at {time}, outside the interval to the next key")]
    Handle {
        /// The key.
        key: usize,
        /// The time of the handle.
        time: f64,
    },
    /// The numbers are so large, or the keys so close in time, that the curve from this key to the
    /// next is beyond the range of `f64`. Where the first and the last time differ by more than
    /// that range, this is the last key within it of the first one.
    #[error("the curve from key {key} to the next is beyond the range of 64-bit numbers")]
    OutOfRange {
        /// The key.
        key: usize,
    },
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

/// Fails unless there are enough times, all finite and rising, whose differences are in range.
pub(super) fn check_times(times: &[f64], needed: usize) -> Result<(), CurveError> {
    if times.len() < needed {
        let found = times.len();
        return Err(CurveError::TooFewKeys { found, needed });
    }
    // One pass without branches; what is wrong is looked for only where something is.
    let finite = times
        .iter()
        .fold(true, |good, time| good & time.is_finite());
    let rising = times
        .windows(2)
        .fold(true, |good, pair| good & (pair[0] < pair[1]));
    if finite && rising {
        return check_span(times);
    }
    for (key, &time) in times.iter().enumerate() {
        if !time.is_finite() {
            return Err(CurveError::Time { key, time });
        }
        if key > 0 && times[key - 1] >= time {
            let before = times[key - 1];
            return Err(CurveError::NotRising { key, time, before });
        }
    }
    Ok(())
}

/// Fails where the time from the first key to the last is beyond the range of `f64`.
fn check_span(times: &[f64]) -> Result<(), CurveError> {
    match times {
        [first, .., last] if !(last - first).is_finite() => {
            let within = times.partition_point(|time| (time - first).is_finite());
            Err(CurveError::OutOfRange { key: within - 1 })
        }
        _ => Ok(()),
    }
}

/// Fails unless there is one finite value for each time.
pub(super) fn check_values<V: Value>(
    what: &'static str,
    values: &[V],
    times: usize,
) -> Result<(), CurveError> {
    if values.len() != times {
        let found = values.len();
        return Err(CurveError::Length { what, times, found });
    }
    let finite =
        |value: &V| (0..V::DIMENSION).fold(true, |good, k| good & value.component(k).is_finite());
    if values.iter().fold(true, |good, value| good & finite(value)) {
        return Ok(());
    }
    for (key, value) in values.iter().enumerate() {
        for channel in 0..V::DIMENSION {
            let value = value.component(channel);
            if !value.is_finite() {
                return Err(CurveError::NotFinite {
                    what,
                    key,
                    channel,
                    value,
                });
            }
        }
    }
    Ok(())
}
