//! Pairs of views that do not agree with the others.

use std::error::Error;
use std::fmt;

/// A pair that does not agree with the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlier {
    /// The pair, from 0.
    pub pair: usize,
    /// Its root mean square distance in pixels, infinite where the rig cannot see the board.
    pub rms: f64,
    /// The median of all pairs.
    pub median: f64,
}

impl fmt::Display for Outlier {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rms, median, .. } = self;
        match rms.is_finite() {
            true => write!(
                formatter,
                "its corners are {rms:.2} px from where the rig sees them, \
                 those of all pairs {median:.2} px"
            ),
            false => write!(
                formatter,
                "its board lies where the other camera of the rig cannot see it, \
                 the corners of all pairs are {median:.2} px from where it sees them"
            ),
        }
    }
}

impl Error for Outlier {}
