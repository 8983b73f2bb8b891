//! Retargeting: a recorded motion carried over to another skeleton.
//!
//! Source (a [`Bvh`]) and target (a [`Skeleton`]) differ in unit, in proportions and in how they
//! stand at rest. Joints are matched by name. With A the rotor that makes a target bone at rest
//! point as the source's does at rest, and S the rotor of the source joint in a frame, all parents
//! included, the target joint turns, all parents included, by
//!
//! ```text
//! R = S A
//! ```
//!
//! so that its bone points as the source's does. A joint without a match moves with its parent.
//! Bones keep their lengths.
//!
//! # How the rests are brought together
//!
//! Both skeletons stand upright at rest, y up, looking the same way. What differs in the limbs is
//! then the pose, and what differs in the trunk is how the two were built: a clavicle that begins
//! lower, a spine that is bent where the other is straight. The first is to be undone, the second
//! to be left alone, so going down from the root
//!
//! - a long bone of a limb (thigh, shin, upper arm, forearm) gets the shortest rotor from where its
//!   parent's A leaves it to the direction of the source's bone, which adds no twist; long is at
//!   least 1/8 of the skeleton's height from joint to joint, and a limb begins at least 1/64 of it
//!   to one side of the root;
//! - every other bone gets its parent's A, so that a hand goes with its forearm and a foot with its
//!   shin, and a root A = 1.
//!
//! # Where the body goes
//!
//! The scale is the ratio of the lengths of the legs, a leg being the chain of long bones above a
//! joint with a sole (see [`Soles`]). In every frame the middle of the target's hip joints is the
//! scaled middle of the source's, so that feet move as far as strides are long and stand still when
//! the source's do. The height above the ground, which a recording does not tell, is one number for
//! the whole of it: the soles' lowest points of all frames are ordered, and a quarter of them lies
//! below y = 0. Most recordings spend more than that standing, and the few lower ones are their
//! noise.

mod correspondence;
mod soles;

use std::ops::RangeInclusive;

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;

use crate::bvh::Bvh;
use crate::clip::{Clip, ClipError};
use crate::pose::{Pose, PoseError};
use crate::skeleton::Skeleton;
use correspondence::Correspondence;

pub use soles::Soles;

/// A recording made ready to move a skeleton.
#[derive(Clone, Debug)]
pub struct Retarget<'a> {
    source: &'a Bvh,
    target: &'a Skeleton,
    correspondence: Correspondence,
    /// What is added to the height of the scaled source.
    lift: f64,
}

/// A recording that cannot move a skeleton.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RetargetError {
    /// No joint of the recording has the name of one of the skeleton.
    #[error("no joint of the motion has the name of a bone of the rig")]
    NoMatch,
    /// No leg was found: matched long bones above a foot on the ground.
    #[error(
        "the rig has no leg that the motion has too: a chain of long bones above one that lies on the ground"
    )]
    NoLegs,
    /// The recording has no frame.
    #[error("the motion has no frames")]
    NoFrames,
    /// A range of frames is empty or goes beyond the recording.
    #[error("frames {from} to {to} are no part of a motion of {frames} frames, counted from 0")]
    FrameRange {
        /// The first frame.
        from: usize,
        /// The last frame.
        to: usize,
        /// How many frames the recording has.
        frames: usize,
    },
    /// The recording's numbers are too large to be worked with.
    #[error("frame {frame} of the motion overflows")]
    Overflow {
        /// The frame, from 0.
        frame: usize,
    },
    /// The poses make no clip.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// A pose does not fit the skeleton.
    #[error(transparent)]
    Pose(#[from] PoseError),
}

