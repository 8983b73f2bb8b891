//! The curves by which measures of quality are mapped to opinion scores.

mod fit;
mod simplex;

pub use fit::Fit;

use super::{OpinionError, Scores};

/// The logistic function with four parameters,
/// `q(x) = β₂ + (β₁ − β₂) / (1 + exp(−(x − β₃) / |β₄|))`: it goes from β₂ to β₁, and is halfway at
/// β₃ (Video Quality Experts Group, final report of phase II, 2003).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Logistic4 {
    /// β₁ to β₄.
    pub parameters: [f64; 4],
}

/// The logistic function with five parameters,
/// `q(x) = β₁ (½ − 1 / (1 + exp(β₂ (x − β₃)))) + β₄ x + β₅`: a logistic function and a straight
/// line (H. R. Sheikh, M. F. Sabir, A. C. Bovik, "A statistical evaluation of recent full reference
/// image quality assessment algorithms", 2006).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Logistic5 {
    /// β₁ to β₅.
    pub parameters: [f64; 5],
}

/// A curve that maps scores of a measure to opinion scores.
pub trait Curve: Copy + Send + Sync {
    /// How many parameters it has.
    const PARAMETERS: usize;

    /// The opinion score that is predicted for a score of the measure.
    fn at(&self, objective: f64) -> f64;

    /// The curve for which the sum of the squared errors is least.
    ///
    /// The curve is linear in all of its parameters but two, the place and the steepness of the
    /// logistic function: for each pair of these, the others follow from linear equations (variable
    /// projection: G. H. Golub, V. Pereyra, 1973). A grid of the two is searched for all local
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

impl Curve for Logistic4 {
    const PARAMETERS: usize = 4;

    /// ```
    /// use ga_video::opinion::logistic::{Curve, Logistic4};
    ///
    /// let curve = Logistic4 { parameters: [5.0, 1.0, 30.0, 2.0] };
    /// assert_eq!(curve.at(30.0), 3.0);
    /// assert!(curve.at(-1e9) == 1.0 && curve.at(1e9) == 5.0);
    /// ```
    fn at(&self, objective: f64) -> f64 {
        let [high, low, middle, width] = self.parameters;
        low + (high - low) * logistic((objective - middle) / width.abs())
    }

    fn fit(scores: &Scores) -> Result<Fit<Self>, OpinionError> {
        fit::everywhere(scores, Self::PARAMETERS, Self::from_parts)
    }

    fn fit_near(scores: &Scores, start: &Fit<Self>) -> Result<Fit<Self>, OpinionError> {
        fit::near(scores, Self::PARAMETERS, start, Self::from_parts)
    }
}

impl Curve for Logistic5 {
    const PARAMETERS: usize = 5;

    /// ```
    /// use ga_video::opinion::logistic::{Curve, Logistic5};
    ///
    /// let curve = Logistic5 { parameters: [2.0, 0.5, 30.0, 0.1, 1.0] };
    /// assert_eq!(curve.at(30.0), 4.0);
    /// ```
    fn at(&self, objective: f64) -> f64 {
        let [height, steepness, middle, slope, constant] = self.parameters;
        height * (logistic(steepness * (objective - middle)) - 0.5) + slope * objective + constant
    }

    fn fit(scores: &Scores) -> Result<Fit<Self>, OpinionError> {
        fit::everywhere(scores, Self::PARAMETERS, Self::from_parts)
    }

    fn fit_near(scores: &Scores, start: &Fit<Self>) -> Result<Fit<Self>, OpinionError> {
        fit::near(scores, Self::PARAMETERS, start, Self::from_parts)
    }
}

impl Logistic4 {
    fn from_parts(parts: fit::Parts) -> Self {
        let low = parts.constant;
        let width = 1.0 / parts.steepness;
        Self {
            parameters: [low + parts.height, low, parts.middle, width],
        }
    }
}

impl Logistic5 {
    fn from_parts(parts: fit::Parts) -> Self {
        // Here the logistic function is 0 in its middle.
        let constant = parts.constant + parts.height / 2.0;
        Self {
            parameters: [
                parts.height,
                parts.steepness,
                parts.middle,
                parts.slope,
                constant,
            ],
        }
    }
}

/// `1 / (1 + exp(−z))` without overflow.
fn logistic(z: f64) -> f64 {
    let falling = (-z.abs()).exp();
    let small = falling / (1.0 + falling);
    if z < 0.0 { small } else { 1.0 - small }
}
