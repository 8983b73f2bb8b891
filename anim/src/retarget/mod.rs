//! Retargeting: the transfer of a recorded motion to another skeleton.
//!
//! Source (a [`Source`], such as a recording) and target (a [`Skeleton`]) differ in unit, in
//! proportions and in their pose at rest. Joints are matched by name ([`JointMap::by_names`]) or by
//! a map of your own. Let A be the rotor that aligns a target bone at rest with the source's bone
//! at rest, and S the total rotor of the source joint in a frame, including all parents. Then the
//! total rotor of the target joint is
//!
//! ```text
//! R = C S A
//! ```
//!
//! so that its bone is parallel to the source's. C is the shortest rotor that is left to do: the
//! identity, but where joints of the source lie between two matched ones and bend. A joint without
//! a match moves with its parent. Bones keep their lengths.
//!
//! # Alignment of the poses at rest
//!
//! Both skeletons stand upright at rest, y up. Where they look along different axes, the rotation
//! about the vertical is taken from the hips, in quarters of a full one. A difference between their
//! limbs is then a difference of pose, which A removes. A difference between their trunks is
//! one of construction, such as a clavicle that begins lower or a spine that is bent where the
//! other is straight, and is kept. So, from the root downwards,
//!
//! - a long bone of a limb (thigh, shin, upper arm, forearm), rotated by its parent's A, gets in
//!   addition the shortest rotor to the direction of the source's bone, which adds no twist; a bone
//!   is long from 1/8 of the skeleton's height on, and a limb begins at least 1/64 of it to one
//!   side of the root;
//! - every other bone gets its parent's A, so that a hand follows its forearm and a foot its shin,
//!   and a root gets A = 1.
//!
//! This is [`Alignment::Limbs`], which suits skins: a neck that is bent at rest stays bent. With
//! [`Alignment::EveryBone`] the bones of trunk, shoulders, hands and feet become parallel to the
//! source's too, by a further shortest rotor each. Where several matched bones begin at a joint,
//! one of them can be: in the middle of the body it is the one that goes on upwards.
//!
//! # Position of the body
//!
//! The scale is the ratio of the lengths of the legs, a leg being the chain of long bones above a
//! joint with a sole (see [`Soles`]). In every frame the middle of the target's hip joints is the
//! scaled middle of the source's, so that the feet move as far as the strides are long and stand
//! still when the source's do. A recording does not contain the height above the ground. One height
//! is used for all frames: it puts the lowest point of the soles below y = 0 in a quarter of the
//! frames. In most recordings the person stands in more frames than that, and the lowest values are
//! noise.
//!
//! # Feet
//!
//! Legs of other proportions do not keep a standing foot in its place: see
//! [`Retarget::with_foot_locking`].

pub(crate) mod convention;
mod correspondence;
mod foot_locking;
mod joint_map;
mod soles;
mod source;
mod standing;
mod structure;
mod target;
mod transfer;

use std::ops::RangeInclusive;

use ga_numerics::order_statistics::Sorted;
use ga_runtime::cga3::{Direction, Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;

use crate::clip::Clip;
use crate::pose::Pose;
use crate::recording::RecordingError;
use crate::skeleton::{Skeleton, SkeletonError};
use correspondence::Correspondence;

pub use correspondence::Alignment;
pub use foot_locking::{Contact, FootLocking, LockedFeet};
pub use joint_map::{JointMap, MapOrigin};
pub use soles::Soles;
pub use source::Source;
pub use standing::StandingFoot;
pub use target::Target;
pub use transfer::{Options, Transfer};

/// A recording prepared to move a skeleton.
#[derive(Clone, Debug)]
pub struct Retarget<'a> {
    source: &'a dyn Source,
    target: &'a Skeleton,
    soles: Soles,
    correspondence: Correspondence,
    /// What is added to the height of the scaled source.
    lift: f64,
}

impl<'a> Retarget<'a> {
    /// Matches a recording by the names of its joints with a skeleton that stands on `soles` at
    /// rest; see [`JointMap::by_names`].
    ///
    /// # Errors
    ///
    /// [`RecordingError::NoMatch`], [`RecordingError::NoLegs`], [`RecordingError::NoMotion`],
    /// [`RecordingError::Overflow`], and [`RecordingError::Skeleton`] for the soles of another
    /// skeleton.
    pub fn new(
        source: &'a dyn Source,
        target: &'a Skeleton,
        soles: &Soles,
    ) -> Result<Self, RecordingError> {
        Self::with_map(source, target, soles, &JointMap::by_names(source, target))
    }

