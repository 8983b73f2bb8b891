//! People's judgement: how well a measure of quality predicts it, and ratings by groups of people.
//!
//! - [`correlation`]: how strongly two rows of numbers depend on each other.
//! - [`logistic`]: the curves by which measures are mapped to opinion scores, fitted.
//! - [`performance`]: what a measure is worth: correlations, error and outliers, with confidence
//!   intervals by bootstrap, and whether one measure is better than another.
//! - [`evaluation`]: all of these numbers of a measure, with a page and a chart.
//! - [`ratings`]: tables of raters and questions.

pub mod correlation;
mod error;
pub mod evaluation;
pub mod logistic;
pub mod performance;
pub mod ratings;
mod scores;

pub use error::OpinionError;
pub use scores::Scores;
