//! Differences of poses, which are added to other poses: a breath, a lean, a recoil.

use ga_runtime::cga3::Motor;

use super::Clip;
use crate::clip::ClipError;
use crate::pose::Pose;

impl Pose {
    /// What must be added to `reference` to get this pose: for the root and each joint D = ~R M,
    /// the motion from the reference R to the motor M, in the frame of the moved joint.
    ///
    /// Only as many joints as both poses have are kept.
    #[must_use]
    pub fn difference(&self, reference: &Self) -> Self {
        let joints = self.joints.iter().zip(&reference.joints);
        Self {
            root: reference.root.reverse() * self.root,
            joints: joints
                .map(|(&own, reference)| reference.reverse() * own)
                .collect(),
        }
    }

    /// This pose with a part `weight` of a [`Pose::difference`] added: M Dʷ, with the power of a
    /// motor along its screw, by the shorter rotation. A weight of 0 leaves the pose as it is, and
    /// a weight of 1 restores what the difference was taken of, where this is its reference. Other
    /// weights exaggerate or reverse it.
    ///
    /// Only as many joints as both have are kept.
    ///
    /// ```
    /// use ga_anim::pose::Pose;
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let mut lean = Pose::rest(1);
    /// lean.joints[0] = Motor::from(Translator::from_displacement([0.0, 2.0, 0.0]));
    /// let difference = lean.difference(&Pose::rest(1));
    /// let more = lean.added(&difference, 0.5);
    /// assert_eq!(more.joints[0].translator().displacement(), [0.0, 3.0, 0.0]);
    /// ```
    #[must_use]
    pub fn added(&self, difference: &Self, weight: f64) -> Self {
        let joints = self.joints.iter().zip(&difference.joints);
        Self {
            root: self.root * part(difference.root, weight),
            joints: joints
                .map(|(&own, &other)| own * part(other, weight))
                .collect(),
        }
    }
}

impl Clip {
    /// The clip of the differences of all frames from one pose; see [`Pose::difference`].
    ///
    /// # Errors
    ///
    /// [`ClipError::JointCount`] when the reference has another number of joints.
    pub fn difference(&self, reference: &Pose) -> Result<Self, ClipError> {
        self.check_joints(reference.joints.len())?;
        let frames = self
            .frames
            .iter()
            .map(|pose| pose.difference(reference))
            .collect();
        Self::new(self.frame_time, frames)
    }

    /// This clip with a part of a clip of differences added to each frame, at the same times; after
    /// its end the difference stays that of its last frame. See [`Pose::added`].
    ///
    /// # Errors
    ///
    /// [`ClipError::JointCount`] when the clips have different numbers of joints.
    pub fn added(&self, differences: &Self, weight: f64) -> Result<Self, ClipError> {
        self.check_joints(differences.joint_count())?;
        let frames = self.frames.iter().enumerate().map(|(frame, pose)| {
            let time = frame as f64 * self.frame_time;
            pose.added(&differences.sample(time), weight)
        });
        Self::new(self.frame_time, frames.collect())
    }
}

fn part(motor: Motor<f64>, weight: f64) -> Motor<f64> {
    if weight == 1.0 {
        motor
    } else {
        Motor::default().interpolate(motor, weight)
    }
}
