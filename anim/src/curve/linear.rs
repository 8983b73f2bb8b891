//! Straight lines from key to key, and steps.

use super::error::{check_times, check_values};
use super::piecewise::{Curve, Outside};
use super::value::Value;
use crate::curve::CurveError;

impl<V: Value> Curve<V> {
    /// The curve that goes straight from each key to the next at constant speed (glTF's LINEAR for
    /// anything but rotations).
    ///
    /// # Errors
    ///
    /// No keys, lists of different lengths, numbers that are not finite, times that do not rise.
    pub fn linear(times: &[f64], values: &[V]) -> Result<Self, CurveError> {
        Self::from_pairs(times, values, |from, to, h| {
            let slope = V::from_components(|k| (to.component(k) - from.component(k)) / h);
            [from, slope, V::zero(), V::zero()]
        })
    }

    /// The curve that stays at the value of each key up to the next one (glTF's STEP).
    ///
    /// # Errors
    ///
    /// As [`Curve::linear`].
    pub fn step(times: &[f64], values: &[V]) -> Result<Self, CurveError> {
        Self::from_pairs(times, values, |from, _, _| {
            [from, V::zero(), V::zero(), V::zero()]
        })
    }

    fn from_pairs(
        times: &[f64],
        values: &[V],
        piece: impl Fn(V, V, f64) -> [V; 4],
    ) -> Result<Self, CurveError> {
        check_times(times, 1)?;
        check_values("values", values, times.len())?;
        let pairs = times.windows(2).zip(values.windows(2));
        let pieces = pairs.map(|(t, v)| piece(v[0], v[1], t[1] - t[0])).collect();
        Self::new(times, pieces, values[values.len() - 1], Outside::Hold)
    }
}
