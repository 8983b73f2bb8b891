//! Weighted means of motors. They gather from all over the palette, which no path makes faster.

use core::fmt;

use super::{Batch, LengthMismatch, same_length};
use crate::cga3::{DualQuaternion, Motor};
use crate::scalar::Real;

/// Why motors cannot be blended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlendError {
    /// There are not as many results as lists of influences.
    Length(LengthMismatch),
    /// An influence names a motor that the palette does not have.
    NotInPalette {
        /// The result that is influenced.
        element: usize,
        /// The place that is named.
        place: usize,
        /// The number of motors in the palette.
        palette: usize,
    },
    /// The weighted sum of this result is no multiple of a motor: the weights are all zero or not
    /// finite, or the motors cancel.
    NoDirection {
        /// The result.
        element: usize,
    },
}

impl fmt::Display for BlendError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(mismatch) => mismatch.fmt(f),
            Self::NotInPalette {
                element,
                place,
                palette,
            } => write!(
                f,
                "element {element} is influenced by motor {place} of a palette of {palette}"
            ),
            Self::NoDirection { element } => {
                write!(f, "the motors of element {element} have no mean")
            }
        }
    }
}

impl core::error::Error for BlendError {}

impl From<LengthMismatch> for BlendError {
    fn from(mismatch: LengthMismatch) -> Self {
        Self::Length(mismatch)
    }
}

impl Batch {
    /// See [`blend`](super::blend).
    ///
    /// # Errors
    /// The lengths differ, a place is not in the palette, or the mean of an element has no
    /// direction.
    pub fn blend<S: Real<Mask = bool>, const K: usize>(
        self,
        palette: &[Motor<S>],
        influences: &[[(usize, S); K]],
        means: &mut [Motor<S>],
    ) -> Result<(), BlendError> {
        same_length(influences.len(), means.len())?;
        for (element, list) in influences.iter().enumerate() {
            let outside = list.iter().find(|(place, _)| *place >= palette.len());
            if let Some(&(place, _)) = outside.filter(|(_, weight)| *weight != S::zero()) {
                return Err(BlendError::NotInPalette {
                    element,
                    place,
                    palette: palette.len(),
                });
            }
        }
        for (element, (list, mean)) in influences.iter().zip(means).enumerate() {
            *mean = weighted_mean(palette, list).ok_or(BlendError::NoDirection { element })?;
        }
        Ok(())
    }
}

fn weighted_mean<S: Real<Mask = bool>>(
    palette: &[Motor<S>],
    influences: &[(usize, S)],
) -> Option<Motor<S>> {
    let mut first: Option<Motor<S>> = None;
    let mut sum = DualQuaternion::from(Motor::default()) * S::zero();
    for &(place, weight) in influences {
        let Some(motor) = palette.get(place).filter(|_| weight != S::zero()) else {
            continue;
        };
        let reference = *first.get_or_insert(*motor);
        let along = reference.scalar() * motor.scalar()
            + reference.e12() * motor.e12()
            + reference.e13() * motor.e13()
            + reference.e23() * motor.e23();
        let signed = S::select(along.less_than(S::zero()), -weight, weight);
        sum += *motor * signed;
    }
    sum.normalize()
}
