//! Retargeting: the transfer of a recorded motion to another skeleton.
//!
//! Source (a [`Source`], such as a recording) and target (a [`Skeleton`]) differ in unit, in
//! proportions and in their pose at rest. Joints are matched by name ([`JointMap::by_names`]) or by
//! a map of your own. Let S be the total rotor of the source joint in a frame, including all
//! parents. Then the total rotor of the target joint is
//!
//! ```text
//! R = C S K
//! ```
//!
//! with one rotor K for all frames, and with the shortest rotor C that is left to do: near the
//! identity, but where joints of the source lie between two matched ones and bend. A joint without
//! a match moves with its parent. Bones keep their lengths.
//!
//! # What the rotations of joints mean
//!
//! A rotation of a joint says something only together with the pose in which it is zero, and that
//! need not be a person who stands: in many recordings all bones lie along one axis there. K is
//! therefore found in one of three ways ([`Reference`]), from the root downwards.
//!
//! **By a pose** of the source that is like the target at rest: one that is given, or that in which
//! all rotations are zero where it is a person who stands, whichever axis is up. With the rotor P
//! of the joint in that pose, `K = ~P A`, and A aligns both: a long bone of a limb (thigh, shin,
//! upper arm, forearm), rotated by its parent's A, gets the shortest rotor to the direction of the
//! source's bone, which adds no twist; every other bone gets its parent's A, so that a hand follows
//! its forearm. A difference between the trunks is one of construction and is kept. Where bodies
//! look along different axes, the rotation about the vertical is taken from the hips, in quarters
//! of a full one. Only feet are aligned by the motion, as below, unless both legs stand alike at
//! rest: at rest the soles of many recordings do not lie on the ground.
//!
//! **By the motion.** Let F be a frame of axes (left, up, forward) that the *places* of joints
//! give, and S the joint's rotor. `~S F` would be the same in every frame of an ideal body; its
//! mean over the motion is a rotor C, in the least squares of the axes. With C₀ of the target,
//! likewise from its pose at rest or from a motion of its own, `K = C ~C₀`. So K does not depend
//! on the axes in which the source's rotations are written.
//!
//! - Hips, spine, neck, clavicles: left exactly along the line of the hips, towards the chest more
//!   and more along that of the shoulders; up as near as can be from the hips to the head, in
//!   frames in which the body stands.
//! - Thigh, shin, upper arm, forearm: exactly along the bone; left as near as can be along the axis
//!   about which knee or elbow bends, where it is bent by over 15°.
//! - Foot and toes: up exactly along the vertical, while the foot is on the ground; forward from
//!   the ankle to the toes. Where feet never stand still, the person walks in place, and a low
//!   ankle that does not rise or sink is on the ground.
//! - Head: left exactly along the line of the shoulders; up as near as can be, in frames in which
//!   the body stands, to the top of the head, where an End Site or a joint says where that is,
//!   within 60° of the trunk; otherwise from the lowest joint of the neck to the head, where that
//!   is within 30° of the trunk in both bodies; otherwise along the trunk.
//! - Others: as the joint above, in the mean.
//!
//! Source and target of a recording on a recording are both read by their motions, so that a
//! recording comes back from its own skeleton as it was. What motion leaves open (head, hands,
//! clavicles) is then as at rest, where both stand at rest.
//!
//! In every frame the long bones of limbs are made parallel to the source's by a further shortest
//! rotor, and the joints between hips and head are rotated together until the head lies in the same
//! direction from the hips. With [`Alignment::EveryBone`] the bones of shoulders, hands and feet
//! become parallel too.
//!
//! # The vertical
//!
//! The ground is y = 0 in the target. In the source, the vertical is the axis along which the head
//! is highest above the feet, in the median over all frames, or one that is given
//! ([`Options::up`]).
//!
//! # Limbs that a rig takes apart
//!
//! In rigs for inverse kinematics feet may hang on the root. A foot, hand or toe that is not below
//! the bone before it in its limb is placed at the end of that bone all the same.
//!
//! # Position of the body
//!
//! The scale is the ratio of the lengths of the legs, a leg being the chain of long bones above a
//! joint with a sole (see [`Soles`]). In every frame the middle of the target's hip joints is the
//! scaled middle of the source's, so that the feet move as far as the strides are long and stand
//! still when the source's do. A recording does not contain the height above the ground. One height
//! is used for all frames: it puts the lowest point of the soles below y = 0 in a quarter of the
//! frames. In most recordings the person stands in more frames than that, and the lowest values are
//! noise. With [`Options::keeps_height`] the height is that of the source, scaled.
//!
//! Soles are those of the feet: a root on the ground is nothing to stand on.
//!
//! # Feet
//!
//! Legs of other proportions do not keep a standing foot in its place: see
//! [`Retarget::with_foot_locking`].

