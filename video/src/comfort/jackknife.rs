//! Standard errors without assumptions on the distribution.

/// The standard error of a number by the jackknife, from its values when one part of the data is
/// left out in turn: √((n − 1)/n Σ (θᵢ − θ̄)²) (B. Efron and R. Tibshirani, "An introduction to the
/// bootstrap", 1993, eq. 11.5). It is infinite for fewer than two parts.
pub(super) fn standard_error(without: &[f64]) -> f64 {
    let count = without.len() as f64;
    if without.len() < 2 {
        return f64::INFINITY;
    }
    let mean = without.iter().sum::<f64>() / count;
    let squares: f64 = without.iter().map(|value| (value - mean).powi(2)).sum();
    ((count - 1.0) / count * squares).sqrt()
}
