//! What is left of the condition on a mean.

/// The weighted mean of the logarithms `log(~M Mᵢ)`, which is zero for the mean M.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual<S> {
    /// The length of its rotation vector, in radians.
    pub angle: S,
    /// The length of its displacement, in the unit of length of the motions.
    pub displacement: S,
}