mod bodies;
pub(crate) mod body;
mod calibration;
mod calibration_frame;
mod checks;
pub(crate) mod convention;
mod correspondence;
mod fault;
mod feet;
mod foot_locking;
mod head_top;
mod hierarchy;
mod human;
mod joint_map;
mod mapping;
mod posture;
mod reference;
mod soles;
mod source;
mod standing;
mod standing_pose;
pub(crate) mod structure;
mod target;
mod transfer;
mod trunk;
mod up_axis;

use std::ops::RangeInclusive;

use ga_numerics::order_statistics::Sorted;
use ga_runtime::cga3::{Direction, Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;

use crate::clip::Clip;
use crate::pose::Pose;
use crate::recording::RecordingError;
use crate::skeleton::{Skeleton, SkeletonError};
use correspondence::{Correspondence, Request};

pub use calibration_frame::begins_with_calibration;
pub use checks::{Checks, Worst};
pub use correspondence::Alignment;
pub use fault::{Fault, Place};
pub use foot_locking::{Contact, FootLocking, LockedFeet};
pub use joint_map::{JointMap, MapOrigin};
pub use mapping::Mapping;
pub use reference::{FoundReference, Reference};
pub use soles::Soles;
pub use source::Source;
pub use standing::StandingFoot;
pub use structure::BodyProblem;
pub use target::Target;
pub use transfer::{Transfer, TransferOptions};
pub use up_axis::{FoundUpAxis, UpAxis};

/// How a motion is transferred. What is left out is found.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// Which joints belong together; by default [`JointMap::by_names_or_structure`].
    pub map: Option<&'a JointMap>,
    /// What the target stands on; by default [`Soles::of_skeleton`].
    pub soles: Option<&'a Soles>,
    /// Which bones become parallel.
    pub alignment: Alignment,
    /// Which pose of the source is like the target at rest.
    pub reference: Reference<'a>,
    /// A motion of the target's own joints, in the same order, as a target that is read from a
    /// recording has it. It says how the axes of the target's joints are meant.
    pub target_motion: Option<&'a dyn Source>,
    /// The vertical of the source.
    pub up: Option<UpAxis>,
    /// Whether the body is as high above y = 0 as the source, in proportion, in place of standing
    /// on it.
    pub keeps_height: bool,
}
/// A recording prepared to move a skeleton.
#[derive(Clone, Debug)]
pub struct Retarget<'a> {
    source: &'a dyn Source,
    target: &'a Skeleton,
    correspondence: Correspondence,
    /// What is added to the height of the scaled source.
    lift: f64,
    keeps_height: bool,
}

impl<'a> Retarget<'a> {
    /// Prepares a recording to move a skeleton.
    ///
    /// # Errors
    ///
    /// [`RecordingError::NoMatch`], [`RecordingError::NotAPerson`], [`RecordingError::NoLegs`],
    /// [`RecordingError::NoMotion`], [`RecordingError::Overflow`], [`RecordingError::NoReference`],
    /// [`RecordingError::ReferenceJoint`], [`RecordingError::ReferenceFrame`], and
    /// [`RecordingError::Skeleton`] for soles, a map or a motion of another skeleton.
    pub fn new(
        source: &'a dyn Source,
        target: &'a Skeleton,
        options: &Options,
    ) -> Result<Self, RecordingError> {
        let found;
        let map = match options.map {
            Some(map) => map,
            None => {
                found = JointMap::by_names_or_structure(source, target)?;
                &found
            }
        };
        let counts = [
            Some(map.source_of().len()),
            options.soles.map(|soles| soles.joint_count),
            options.target_motion.map(|own| own.names().len()),
        ];
        let expected = target.len();
        for found in counts.into_iter().flatten() {
            if expected != found {
                return Err(SkeletonError::PoseLength { expected, found }.into());
            }
        }
        let correspondence = Correspondence::new(&Request {
            source,
            target,
            map,
            soles: options.soles,
            alignment: options.alignment,
            reference: options.reference,
            target_motion: options.target_motion,
            up: options.up,
        })?;
        let mut retarget = Self {
            source,
            target,
            correspondence,
            lift: 0.0,
            keeps_height: options.keeps_height,
        };
        let mut lowest = Vec::with_capacity(source.frame_count());
        for frame in 0..source.frame_count() {
            let pose = retarget.pose(frame)?;
            let height = retarget.soles().lowest(&pose.motions(target)?);
            if !height.is_finite() {
                return Err(RecordingError::Overflow { frame });
            }
            lowest.push(height);
        }
        let lowest = Sorted::new(&mut lowest).ok_or(RecordingError::NoMotion)?;
        if !options.keeps_height {
            retarget.lift = -lowest.quantile(0.25);
        }
        Ok(retarget)
    }

    /// What the body stands on.
    fn soles(&self) -> &Soles {
        &self.correspondence.soles
    }

