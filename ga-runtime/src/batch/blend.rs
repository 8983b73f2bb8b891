//! Weighted means of motors. The motors are read from arbitrary indices of the palette, so vector
//! instructions would not make this faster.

use super::Batch;
use super::error::same_length;
use crate::batch::BatchError;
use crate::cga3::Motor;
use crate::scalar::Real;

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
    ) -> Result<(), BatchError> {
        same_length(influences.len(), means.len())?;
        for (element, list) in influences.iter().enumerate() {
            let outside = list.iter().find(|(place, _)| *place >= palette.len());
            if let Some(&(place, _)) = outside.filter(|(_, weight)| *weight != S::zero()) {
                return Err(BatchError::NotInPalette {
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
            *mean = Motor::blend_influences(weighted).ok_or(BatchError::NoDirection { element })?;
        }
        Ok(())
    }
}
