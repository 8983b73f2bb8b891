//! Weights of a sum.

use core::fmt::{Debug, Display, Formatter, Result as FmtResult};

use crate::scalar::Real;

/// Weights that do not define an average.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum WeightError<S> {
    /// A weight is negative or not finite.
    Invalid {
        /// The index of the weight, from 0.
        index: usize,
        /// Its value.
        weight: S,
    },
    /// All weights are zero.
    AllZero,
}

impl<S: Debug> Display for WeightError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FmtResult {
        match self {
            Self::Invalid { index, weight } => {
                write!(
                    f,
                    "weight {index} is {weight:?}, but must be zero or a positive number"
                )
            }
            Self::AllZero => f.write_str("all weights are zero"),
        }
    }
}

impl<S: Debug> core::error::Error for WeightError<S> {}

/// The weight of this index, if it is valid.
pub(super) fn checked<S: Real<Mask = bool>>(index: usize, weight: S) -> Result<S, WeightError<S>> {
    if weight.less_than(S::zero()) || !weight.is_finite() {
        return Err(WeightError::Invalid { index, weight });
    }
    Ok(weight)
}
