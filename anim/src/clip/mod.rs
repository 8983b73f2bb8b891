//! Clips: poses at equal time steps, and the interpolated ones between; what is made of them.
//!
//! | what | how |
//! | --- | --- |
//! | poses over each other, with weights of joints | [`overlay`], [`Layer`] |
//! | differences that are added to other clips | [`Clip::difference`], [`Clip::added`] |
//! | from one clip to another | [`CrossFade`] |
//! | the way over the ground, and the motion in place | [`Clip::root_motion`], [`RootMotion`] |
//! | left and right exchanged | [`Mirror`] |
//! | another timing | [`TimeWarp`], [`Clip::at_speed`], [`Clip::reversed`] |
//! | what happens at a time; numbers beside the joints | [`EventTrack`], [`ScalarTracks`] |

mod additive;
mod cross_fade;
mod error;
mod event;
mod layering;
mod mirror;
mod root_motion;
mod time_warp;

pub mod compressed;

use crate::frame_position::frame_at;
use crate::pose::Pose;

pub use cross_fade::CrossFade;
pub use error::ClipError;
pub use event::{EventTrack, ScalarTracks};
pub use layering::{Layer, overlay};
pub use mirror::{Mirror, Side, opposite_name, side_of_name};
pub(crate) use mirror::{other_side, reflected};
pub(crate) use root_motion::about;
pub use root_motion::{GroundMotion, RootMotion};
pub use time_warp::TimeWarp;

/// A motion of a skeleton: poses of equally many joints, one each `frame_time`.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    frame_time: f64,
    frames: Vec<Pose>,
}

impl Clip {
    /// A clip of these poses, `frame_time` seconds apart, the first at time 0.
    ///
    /// # Errors
    ///
    /// [`ClipError::Empty`], [`ClipError::FrameTime`] and [`ClipError::JointCount`].
    pub fn new(frame_time: f64, frames: Vec<Pose>) -> Result<Self, ClipError> {
        let Some(first) = frames.first() else {
            return Err(ClipError::Empty);
        };
        if !frame_time.is_finite() || frame_time <= 0.0 {
            return Err(ClipError::FrameTime(frame_time));
        }
        let expected = first.joints.len();
        for (frame, pose) in frames.iter().enumerate() {
            let found = pose.joints.len();
            if found != expected {
                return Err(ClipError::JointCount {
                    frame,
                    expected,
                    found,
                });
            }
        }
        Ok(Self { frame_time, frames })
    }

    /// The time from one frame to the next, in seconds.
    #[must_use]
    pub fn frame_time(&self) -> f64 {
        self.frame_time
    }

    /// The poses; at least one.
    #[must_use]
    pub fn frames(&self) -> &[Pose] {
        &self.frames
    }

    /// How many joints each pose has.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.frames[0].joints.len()
    }

    /// The time of the last frame, in seconds.
    #[must_use]
    pub fn duration(&self) -> f64 {
        (self.frames.len() - 1) as f64 * self.frame_time
    }

    /// The pose at a time in seconds: the frame there, or in between by [`Pose::interpolate`].
    /// Before the first frame and after the last one it is that frame.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::{clip::Clip, pose::Pose};
    /// use ga_runtime::cga3::{Motor, Point, Translator};
    ///
    /// let mut there = Pose::rest(1);
    /// there.root = Motor::from(Translator::from_displacement([0.0, 0.0, 3.0]));
    /// let clip = Clip::new(0.5, vec![Pose::rest(1), there])?;
    /// let [x, y, z] = clip.sample(0.125).root.transform(Point::new(0.0, 0.0, 0.0)).coordinates();
    /// assert!(x.abs() + y.abs() + (z - 0.75).abs() < 1e-15);
    /// # Ok::<(), ga_anim::clip::ClipError>(())
    /// ```
    #[must_use]
    pub fn sample(&self, time: f64) -> Pose {
        let (before, part) = frame_at(time / self.frame_time, self.frames.len() - 1);
        match self.frames.get(before + 1) {
            Some(after) if part > 0.0 => self.frames[before].interpolate(after, part),
            _ => self.frames[before].clone(),
        }
    }

    /// The same motion at `rate` frames per second, from the first frame to the last whole step
    /// within the duration.
    ///
    /// # Errors
    ///
    /// [`ClipError::Rate`].
    pub fn resampled(&self, rate: f64) -> Result<Self, ClipError> {
        // A last step that falls short of the end by rounding alone is still taken.
        let steps = (self.duration() * rate * (1.0 + 1e-12)).floor();
        if !rate.is_finite() || rate <= 0.0 || !self.admits(steps) {
            return Err(ClipError::Rate(rate));
        }
        let frame_time = 1.0 / rate;
        let frames = (0..=steps as u64).map(|step| self.sample(step as f64 * frame_time));
        Self::new(frame_time, frames.collect())
    }

    /// Whether a clip made from this one may have this number of steps from frame to frame: up to
    /// four million motors of joints, or sixteen times as many as this clip has.
    fn admits(&self, steps: f64) -> bool {
        const LIMIT: f64 = (1 << 22) as f64;
        const TIMES: f64 = 16.0;
        let joints = self.joint_count() as f64;
        let own = self.frames.len() as f64 * joints;
        (steps + 1.0) * joints.max(1.0) <= LIMIT.max(TIMES * own)
    }

    /// Fails unless something to be combined with this clip has as many joints.
    fn check_joints(&self, found: usize) -> Result<(), ClipError> {
        match self.joint_count() {
            expected if expected == found => Ok(()),
            expected => Err(ClipError::JointCount {
                frame: 0,
                expected,
                found,
            }),
        }
    }
}