impl<'a> Retarget<'a> {
    /// Matches a recording with a skeleton that stands on `soles` at rest.
    ///
    /// # Errors
    ///
    /// [`RetargetError::NoMatch`], [`RetargetError::NoLegs`], [`RetargetError::NoFrames`],
    /// [`RetargetError::Overflow`], and [`RetargetError::Pose`] for the soles of another skeleton.
    pub fn new(
        source: &'a Bvh,
        target: &'a Skeleton,
        soles: &Soles,
    ) -> Result<Self, RetargetError> {
        let (expected, found) = (target.len(), soles.joint_count);
        if expected != found {
            return Err(PoseError { expected, found }.into());
        }
        let correspondence = Correspondence::new(source, target, soles)?;
        let mut retarget = Self {
            source,
            target,
            correspondence,
            lift: 0.0,
        };
        let mut lowest = Vec::with_capacity(source.frame_count());
        for frame in 0..source.frame_count() {
            let pose = retarget.pose(frame)?;
            let height = soles.lowest(&pose.motions(target)?);
            if !height.is_finite() {
                return Err(RetargetError::Overflow { frame });
            }
            lowest.push(height);
        }
        lowest.sort_by(f64::total_cmp);
        let standing = *lowest
            .get(lowest.len() / 4)
            .ok_or(RetargetError::NoFrames)?;
        retarget.lift = -standing;
        Ok(retarget)
    }

    /// How long one unit of the recording is in the target's unit.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.correspondence.scale
    }

    /// The joints of the skeleton that move with their parents, since the recording has none of
    /// their names.
    pub fn unmatched(&self) -> impl Iterator<Item = &'a str> + '_ {
        let joints = self
            .target
            .joints()
            .iter()
            .zip(&self.correspondence.source_of);
        joints
            .filter(|(_, source)| source.is_none())
            .map(|(joint, _)| joint.name.as_str())
    }

    /// The pose of the skeleton in a frame of the recording, on the ground at y = 0.
    ///
    /// # Errors
    ///
    /// [`RetargetError::FrameRange`].
    pub fn pose(&self, frame: usize) -> Result<Pose, RetargetError> {
        let frames = self.source.frame_count();
        let out_of_range = RetargetError::FrameRange {
            from: frame,
            to: frame,
            frames,
        };
        let source = self.source.frames_of_joints(frame).ok_or(out_of_range)?;

        let mut rotors: Vec<Rotor<f64>> = Vec::with_capacity(self.target.len());
        let mut own = Vec::with_capacity(self.target.len());
        for (index, joint) in self.target.joints().iter().enumerate() {
            let above = joint
                .parent
                .map_or(Rotor::default(), |parent| rotors[parent]);
            let rotor = match self.correspondence.source_of[index] {
                Some(there) => source[there].rotor() * self.correspondence.alignment[index],
                None => above,
            };
            own.push(above.reverse() * rotor);
            rotors.push(rotor);
        }
        let mut pose = Pose::from_rotors(self.target, Motor::default(), &own)?;

        let motions = pose.motions(self.target)?;
        let legs = self.correspondence.legs.iter();
        let between_hips = legs.map(|leg| {
            let joint = &self.target.joints()[leg.target];
            let recorded = Vector::from(source[leg.source].transform(Point::default()));
            let head = Point::from(joint.head);
            let own = Vector::from(motions[leg.target].transform(head));
            recorded * self.correspondence.scale - own
        });
        let mean = between_hips.sum::<Vector<f64>>() / self.correspondence.legs.len() as f64;
        let displacement = mean + Vector::new(0.0, self.lift, 0.0);
        pose.root = Motor::from(Translator::from_displacement(displacement.coordinates()));
        Ok(pose)
    }

    /// The clip of these frames of the recording, both ends included, at the recording's rate.
    ///
    /// # Errors
    ///
    /// [`RetargetError::FrameRange`].
    pub fn clip(&self, frames: RangeInclusive<usize>) -> Result<Clip, RetargetError> {
        let (from, to) = (*frames.start(), *frames.end());
        let count = self.source.frame_count();
        if from > to || to >= count {
            return Err(RetargetError::FrameRange {
                from,
                to,
                frames: count,
            });
        }
        let poses: Result<Vec<Pose>, _> = frames.map(|frame| self.pose(frame)).collect();
        Ok(Clip::new(self.source.frame_time(), poses?)?)
    }
}
