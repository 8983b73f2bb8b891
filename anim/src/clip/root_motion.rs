//! The trajectory of a body on the ground, apart from how it moves in place.

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::Clip;
use crate::clip::ClipError;
use crate::frame_position::frame_at;
use crate::skeleton::Skeleton;

/// What of a body's motion is its trajectory on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundMotion {
    /// The joint whose motion is that of the body, often the hips.
    pub joint: usize,
    /// The direction away from the ground, of any length.
    pub up: Vector<f64>,
    /// Whether rotation about the vertical belongs to the trajectory. It is right-handed about
    /// `up`: seen from above, counter-clockwise.
    pub rotation: bool,
}

impl Default for GroundMotion {
    /// The trajectory of joint 0 with its rotation about y.
    fn default() -> Self {
        Self {
            joint: 0,
            up: Vector::new(0.0, 1.0, 0.0),
            rotation: true,
        }
    }
}

/// The trajectory of a body on the ground: a motor for each frame, which moves the body from where
/// it is at rest to where it stands in the frame.
#[derive(Clone, Debug, PartialEq)]
pub struct RootMotion {
    frame_time: f64,
    motions: Vec<Motor<f64>>,
}

impl Clip {
    /// Splits the clip into the trajectory on the ground and the motion in place: in each frame the
    /// root's motor is M = W N, with the trajectory W and the root N of the clip in place.
    ///
    /// W is the displacement of the joint along the ground and the rotation about the vertical
    /// through its position at rest. That rotation is the part of the joint's rotor R about the
    /// direction u: with the bivector U of the plane across u it is ⟨R⟩ + (R · ~U) U, normalised.
    /// Where a body that is upside down has none, it is that of the frame before.
    /// [`Clip::with_root_motion`] puts both together again.
    ///
    /// # Errors
    ///
    /// [`ClipError::SkeletonJointCount`], [`ClipError::NoJoint`] and [`ClipError::Up`].
    pub fn root_motion(
        &self,
        skeleton: &Skeleton,
        ground: GroundMotion,
    ) -> Result<(RootMotion, Self), ClipError> {
        let (expected, found) = (skeleton.len(), self.joint_count());
        if expected != found {
            return Err(ClipError::SkeletonJointCount { expected, found });
        }
        let Some(head) = skeleton
            .joints()
            .get(ground.joint)
            .map(|joint| Vector::from(joint.head))
        else {
            return Err(ClipError::NoJoint {
                joint: ground.joint,
                count: expected,
            });
        };
        let length = ground.up.length();
        if !(length.is_finite() && length > 0.0) {
            return Err(ClipError::Up(ground.up.coordinates()));
        }
        let up = ground.up * length.recip();
        let mut heading = Rotor::default();
        let mut motions = Vec::with_capacity(self.frames.len());
        let mut frames = self.frames.clone();
        for pose in &mut frames {
            let mut body = pose.joints[ground.joint];
            let mut above = skeleton.joints()[ground.joint].parent;
            while let Some(parent) = above {
                body = pose.joints[parent] * body;
                above = skeleton.joints()[parent].parent;
            }
            body = pose.root * body;
            let moved = Vector::from(body.transform(Point::from(head.coordinates()))) - head;
            let along = moved - up * moved.dot(up);
            if ground.rotation {
                heading = about(up, body.rotor()).unwrap_or(heading);
            }
            let way = Translator::from_displacement(along.coordinates())
                * Motor::about(head.into(), heading);
            pose.root = way.reverse() * pose.root;
            motions.push(way);
        }
        let frame_time = self.frame_time;
        Ok((
            RootMotion {
                frame_time,
                motions,
            },
            Self { frame_time, frames },
        ))
    }

    /// The clip with a trajectory applied to each frame: the root's motor N becomes W N.
    ///
    /// # Errors
    ///
    /// [`ClipError::MotionCount`].
    pub fn with_root_motion(&self, motion: &RootMotion) -> Result<Self, ClipError> {
        let (expected, found) = (self.frames.len(), motion.motions.len());
        if expected != found {
            return Err(ClipError::MotionCount { expected, found });
        }
        let mut clip = self.clone();
        for (pose, &way) in clip.frames.iter_mut().zip(&motion.motions) {
            pose.root = way * pose.root;
        }
        Ok(clip)
    }
}

impl RootMotion {
    /// A trajectory of motors, `frame_time` seconds apart.
    ///
    /// # Errors
    ///
    /// [`ClipError::Empty`] and [`ClipError::FrameTime`].
    pub fn new(frame_time: f64, motions: Vec<Motor<f64>>) -> Result<Self, ClipError> {
        if motions.is_empty() {
            return Err(ClipError::Empty);
        }
        if !(frame_time.is_finite() && frame_time > 0.0) {
            return Err(ClipError::FrameTime(frame_time));
        }
        Ok(Self {
            frame_time,
            motions,
        })
    }

    /// The motor of each frame.
    #[must_use]
    pub fn motions(&self) -> &[Motor<f64>] {
        &self.motions
    }

    /// The motor at a time, along the screw between two frames. Before the first frame and after
    /// the last it is that frame's.
    #[must_use]
    pub fn at(&self, time: f64) -> Motor<f64> {
        let (before, part) = frame_at(time / self.frame_time, self.motions.len() - 1);
        match self.motions.get(before + 1) {
            Some(&after) if part > 0.0 => self.motions[before].interpolate(after, part),
            _ => self.motions[before],
        }
    }

    /// The motion from one time to another in the frame of the body, ~W(from) W(to). A character
    /// that stands at G then stands at G D.
    #[must_use]
    pub fn between(&self, from: f64, to: f64) -> Motor<f64> {
        self.at(from).reverse() * self.at(to)
    }

    /// The motion of the whole clip, by which a walk in a loop goes on.
    #[must_use]
    pub fn whole(&self) -> Motor<f64> {
        self.motions[0].reverse() * self.motions[self.motions.len() - 1]
    }
}

/// The part of a rotation about a direction of length 1. `None` where the rest is a half turn.
pub(crate) fn about(direction: Vector<f64>, rotor: Rotor<f64>) -> Option<Rotor<f64>> {
    let [x, y, z] = direction.coordinates();
    // The bivector across the direction is x e23 − y e13 + z e12.
    let along = x * rotor.e23() - y * rotor.e13() + z * rotor.e12();
    let scalar = rotor.scalar();
    let size = scalar.hypot(along);
    if size < 1e-9 {
        return None;
    }
    let (s, b) = (scalar / size, along / size);
    Some(Rotor::new_unchecked(s, b * z, -b * y, b * x))
}
