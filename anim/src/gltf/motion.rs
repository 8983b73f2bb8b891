//! Skeletons and clips as nodes and animations.
//!
//! A joint's node stands at the joint's place, with the axes of the mesh. With h the joint's place
//! at rest, p its parent's, and L its own motion, its place relative to its parent's node is the
//! motor
//!
//! ```text
//! N = T(−p) L T(h)
//! ```
//!
//! so T(h − p) at rest; for a root, the motion of the whole skeleton stands in place of T(−p).

use ga_runtime::cga3::{Motor, Point, Translator};

use super::{Animation, JointNode, RigidTransform, Track};
use crate::clip::Clip;
use crate::pose::{Pose, PoseError};
use crate::skeleton::{Joint, Skeleton};

impl From<Motor<f64>> for RigidTransform {
    /// A motor's rotor `w − x e23 + y e13 − z e12` is the quaternion *(x, y, z, w)*, since a turn
    /// about the axis *n* by α is cos(α/2) − sin(α/2) (n₁ e23 − n₂ e13 + n₃ e12). Its translation
    /// is where it takes the origin.
    fn from(motor: Motor<f64>) -> Self {
        Self {
            rotation: [-motor.e23(), motor.e13(), -motor.e12(), motor.scalar()],
            translation: motor.transform(Point::new(0.0, 0.0, 0.0)).coordinates(),
        }
    }
}

impl JointNode {
    /// The joints of a skeleton, at rest.
    pub fn from_skeleton(skeleton: &Skeleton) -> Vec<Self> {
        let joints = skeleton.joints();
        let node = |joint: &Joint| {
            let above = joint.parent.map_or([0.0; 3], |parent| joints[parent].head);
            Self {
                name: joint.name.clone(),
                parent: joint.parent,
                rest: RigidTransform {
                    translation: std::array::from_fn(|axis| joint.head[axis] - above[axis]),
                    ..RigidTransform::default()
                },
            }
        };
        joints.iter().map(node).collect()
    }
}

impl Animation {
    /// A clip of a skeleton, one key for each frame and joint; the joints are those of
    /// [`JointNode::from_skeleton`].
    ///
    /// Between keys a viewer interpolates each joint's rotation by slerp, as [`Pose::interpolate`]
    /// does; the motion of the whole skeleton is interpolated as a rotation and a translation
    /// apart, not along its screw, so the clip's frames should be dense where it both turns and
    /// moves.
    ///
    /// # Errors
    ///
    /// [`PoseError`] when the clip is for a skeleton with another number of joints.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::{clip::Clip, gltf::Animation, pose::Pose, skeleton::{Joint, Skeleton}};
    /// use ga_runtime::cga3::{Motor, Rotor};
    ///
    /// let hip = Joint { name: "hip".into(), parent: None, head: [0.0, 1.0, 0.0], tail: [0.0; 3] };
    /// let leg = Skeleton::new(vec![hip])?;
    /// let half = Rotor::from_axis_angle([0.0, 0.0, 2.0], std::f64::consts::PI).ok_or("no axis")?;
    /// let turned = Pose::from_rotors(&leg, Motor::default(), &[half])?;
    /// let clip = Clip::new(0.5, vec![Pose::rest(1), turned])?;
    ///
    /// let animation = Animation::from_clip("turn", &leg, &clip)?;
    /// let [x, y, z, w] = animation.tracks[0].keys[1].rotation;
    /// assert!((z - 1.0).abs() < 1e-15 && x.abs() + y.abs() + w.abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_clip(name: &str, skeleton: &Skeleton, clip: &Clip) -> Result<Self, PoseError> {
        let joints = skeleton.joints();
        for pose in clip.frames() {
            let (expected, found) = (joints.len(), pose.joints.len());
            if expected != found {
                return Err(PoseError { expected, found });
            }
        }
        let translation = |t: [f64; 3]| Motor::from(Translator::from_displacement(t));
        let track = |(index, joint): (usize, &Joint)| {
            let there = translation(joint.head);
            let back = joint
                .parent
                .map(|parent| translation(joints[parent].head.map(|c| -c)));
            let key = |pose: &Pose| {
                let above = back.unwrap_or(pose.root);
                RigidTransform::from(above * pose.joints[index] * there)
            };
            Track {
                joint: index,
                keys: clip.frames().iter().map(key).collect(),
            }
        };
        let frames = 0..clip.frames().len();
        Ok(Self {
            name: name.to_owned(),
            times: frames
                .map(|frame| frame as f64 * clip.frame_time())
                .collect(),
            tracks: joints.iter().enumerate().map(track).collect(),
        })
    }
}
