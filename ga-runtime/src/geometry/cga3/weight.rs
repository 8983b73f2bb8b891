//! Weights of a sum.

use crate::geometry::FitError;
use crate::scalar::Real;

/// The weight of this index, if it is valid.
pub(super) fn checked<S: Real<Mask = bool>>(index: usize, weight: S) -> Result<S, FitError<S>> {
    if weight.less_than(S::zero()) || !weight.is_finite() {
        return Err(FitError::InvalidWeight { index, weight });
    }
    Ok(weight)
}