    /// Matches a recording by a map with a skeleton that stands on `soles` at rest.
    ///
    /// # Errors
    ///
    /// Those of [`Retarget::new`], and [`RecordingError::Skeleton`] for a map for another skeleton.
    pub fn with_map(
        source: &'a dyn Source,
        target: &'a Skeleton,
        soles: &Soles,
        map: &JointMap,
    ) -> Result<Self, RecordingError> {
        Self::with_alignment(source, target, soles, map, Alignment::default())
    }

    /// The same with a choice of the bones that become parallel.
    ///
    /// # Errors
    ///
    /// Those of [`Retarget::with_map`].
    pub fn with_alignment(
        source: &'a dyn Source,
        target: &'a Skeleton,
        soles: &Soles,
        map: &JointMap,
        alignment: Alignment,
    ) -> Result<Self, RecordingError> {
        let (expected, found) = (target.len(), map.source_of().len());
        if expected != found {
            return Err(SkeletonError::PoseLength { expected, found }.into());
        }
        let (expected, found) = (target.len(), soles.joint_count);
        if expected != found {
            return Err(SkeletonError::PoseLength { expected, found }.into());
        }
        let correspondence = Correspondence::new(source, target, soles, map, alignment)?;
        let mut retarget = Self {
            source,
            target,
            soles: soles.clone(),
            correspondence,
            lift: 0.0,
        };
        let mut lowest = Vec::with_capacity(source.frame_count());
        for frame in 0..source.frame_count() {
            let pose = retarget.pose(frame)?;
            let height = soles.lowest(&pose.motions(target)?);
            if !height.is_finite() {
                return Err(RecordingError::Overflow { frame });
            }
            lowest.push(height);
        }
        let lowest = Sorted::new(&mut lowest).ok_or(RecordingError::NoMotion)?;
        retarget.lift = -lowest.quantile(0.25);
        Ok(retarget)
    }

    /// How long one unit of the recording is in the target's unit.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.correspondence.scale
    }

    /// The mean length of the legs of the recording, in its unit, by which the unit can be guessed.
    #[must_use]
    pub fn source_leg_length(&self) -> f64 {
        self.correspondence.source_leg_length
    }

    /// The joints of the skeleton that move with their parents, since no joint of the recording
    /// moves them.
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
    /// [`RecordingError::FrameRange`].
    pub fn pose(&self, frame: usize) -> Result<Pose, RecordingError> {
        let frames = self.source.frame_count();
        let out_of_range = RecordingError::FrameRange {
            from: frame,
            to: frame,
            frames,
        };
        let source = self.source.frames_of_joints(frame).ok_or(out_of_range)?;
        let place = |joint: usize| Vector::from(source[joint].transform(Point::default()));

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
            let left = self.correspondence.parallel[index].and_then(|bone| {
                let [from, to] = bone.ends.map(place);
                let own: Vector<f64> = rotor.transform(Direction::from(bone.target)).into();
                Rotor::between(own.coordinates(), (to - from).coordinates())
            });
            let rotor = left.map_or(rotor, |left| left * rotor);
            own.push(above.reverse() * rotor);
            rotors.push(rotor);
        }
        let mut pose = Pose::from_rotors(self.target, Motor::default(), &own)?;

        let motions = pose.motions(self.target)?;
        let legs = self.correspondence.legs.iter();
        let between_hips = legs.map(|leg| {
            let [top, ..] = leg.joints;
            let head = Point::from(self.target.joints()[top].head);
            let own = Vector::from(motions[top].transform(head));
            place(leg.source_top) * self.correspondence.scale - own
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
    /// [`RecordingError::FrameRange`].
    pub fn clip(&self, frames: RangeInclusive<usize>) -> Result<Clip, RecordingError> {
        self.check_range(&frames)?;
        let poses: Result<Vec<Pose>, _> = frames.map(|frame| self.pose(frame)).collect();
        Ok(Clip::new(self.source.frame_time(), poses?)?)
    }

    fn check_range(&self, frames: &RangeInclusive<usize>) -> Result<(), RecordingError> {
        let (from, to) = (*frames.start(), *frames.end());
        let count = self.source.frame_count();
        if from > to || to >= count {
            return Err(RecordingError::FrameRange {
                from,
                to,
                frames: count,
            });
        }
        Ok(())
    }
}
