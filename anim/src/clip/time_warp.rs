//! Clips faster, slower, or in step with another.

use super::Clip;
use crate::clip::ClipError;
use crate::curve::{Curve, CurveError};

/// A clock that runs unevenly: the time of a clip as a function of the time at which it is seen.
///
/// Between its keys it is a monotone cubic curve (F. N. Fritsch and R. E. Carlson, "Monotone
/// piecewise cubic interpolation", SIAM Journal on Numerical Analysis 17, 1980), so the clip never
/// runs backwards and its speed does not jump.
///
/// ```
/// use ga_anim::clip::TimeWarp;
/// // Contacts at 0, 0.4 and 1 second of a clip are to be seen at 0, 0.5 and 1.
/// let warp = TimeWarp::through(&[0.0, 0.5, 1.0], &[0.0, 0.4, 1.0])?;
/// assert_eq!(warp.clip_time(0.5), 0.4);
/// assert!((warp.seen_at(0.4) - 0.5).abs() < 1e-15);
/// # Ok::<(), ga_anim::curve::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TimeWarp {
    curve: Curve<f64>,
}

impl TimeWarp {
    /// The clock that shows `clip_times` at the times `seen`; both rise.
    ///
    /// # Errors
    ///
    /// Fewer than two keys, lists of different lengths, numbers that are not finite, and times that
    /// do not rise, in either list.
    pub fn through(seen: &[f64], clip_times: &[f64]) -> Result<Self, CurveError> {
        if seen.len() < 2 {
            return Err(CurveError::TooFewKeys {
                found: seen.len(),
                needed: 2,
            });
        }
        // As a check of both.
        Curve::linear(clip_times, clip_times)?;
        let lines = Curve::linear(seen, clip_times)?;
        let lines: Vec<f64> = lines.pieces().iter().map(|piece| piece[1]).collect();
        let last = seen.len() - 1;
        let slope = |key: usize| match key {
            0 => lines[0],
            key if key == last => lines[last - 1],
            key => {
                // The weighted harmonic mean of F. N. Fritsch and J. Butland (1984).
                let [h0, h1] = [seen[key] - seen[key - 1], seen[key + 1] - seen[key]];
                let [w0, w1] = [2.0 * h1 + h0, h1 + 2.0 * h0];
                (w0 + w1) / (w0 / lines[key - 1] + w1 / lines[key])
            }
        };
        let slopes: Vec<f64> = (0..=last).map(slope).collect();
        Curve::hermite(seen, clip_times, &slopes, &slopes).map(|curve| Self { curve })
    }

    /// The time of the clip that is seen at a time. Before the first key and after the last one it
    /// stands still.
    #[must_use]
    pub fn clip_time(&self, seen: f64) -> f64 {
        self.curve.value(seen)
    }

    /// When a time of the clip is seen: the inverse of [`TimeWarp::clip_time`], by bisection.
    #[must_use]
    pub fn seen_at(&self, clip_time: f64) -> f64 {
        let (mut low, mut high) = (self.curve.start(), self.curve.end());
        loop {
            let middle = 0.5 * low + 0.5 * high;
            if !(low < middle && middle < high) {
                break;
            }
            if self.clip_time(middle) < clip_time {
                low = middle;
            } else {
                high = middle;
            }
        }
        // The neighbour that is nearer.
        let [below, above] = [low, high].map(|time| (self.clip_time(time) - clip_time).abs());
        if below <= above { low } else { high }
    }

    /// The times that are seen, from the first key to the last.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.curve.end() - self.curve.start()
    }
}

impl Clip {
    /// The clip as a clock shows it, with the same time from frame to frame.
    ///
    /// # Errors
    ///
    /// [`ClipError::Rate`] where the clock runs so long that there would be too many frames.
    pub fn warped(&self, warp: &TimeWarp) -> Result<Self, ClipError> {
        let steps = (warp.duration() / self.frame_time * (1.0 + 1e-12)).floor();
        if !self.admits(steps) {
            return Err(ClipError::Rate(self.frame_time.recip()));
        }
        let start = warp.curve.start();
        let frame = |step: u64| self.sample(warp.clip_time(start + step as f64 * self.frame_time));
        Self::new(self.frame_time, (0..=steps as u64).map(frame).collect())
    }

    /// The clip at `factor` times its speed: the same frames, closer in time.
    ///
    /// # Errors
    ///
    /// [`ClipError::FrameTime`] where the factor is not above 0.
    pub fn at_speed(&self, factor: f64) -> Result<Self, ClipError> {
        Self::new(self.frame_time / factor, self.frames.clone())
    }

    /// The clip backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let mut clip = self.clone();
        clip.frames.reverse();
        clip
    }
}
