//! Weighted means of motors. The motors are read from arbitrary indices of the palette, so vector
//! instructions would not make this faster.

use core::fmt;

use super::{Batch, LengthMismatch, same_length};
use crate::cga3::Motor;
use crate::scalar::Real;

/// Why motors cannot be blended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlendError {
    /// The numbers of results and of lists of influences differ.
    Length(LengthMismatch),
    /// The index in an influence is outside of the palette.
    NotInPalette {
        /// The index of the result.
        element: usize,
        /// The index of the motor.
        place: usize,
        /// The number of motors in the palette.
        palette: usize,
    },
    /// The weighted sum of this result is not a multiple of a motor: the weights are all zero or
    /// not finite, or the motors cancel.
    NoDirection {
        /// The index of the result.
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
    /// The lengths differ, an index is outside of the palette, or the mean of an element does not
    /// exist.
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
            let counting = list.iter().filter(|(_, weight)| *weight != S::zero());
            let weighted =
                counting.filter_map(|&(place, weight)| Some((weight, *palette.get(place)?)));
            *mean = Motor::blend_influences(weighted).ok_or(BlendError::NoDirection { element })?;
        }
        Ok(())
    }
}
