//! The curves by which measures of quality are mapped to opinion scores.

mod curve;
mod fit;
mod simplex;

pub use curve::{Curve, Fit};

use super::{OpinionError, Scores};
use curve::logistic;

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
