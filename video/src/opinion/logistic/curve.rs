//! Curves from scores of a measure to opinion scores.

use super::super::{OpinionError, Scores};

/// A curve that was fitted to scores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit<C> {
    /// The curve.
    pub curve: C,
    /// The sum of the squared differences from the opinion scores.
    pub sum_of_squares: f64,
    /// Whether a curve of the kind that bends back between the scores would have a smaller sum.
    pub is_held_monotone: bool,
    /// Place and logarithm of the steepness, in the unit of the scores' range.
    pub(super) place: [f64; 2],
    /// Middle and half of the range of the scores for which the place stands.
    pub(super) range: [f64; 2],
}

/// A curve that maps scores of a measure to opinion scores.
pub trait Curve: Copy + Send + Sync {
    /// How many parameters it has.
    const PARAMETERS: usize;

    /// The opinion score that is predicted for a score of the measure.
    fn at(&self, objective: f64) -> f64;

    /// The curve for which the sum of the squared errors is least, among those that rise or fall
    /// all over the range of the scores, as ITU-T P.1401 asks for: a measure whose order differs
    /// from that of the opinions is not to gain by its curve.
    ///
    /// The curve is linear in all of its parameters but two, the place and the steepness of the
    /// logistic function: for each pair of these, the others follow from linear equations (variable
    /// projection: G. H. Golub, V. Pereyra, 1973), and where their curve is not monotone, from such
    /// equations on the border of those that are. A grid of the two is searched for all local
    /// minima, and the best are followed by the simplex method of J. A. Nelder and R. Mead, 1965.
    /// So the result does not depend on a start, and is the least sum over the grid's range: from
    /// curves that are nearly polynomials to steps between two neighbouring scores. With few or
    /// scattered scores such a step may be the best curve.
    ///
    /// # Errors
    ///
    /// [`OpinionError::TooFew`] where there are fewer scores than parameters.
    fn fit(scores: &Scores) -> Result<Fit<Self>, OpinionError>;

    /// The curve of least error near another one, whose minimum is followed to the scores.
    ///
    /// # Errors
    ///
    /// [`OpinionError::TooFew`] where there are fewer scores than parameters.
    fn fit_near(scores: &Scores, start: &Fit<Self>) -> Result<Fit<Self>, OpinionError>;
}

/// `1 / (1 + exp(−z))` without overflow.
pub(super) fn logistic(z: f64) -> f64 {
    let falling = (-z.abs()).exp();
    let small = falling / (1.0 + falling);
    if z < 0.0 { small } else { 1.0 - small }
}
