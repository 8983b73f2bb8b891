//! The same motion at another number of frames per second.

use super::{Recording, ScalarTrack};
use crate::recording::RecordingError;
use crate::transform::Transform;

/// The greatest number of transforms that is made of a recording of fewer.
const LIMIT: usize = 1 << 22;

impl Recording {
    /// The same motion at `rate` frames per second, from the first frame to the last whole step
    /// within the duration. A frame is what [`Recording::sample`] gives at its time; at the
    /// recording's own rate all frames stay as they are.
    ///
    /// # Errors
    ///
    /// [`RecordingError::Rate`] unless the rate is positive and finite, and
    /// [`RecordingError::TooLarge`] past four million transforms, unless the recording itself has
    /// as many.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::recording::Recording;
    ///
    /// let motion = ga_anim::bvh::decode(
    ///     b"HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 2 Xposition Zrotation }
    ///       MOTION Frames: 3 Frame Time: 0.5
    ///       0 0
    ///       4 20
    ///       8 40",
    /// )?;
    /// let recording = Recording::from_bvh(&motion, 1.0)?.resampled(8.0)?;
    /// assert_eq!((recording.frame_count(), recording.frame_time()), (9, 0.125));
    /// let arm = &recording.frame(3).ok_or("no frame")?[0];
    /// assert!((arm.translation().coordinates()[0] - 3.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn resampled(&self, rate: f64) -> Result<Self, RecordingError> {
        if !rate.is_finite() || rate <= 0.0 {
            return Err(RecordingError::Rate(rate));
        }
        // A rate is often the rounded reciprocal of the time between frames.
        if (rate * self.frame_time - 1.0).abs() <= 4.0 * f64::EPSILON {
            return Ok(self.clone());
        }
        let frame_time = rate.recip();
        if !frame_time.is_finite() {
            return Err(RecordingError::Rate(rate));
        }
        let frames = frames_within(self.duration(), frame_time);
        let count = self.joints.len();
        let frames = checked_frames(frames, count, self.locals.len())?;
        let step = frame_time / self.frame_time;
        let mut locals = vec![Transform::default(); frames * count];
        for (frame, locals) in locals.chunks_exact_mut(count).enumerate() {
            self.fill(frame as f64 * step, locals);
        }
        let tracks = self.tracks.iter().map(|track| ScalarTrack {
            name: track.name.clone(),
            values: (0..frames)
                .map(|frame| self.track_at(track, frame as f64 * step))
                .collect(),
        });
        Self::new(self.joints.clone(), frame_time, locals, tracks.collect())
    }
}

/// How many frames there are from 0 to the last whole step within a duration. A last step that
/// falls short of the end by rounding alone is still taken.
pub(super) fn frames_within(duration: f64, frame_time: f64) -> f64 {
    (duration / frame_time * (1.0 + 1e-12)).floor() + 1.0
}

/// A number of frames, unless they are out of proportion to a source of this many transforms.
pub(super) fn checked_frames(
    frames: f64,
    joints: usize,
    source: usize,
) -> Result<usize, RecordingError> {
    let limit = LIMIT.max(source);
    if frames * joints as f64 > limit as f64 {
        return Err(RecordingError::TooLarge {
            frames,
            joints,
            limit,
        });
    }
    Ok(frames as usize)
}
