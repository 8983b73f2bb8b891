//! From one clip to another.

use super::Clip;
use super::layering::mean;
use crate::clip::ClipError;
use crate::pose::Pose;

/// The change from one clip to another: the first alone, then both with a weight that rises
/// smoothly, then the second alone.
///
/// ```
/// use ga_anim::{clip::{Clip, CrossFade}, pose::Pose};
/// use ga_runtime::cga3::{Motor, Translator};
/// let still = |x: f64| {
///     let mut pose = Pose::rest(1);
///     pose.root = Motor::from(Translator::from_displacement([x, 0.0, 0.0]));
///     Clip::new(1.0, vec![pose.clone(), pose])
/// };
/// let (from, to) = (still(0.0)?, still(2.0)?);
/// let fade = CrossFade::new(&from, &to, 0.5, 1.0)?;
/// let at = |time: f64| fade.sample(time).root.translator().displacement()[0];
/// assert_eq!([at(0.25), at(1.0), at(1.75)], [0.0, 1.0, 2.0]);
/// # Ok::<(), ga_anim::clip::ClipError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CrossFade<'a> {
    from: &'a Clip,
    to: &'a Clip,
    start: f64,
    duration: f64,
}

impl<'a> CrossFade<'a> {
    /// The change from `from` to `to` that begins at the time `start` of the first clip and takes
    /// `duration` seconds. The second clip begins with the change; a duration of 0 is a cut.
    ///
    /// # Errors
    ///
    /// [`ClipError::JointCount`] when the clips have different numbers of joints, and
    /// [`ClipError::Time`] for a time that is negative or not finite.
    pub fn new(from: &'a Clip, to: &'a Clip, start: f64, duration: f64) -> Result<Self, ClipError> {
        from.check_joints(to.joint_count())?;
        for time in [start, duration] {
            if !(time.is_finite() && time >= 0.0) {
                return Err(ClipError::Time(time));
            }
        }
        Ok(Self {
            from,
            to,
            start,
            duration,
        })
    }

    /// When the second clip ends, in seconds from the beginning of the first one.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.start + self.duration.max(self.to.duration())
    }

    /// The weight of the second clip at a time: 3s² − 2s³ for the part s of the change, which
    /// begins and ends without a jump of the velocity.
    #[must_use]
    pub fn weight(&self, time: f64) -> f64 {
        let since = time - self.start;
        if since <= 0.0 && self.duration > 0.0 || since < 0.0 || since.is_nan() {
            return 0.0;
        }
        if since >= self.duration {
            return 1.0;
        }
        let s = since / self.duration;
        s * s * (3.0 - 2.0 * s)
    }

    /// The pose at a time in seconds from the beginning of the first clip.
    #[must_use]
    pub fn sample(&self, time: f64) -> Pose {
        let weight = self.weight(time);
        if weight <= 0.0 {
            return self.from.sample(time);
        }
        let mut pose = self.to.sample(time - self.start);
        if weight < 1.0 {
            let before = self.from.sample(time);
            pose.root = mean(before.root, pose.root, weight);
            for (joint, &before) in pose.joints.iter_mut().zip(&before.joints) {
                *joint = mean(before, *joint, weight);
            }
        }
        pose
    }
}
