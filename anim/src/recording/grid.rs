//! The times of frames of an animation with keys.

use crate::file_error::MotionFileError;

/// Times of frames.
pub(super) struct Grid {
    pub(super) step: f64,
    /// How many steps there are from 0 to the last frame.
    pub(super) steps: f64,
}

impl Grid {
    /// The step where there is nothing to choose it by.
    const DEFAULT_STEP: f64 = 1.0 / 30.0;
    const SHORTEST_STEP: f64 = 1.0 / 240.0;

    /// Frames at a rate, or those that the times of keys suggest.
    pub(super) fn new(rate: Option<f64>, keys: &[f64]) -> Result<Self, MotionFileError> {
        let last = keys.last().copied().unwrap_or(0.0);
        match rate {
            Some(rate) if rate > 0.0 && rate.is_finite() => Ok(Self::of_step(rate.recip(), last)),
            Some(rate) => Err(MotionFileError::Rate(rate)),
            None => Ok(Self::of_keys(keys)),
        }
    }

    /// Frames at a given step, of which the last is at or after the last key.
    fn of_step(step: f64, last: f64) -> Self {
        // A key that is beyond a frame by rounding alone needs no other frame.
        let steps = (last / step - 1e-4).ceil().max(0.0);
        Self { step, steps }
    }

    fn of_keys(keys: &[f64]) -> Self {
        let last = keys.last().copied().unwrap_or(0.0);
        // From one key to the next, the first interval begins at 0.
        let times = || std::iter::once(0.0).chain(keys.iter().copied());
        let intervals = times().zip(times().skip(1)).map(|(a, b)| b - a);
        let shortest = intervals.filter(|&x| x > 0.0).fold(f64::INFINITY, f64::min);
        if shortest == f64::INFINITY {
            return Self::of_step(Self::DEFAULT_STEP, last);
        }
        let of_steps = |steps: f64| Self {
            step: last / steps,
            steps,
        };
        // One key in each frame, however much the shortest interval is rounded in a long motion.
        let later = || keys.iter().copied().filter(|&key| key > 0.0);
        let whole = of_steps(later().count() as f64);
        let is_next = |(k, key): (usize, f64)| (key / whole.step).round() == (k + 1) as f64;
        if later().all(|key| whole.meets(key)) && later().enumerate().all(is_next) {
            return whole;
        }
        let uniform = of_steps((last / shortest).round());
        let steps = uniform.steps;
        // A step shorter than any film's must not come from a few keys that happen to be close.
        let is_warranted = uniform.step >= Self::SHORTEST_STEP || steps <= 2.0 * keys.len() as f64;
        if is_warranted && keys.iter().all(|&key| uniform.meets(key)) {
            return uniform;
        }
        Self::of_step(shortest.max(Self::SHORTEST_STEP), last)
    }

    /// Whether a frame is at a key, up to the rounding of a sum of times in single precision.
    fn meets(&self, key: f64) -> bool {
        let nearest = (key / self.step).round() * self.step;
        (key - nearest).abs() <= rounding(key).max(1e-3 * self.step)
    }

    /// The time of a frame; that of the key there is, where it differs by rounding alone.
    pub(super) fn time(&self, frame: usize, keys: &[f64]) -> f64 {
        let time = frame as f64 * self.step;
        let after = keys.partition_point(|&key| key < time);
        let near = [after.wrapping_sub(1), after].map(|key| keys.get(key));
        let is_here = |key: &&f64| (*key - time).abs() <= rounding(**key);
        near.into_iter()
            .flatten()
            .find(is_here)
            .copied()
            .unwrap_or(time)
    }
}

/// The rounding of a sum of times in single precision.
fn rounding(time: f64) -> f64 {
    4.0 * f64::from(f32::EPSILON) * time
}
