//! From recordings to clips of motions in the mesh's coordinates, and back.

use ga_runtime::cga3::{Motor, Translator};
use ga_runtime::vga3::Vector;

use super::{RecordedJoint, Recording, model_motors};
use crate::clip::Clip;
use crate::kinematics::KinematicsError;
use crate::pose::Pose;
use crate::recording::RecordingError;
use crate::skeleton::{Joint, Skeleton, SkeletonError};
use crate::transform::Transform;

impl Recording {
    /// The skeleton at rest, in model space. A bone ends at the mean place of its children; one
    /// without children has no length.
    ///
    /// # Errors
    ///
    /// [`RecordingError::Kinematics`] where a joint is scaled at rest, and
    /// [`RecordingError::Skeleton`] where two joints have the same name.
    pub fn to_skeleton(&self) -> Result<Skeleton, RecordingError> {
        let heads: Vec<Vector<f64>> = self
            .rest_motors()?
            .into_iter()
            .map(|motor| motor.translator().displacement().into())
            .collect();
        let mut below = vec![(Vector::default(), 0u32); heads.len()];
        for (parent, &head) in self.parents.iter().zip(&heads) {
            if let Some(parent) = *parent {
                below[parent].0 += head;
                below[parent].1 += 1;
            }
        }
        let joints = self.joints.iter().zip(&heads).zip(below);
        let joints = joints.map(|((joint, &head), (sum, count))| Joint {
            name: joint.name.clone(),
            parent: joint.parent,
            head: head.coordinates(),
            tail: match count {
                0 => head.coordinates(),
                _ => (sum * f64::from(count).recip()).coordinates(),
            },
        });
        Ok(Skeleton::new(joints.collect())?)
    }

    /// The same motion as motions of the mesh's coordinates: the total motion of a joint is
    /// G = F ~F₀, and its own motion ~G_parent G. The poses are for [`Recording::to_skeleton`].
    ///
    /// # Errors
    ///
    /// [`RecordingError::Kinematics`] where a joint is scaled.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::recording::Recording;
    ///
    /// let motion = ga_anim::bvh::decode(
    ///     b"HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Zrotation
    ///         JOINT hand { OFFSET 1 0 0 CHANNELS 1 Xrotation } }
    ///       MOTION Frames: 1 Frame Time: 0.01
    ///       90 0",
    /// )?;
    /// let recording = Recording::from_bvh(&motion, 1.0)?;
    /// let (skeleton, clip) = (recording.to_skeleton()?, recording.to_clip()?);
    /// let [hand, _] = clip.frames()[0].bones(&skeleton)?[1];
    /// assert!((hand[1] - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_clip(&self) -> Result<Clip, RecordingError> {
        let rest = self.rest_motors()?;
        let mut frames = Vec::with_capacity(self.frame_count());
        let mut motors = vec![Motor::default(); self.joints.len()];
        for locals in self.locals.chunks_exact(self.joints.len()) {
            model_motors(&self.parents, locals, &mut motors)?;
            let mut pose = Pose::rest(motors.len());
            for (motor, rest) in motors.iter_mut().zip(&rest) {
                *motor *= rest.reverse();
            }
            for (own, (parent, &total)) in
                pose.joints.iter_mut().zip(self.parents.iter().zip(&motors))
            {
                *own = parent.map_or(total, |parent| motors[parent].reverse() * total);
            }
            frames.push(pose);
        }
        Ok(Clip::new(self.frame_time, frames)?)
    }

    /// The recording of a clip. A joint's frame stands at the joint with the axes of the mesh, so
    /// with h the joint's place at rest, p its parent's, and L its own motion, its transform is
    /// T(−p) L T(h). For a root, the motion of the whole skeleton takes the place of T(−p).
    ///
    /// # Errors
    ///
    /// [`RecordingError::Skeleton`] where the clip is for a skeleton with another number of joints.
    pub fn from_clip(skeleton: &Skeleton, clip: &Clip) -> Result<Self, RecordingError> {
        let joints = skeleton.joints();
        let to = |place: [f64; 3]| Motor::from(Translator::from_displacement(place));
        let from = |place: [f64; 3]| to(place.map(|x| -x));
        let local = |joint: &Joint, root, own: Motor<f64>| {
            let above = joint
                .parent
                .map_or(root, |parent| from(joints[parent].head));
            Transform::from(above * own * to(joint.head))
        };
        let mut locals = Vec::with_capacity(clip.frames().len() * joints.len());
        for pose in clip.frames() {
            let (expected, found) = (joints.len(), pose.joints.len());
            if expected != found {
                return Err(SkeletonError::PoseLength { expected, found }.into());
            }
            let own = joints.iter().zip(&pose.joints);
            locals.extend(own.map(|(joint, &own)| local(joint, pose.root, own)));
        }
        let joints = joints.iter().map(|joint| RecordedJoint {
            name: joint.name.clone(),
            parent: joint.parent,
            rest: local(joint, Motor::default(), Motor::default()),
        });
        Self::new(joints.collect(), clip.frame_time(), locals, Vec::new())
    }

    fn rest_motors(&self) -> Result<Vec<Motor<f64>>, KinematicsError> {
        let locals: Vec<_> = self.joints.iter().map(|joint| joint.rest).collect();
        let mut motors = vec![Motor::default(); locals.len()];
        model_motors(&self.parents, &locals, &mut motors)?;
        Ok(motors)
    }
}
