//! Why views cannot be diagnosed.

/// Why a pair of views cannot be diagnosed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DiagnosisError {
    /// There are too few pairs of points.
    #[error("{found} pairs of points are given, and at least {needed} are needed")]
    TooFew {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("pair {0}: a coordinate is not finite")]
    NotFinite(usize),
    /// The threshold is not positive and finite.
    #[error("the threshold is {0} px, which is not positive and finite")]
    Threshold(f64),
    /// The points of the right view lie on one line, so that rotation and zoom are not determined.
    #[error("the points in the right view lie on one line")]
    OnOneLine,
    /// Too few pairs agree on a model: the views do not show one scene, or are far from rectified.
    #[error(
        "only {agreeing} of {pairs} pairs of points agree: these are not two views of one scene, \
         or they are far from rectified"
    )]
    NoConsensus {
        /// How many agree with the best model.
        agreeing: usize,
        /// How many there are.
        pairs: usize,
    },
}
