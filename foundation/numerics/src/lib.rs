//! Numerical methods without geometry of their own.
//!
//! - [`least_squares`]: nonlinear least squares over any unknowns, with covariances.
//! - [`banded`]: linear equations in which each part is joined to its neighbours.
//! - [`conjugate_gradient`]: linear equations whose matrix is too large to be stored.
//! - [`ransac`]: models that most observations agree with.
//! - [`order_statistics`]: medians and other quantiles.
//! - [`polynomial`]: real roots of polynomials in one unknown.

pub mod banded;
pub mod conjugate_gradient;
pub mod least_squares;
pub mod order_statistics;
pub mod polynomial;
pub mod ransac;
