//! Poses: the rotation of every joint of a skeleton, as motors.
//!
//! With a joint at the position h at rest and a rotor R for its rotation, the joint's own motion is
//! the motor
//!
//! ```text
//! L = T(h) R T(−h)
//! ```
//!
//! which leaves h fixed. Its total motion is its own followed by that of its parent, G = G_parent
//! L. A motor takes a point at rest, in the coordinates of mesh and skeleton, to its position in
//! the pose: x' = G x ~G. There are no other frames: no local axes, no bone roll. The root motion
//! comes last and moves the whole skeleton.

use ga_runtime::cga3::{Line, Motor, Point, Rotor};

use crate::kinematics::forward_pose;
use crate::skeleton::{Skeleton, SkeletonError};

/// A pose of a skeleton.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The motion of the whole skeleton.
    pub root: Motor<f64>,
    /// The own motion L of each joint, in the order of [`Skeleton::joints`]. Where it is a rotation
    /// about the joint's position, the joint stays there.
    pub joints: Vec<Motor<f64>>,
}

impl Pose {
    /// The pose at rest of a skeleton with `joint_count` joints.
    #[must_use]
    pub fn rest(joint_count: usize) -> Self {
        Self {
            root: Motor::default(),
            joints: vec![Motor::default(); joint_count],
        }
    }

    /// The pose in which each joint rotates about its own position by a rotor, given in the axes of
    /// the skeleton at rest.
    ///
    /// # Errors
    ///
    /// [`SkeletonError`] when there is not one rotor for each joint.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::pose::Pose;
    /// use ga_anim::skeleton::{Joint, Skeleton};
    /// use ga_runtime::cga3::{Motor, Rotor};
    ///
    /// let hip = Joint {
    ///     name: "hip".into(),
    ///     parent: None,
    ///     head: [0.0, 2.0, 0.0],
    ///     tail: [0.0, 1.0, 0.0],
    /// };
    /// let knee = Joint {
    ///     name: "knee".into(),
    ///     parent: Some(0),
    ///     head: [0.0, 1.0, 0.0],
    ///     tail: [0.0, 0.0, 0.0],
    /// };
    /// let leg = Skeleton::new(vec![hip, knee])?;
    ///
    /// let quarter = Rotor::from_axis_angle([1.0, 0.0, 0.0], std::f64::consts::FRAC_PI_2)
    ///     .ok_or("no axis")?;
    /// let pose = Pose::from_rotors(&leg, Motor::default(), &[Rotor::default(), quarter])?;
    /// let [_, foot] = pose.bones(&leg)?[1];
    /// assert!((foot[1] - 1.0).abs() < 1e-15 && (foot[2] + 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_rotors(
        skeleton: &Skeleton,
        root: Motor<f64>,
        rotors: &[Rotor<f64>],
    ) -> Result<Self, SkeletonError> {
        check(skeleton, rotors.len())?;
        let joints = skeleton.joints().iter().zip(rotors);
        Ok(Self {
            root,
            joints: joints
                .map(|(joint, &rotor)| Motor::about(joint.head.into(), rotor))
                .collect(),
        })
    }

    /// The total motion G of each joint, which takes its bone from rest to the pose.
    ///
    /// # Errors
    ///
    /// [`SkeletonError`] when the pose is for a skeleton with another number of joints.
    pub fn motions(&self, skeleton: &Skeleton) -> Result<Vec<Motor<f64>>, SkeletonError> {
        check(skeleton, self.joints.len())?;
        let mut motions = vec![Motor::default(); self.joints.len()];
        forward_pose(skeleton, self.root, &self.joints, &mut motions);
        Ok(motions)
    }

    /// The head and the tail of each bone in the pose.
    ///
    /// # Errors
    ///
    /// As [`Pose::motions`].
    pub fn bones(&self, skeleton: &Skeleton) -> Result<Vec<[[f64; 3]; 2]>, SkeletonError> {
        let motions = self.motions(skeleton)?;
        let bones = skeleton.joints().iter().zip(motions);
        Ok(bones
            .map(|(joint, motion)| [joint.head, joint.tail].map(|end| moved(motion, end)))
            .collect())
    }

    /// The line along each bone in the pose, from head to tail: p ∧ q ∧ ∞, moved whole by the
    /// joint's motor. A bone without length has none.
    ///
    /// # Errors
    ///
    /// As [`Pose::motions`].
    pub fn bone_lines(&self, skeleton: &Skeleton) -> Result<Vec<Option<Line<f64>>>, SkeletonError> {
        let motions = self.motions(skeleton)?;
        let lines = skeleton
            .joints()
            .iter()
            .zip(motions)
            .map(|(joint, motion)| {
                (joint.head != joint.tail).then(|| {
                    motion.transform(Line::through(
                        Point::from(joint.head),
                        Point::from(joint.tail),
                    ))
                })
            });
        Ok(lines.collect())
    }

    /// The pose a part `t` of the way from this one to `other`: every motor moves along its screw,
    /// the shorter way. Between two rotations of a joint about its own position lies a rotation
    /// about that position (the slerp of their quaternions).
    ///
    /// Only as many joints as both poses have are kept.
    #[must_use]
    pub fn interpolate(&self, other: &Self, t: f64) -> Self {
        let joints = self.joints.iter().zip(&other.joints);
        Self {
            root: self.root.interpolate(other.root, t),
            joints: joints.map(|(&from, &to)| from.interpolate(to, t)).collect(),
        }
    }
}

fn check(skeleton: &Skeleton, found: usize) -> Result<(), SkeletonError> {
    let expected = skeleton.len();
    if expected == found {
        Ok(())
    } else {
        Err(SkeletonError::PoseLength { expected, found })
    }
}

/// A position moved by a motor.
pub(crate) fn moved(motor: Motor<f64>, place: [f64; 3]) -> [f64; 3] {
    motor.transform(Point::from(place)).coordinates()
}
