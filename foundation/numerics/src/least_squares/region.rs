//! How large an error may be where the variance is known from few residuals.

use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

/// The part of all errors that a region is for.
pub(super) const LEVEL: f64 = 0.95;

/// Which regions hold 95 % of all errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// The ellipsoid of all unknowns together.
    Ellipsoid,
    /// The interval of each unknown by itself, 1.96 standard deviations to either side.
    Intervals,
}

/// By how much a covariance of p unknowns with an estimated variance, `C = σ̂² (JᵀJ)⁻¹`, is to be
/// multiplied so that an ellipsoid of the normal distribution is one in which the true values lie
/// with the probability 95 %:
///
/// ```text
/// p F(p, ν; 0.95) / χ²(p; 0.95)
/// ```
///
/// with the quantiles of the F and the χ² distribution. The error e then satisfies `eᵀ C⁻¹ e ≤
/// χ²(p; 0.95)` in 95 % of all cases, as it does for a variance that is known (H. Hotelling, "The
/// generalization of Student's ratio", The Annals of Mathematical Statistics 2, 1931). ν is the
/// redundancy of the variance, the number of residuals less that of the unknowns. `None` for no
/// unknowns, and for a ν that is not positive and finite.
///
/// ```
/// use ga_numerics::least_squares::region_factor;
///
/// // A pose from 12 points: 24 coordinates of pixels and 6 unknowns. F(6, 18; 0.95) is 2.6613.
/// let factor = region_factor(6, 18.0).unwrap();
/// assert!((factor - 6.0 * 2.6613 / 12.5916).abs() < 1e-4);
/// // From many residuals, the variance is as good as known.
/// assert!((region_factor(6, 1e6).unwrap() - 1.0).abs() < 1e-4);
/// ```
#[must_use]
pub fn region_factor(unknowns: usize, redundancy: f64) -> Option<f64> {
    let count = unknowns as f64;
    if unknowns == 0 || !redundancy.is_finite() || redundancy <= 0.0 {
        return None;
    }
    let estimated = FisherSnedecor::new(count, redundancy).ok()?;
    let known = ChiSquared::new(count).ok()?;
    let factor = count * estimated.inverse_cdf(LEVEL) / known.inverse_cdf(LEVEL);
    factor.is_finite().then_some(factor)
}