    /// The vertical that the source shows; `None` where it is not a human body.
    #[must_use]
    pub fn found_up_axis(&self) -> Option<FoundUpAxis> {
        self.correspondence.up
    }

    /// What the rotations were found from.
    #[must_use]
    pub fn reference(&self) -> FoundReference {
        self.correspondence.reference
    }

    /// How far the source is from standing upright in the frame in which it stands most, 0 for
    /// straight vertical legs and a vertical trunk, and 1 for each trunk that leans by 12°, legs by
    /// 20° or knees bent by 30°, squared. `None` where it is not a human body.
    #[must_use]
    pub fn least_cost_of_standing(&self) -> Option<f64> {
        self.correspondence.least_cost
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
        let source = self.source_frames(frame).ok_or(out_of_range)?;
        let place = |joint: usize| Vector::from(source[joint].transform(Point::default()));
        let Correspondence { hanging, .. } = &self.correspondence;

        let rotors = self.rotors(&source, &place);
        let mut places = vec![Vector::default(); self.target.len()];
        let head = |joint: usize| Vector::from(self.target.joints()[joint].head);
        for &joint in &hanging.order {
            places[joint] = match hanging.parents[joint] {
                None => head(joint),
                Some(parent) => {
                    let bone = Direction::from(head(joint) - head(parent));
                    places[parent] + Vector::from(rotors[parent].transform(bone))
                }
            };
        }
        let legs = &self.correspondence.legs;
        let between_hips = legs
            .iter()
            .map(|leg| place(leg.source_top) * self.correspondence.scale - places[leg.joints[0]]);
        let mean = between_hips.sum::<Vector<f64>>() / legs.len() as f64;
        let displacement = mean + Vector::new(0.0, self.lift, 0.0);
        let root = Motor::from(Translator::from_displacement(displacement.coordinates()));

        let total = |joint: usize| {
            let back = Translator::from_displacement((-head(joint)).coordinates());
            let there = Translator::from_displacement(places[joint].coordinates());
            there * rotors[joint] * back
        };
        let joints = self.target.joints().iter().enumerate();
        let joints = joints.map(|(joint, rest)| {
            let parent = rest.parent;
            match parent == hanging.parents[joint] {
                true => {
                    let above = parent.map_or(Rotor::default(), |parent| rotors[parent]);
                    let own = above.reverse() * rotors[joint];
                    Motor::about(rest.head.into(), own)
                }
                false => {
                    parent.map_or(Motor::default(), |parent| total(parent).reverse()) * total(joint)
                }
            }
        });
        Ok(Pose {
            root,
            joints: joints.collect(),
        })
    }

    /// The frames of the source's joints, with the vertical along y.
    fn source_frames(&self, frame: usize) -> Option<Vec<Motor<f64>>> {
        let mut frames = self.source.frames_of_joints(frame)?;
        let upright = self.correspondence.upright;
        if upright != Rotor::default() {
            frames
                .iter_mut()
                .for_each(|motor| *motor = upright * *motor);
        }
        Some(frames)
    }

    /// The total rotors of the target's joints.
    fn rotors(
        &self,
        source: &[Motor<f64>],
        place: &dyn Fn(usize) -> Vector<f64>,
    ) -> Vec<Rotor<f64>> {
        let Correspondence {
            source_of,
            alignment,
            parallel,
            hanging,
            trunk,
            ..
        } = &self.correspondence;
        let mut rotors = vec![Rotor::default(); self.target.len()];
        let above = |rotors: &[Rotor<f64>], joint: usize| {
            hanging.parents[joint].map_or(Rotor::default(), |parent| rotors[parent])
        };
        for &joint in &hanging.order {
            let Some(there) = source_of[joint] else {
                rotors[joint] = above(&rotors, joint);
                continue;
            };
            let rotor = source[there].rotor() * alignment[joint];
            let left = parallel[joint].and_then(|bone| {
                let [from, to] = bone.ends.map(place);
                let own: Vector<f64> = rotor.transform(Direction::from(bone.target)).into();
                Rotor::between(own.coordinates(), (to - from).coordinates())
            });
            rotors[joint] = left.map_or(rotor, |left| left * rotor);
        }
        let Some(trunk) = trunk.as_ref().filter(|trunk| trunk.chain.len() > 2) else {
            return rotors;
        };
        let [hips, head] = trunk.source.map(place);
        let correction = trunk.correction(self.target, &rotors, head - hips);
        let between = &trunk.chain[1..trunk.chain.len() - 1];
        for &joint in between {
            rotors[joint] = correction * rotors[joint];
        }
        for &joint in &hanging.order {
            if source_of[joint].is_none() && !between.contains(&joint) {
                rotors[joint] = above(&rotors, joint);
            }
        }
        rotors
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
