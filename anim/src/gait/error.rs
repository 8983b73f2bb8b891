//! Why motions cannot be brought in step.

use super::foot::Foot;
use crate::curve::CurveError;
use crate::recording::RecordingError;

/// What is wrong with the steps of a motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GaitProblem {
    /// The joints of two legs are not known.
    #[error(
        "no steps are found, since no two legs are known by the names of the joints or by their \
         structure"
    )]
    NoLegs,
    /// There are too few steps.
    #[error("{found} steps are found, and {needed} are needed")]
    TooFewSteps {
        /// How many there are from the first one of the same foot as in the first motion.
        found: usize,
        /// How many there must be.
        needed: usize,
    },
    /// The feet come down in another order.
    #[error(
        "the feet do not come down in the order of the first motion: at {seconds:.3} s{}, {} in \
         place of {}",
        if *.is_repeated { ", when its strides are repeated" } else { "" },
        .found.with_article(),
        .expected.with_article()
    )]
    Order {
        /// When a foot comes down, in the motion's own time.
        seconds: f64,
        /// Whether that is after the motion began again.
        is_repeated: bool,
        /// Which foot.
        found: Foot,
        /// Which foot comes down in the first motion.
        expected: Foot,
    },
    /// The vertical is another one.
    #[error("its vertical is not that of the first motion")]
    Vertical,
    /// The steps are not a clock: two of them are at one time.
    #[error(transparent)]
    Clock(#[from] CurveError),
    /// A part of it cannot be repeated.
    #[error(transparent)]
    Recording(#[from] RecordingError),
}

/// A motion that cannot be brought in step with others.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("motion {motion}: {problem}")]
pub struct GaitError {
    /// Its number, from 0.
    pub motion: usize,
    /// What is wrong.
    pub problem: GaitProblem,
}
