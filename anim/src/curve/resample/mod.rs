//! Few vertices on a curve, with a proven bound of the distance to it (Cui, §2.2.2 (3)).

mod chord;
mod path;
mod search;

use super::piecewise::Curve;
use super::value::Value;
use crate::curve::CurveError;
pub use chord::Distance;
use path::Path;

/// Vertices on a curve; see [`Curve::resampled`].
#[derive(Clone, Debug, PartialEq)]
pub struct Resampled<V> {
    /// The times of the vertices: they rise from that of the first key to that of the last one.
    pub times: Vec<f64>,
    /// The values of the curve at these times.
    pub values: Vec<V>,
    /// The proven bound of the distance between curve and polyline; at most the tolerance.
    pub max_deviation: f64,
}

impl<V: Value> Curve<V> {
    /// Vertices on the curve, from its first key to its last, such that the straight lines between
    /// them stay within `tolerance` of the curve: few where it is gentle, more where it turns.
    ///
    /// The bound holds for every point of the curve, and rounding is included. Along a chord from a
    /// to b, each piece of the curve is cut into parts of at most a 16th of b − a. At their ends
    /// the distance is computed; in between it exceeds the larger of the two by at most Δ²/8 · max
    /// |P⊥c″|, where Δ is the length of the part and P⊥c″ the part of the second derivative across
    /// the chord. As c″ is linear, its maximum is at the ends. Where the Bézier coefficients of the
    /// foot on the chord's line are beyond the ends of the chord, that distance counts too. At
    /// equal times the whole of c″ counts.
    ///
    /// Each vertex is the farthest that can be proven, to 1 %. For small tolerances the number of
    /// chords is that of the best polyline with vertices on the curve, ∫ √(κ/8ε) ds with the
    /// curvature κ (at equal times ∫ √(|c″|/8ε) dt), to about 2 %.
    ///
    /// # Errors
    ///
    /// [`CurveError`]. The bound can be proven for any tolerance from 16 units in the last place
    /// of the largest coordinate up, unless times are too coarse for the speed of the curve.
    ///
    /// ```
    /// use ga_anim::curve::{Curve, Distance, Ends};
    /// let times = [0.0, 1.0, 2.0, 3.0, 4.0];
    /// let circle = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]];
    /// let circle = Curve::spline(&times, &circle, Ends::Periodic)?;
    /// let polygon = circle.resampled(0.01, Distance::Geometric)?;
    /// // A regular polygon of 23 sides has this distance from a circle.
    /// assert!(polygon.values.len() - 1 <= 25 && polygon.max_deviation <= 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn resampled(
        &self,
        tolerance: f64,
        distance: Distance,
    ) -> Result<Resampled<V>, CurveError> {
        self.resampled_within(tolerance, distance, usize::MAX)
    }

    /// The same with at most `most` vertices.
    ///
    /// # Errors
    ///
    /// As [`Curve::resampled`], and [`CurveError::TooMany`].
    pub fn resampled_within(
        &self,
        tolerance: f64,
        distance: Distance,
        most: usize,
    ) -> Result<Resampled<V>, CurveError> {
        let path = Path::of(&self.times, V::DIMENSION, |piece, channel| {
            match self.pieces.get(piece) {
                Some(c) => c.map(|c| c.component(channel)),
                None => [self.last.component(channel), 0.0, 0.0, 0.0],
            }
        });
        let (times, max_deviation) = search::vertices(&path, tolerance, distance, most)?;
        let held = self.clone().with_outside(super::Outside::Hold);
        let mut cursor = held.cursor();
        let values = times.iter().map(|&time| cursor.value(time)).collect();
        Ok(Resampled {
            times,
            values,
            max_deviation,
        })
    }
}

/// Vertices on a curve whose channels are separate curves with the same times: the values are a
/// list for each vertex. See [`Curve::resampled_within`].
///
/// # Errors
///
/// As [`Curve::resampled_within`], and [`CurveError::Times`] where channels have different
/// times. Without a channel there is no vertex.
pub fn resample_channels(
    channels: &[Curve<f64>],
    tolerance: f64,
    distance: Distance,
    most: usize,
) -> Result<Resampled<Vec<f64>>, CurveError> {
    let Some(first) = channels.first() else {
        return Ok(Resampled {
            times: Vec::new(),
            values: Vec::new(),
            max_deviation: 0.0,
        });
    };
    if let Some(channel) = channels
        .iter()
        .position(|channel| channel.times != first.times)
    {
        return Err(CurveError::Times { channel });
    }
    let path = Path::of(&first.times, channels.len(), |piece, channel| {
        let channel = &channels[channel];
        let end = [channel.last, 0.0, 0.0, 0.0];
        channel.pieces.get(piece).copied().unwrap_or(end)
    });
    let (times, max_deviation) = search::vertices(&path, tolerance, distance, most)?;
    Ok(Resampled {
        values: sample_channels(channels, &times),
        times,
        max_deviation,
    })
}

/// The values of channels at rising times: a row for each time, with a number for each channel.
/// Beyond the first and the last key each channel keeps its value there, periodic ones too.
///
/// # Examples
///
/// ```
/// use ga_anim::curve::{Curve, sample_channels};
///
/// let x = Curve::linear(&[0.0, 2.0], &[0.0, 4.0])?;
/// let y = Curve::linear(&[0.0, 1.0], &[1.0, 0.0])?;
/// assert_eq!(sample_channels(&[x, y], &[0.5, 2.0]), [[1.0, 0.5], [4.0, 0.0]]);
/// # Ok::<(), ga_anim::curve::CurveError>(())
/// ```
#[must_use]
pub fn sample_channels(channels: &[Curve<f64>], times: &[f64]) -> Vec<Vec<f64>> {
    let held: Vec<_> = channels
        .iter()
        .map(|channel| channel.clone().with_outside(super::Outside::Hold))
        .collect();
    let mut cursors: Vec<_> = held.iter().map(Curve::cursor).collect();
    let row = |&time: &f64| {
        cursors
            .iter_mut()
            .map(|cursor| cursor.value(time))
            .collect()
    };
    times.iter().map(row).collect()
}
