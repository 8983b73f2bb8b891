//! Which joint of the source moves which joint of the target, and how their axes belong together.

use ga_runtime::cga3::{Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::bodies::{Bodies, Bone, Leg};
use super::calibration::Calibration;
use super::head_top::{top_joint, top_of_head};
use super::hierarchy::{Hanging, is_below};
use super::human::{Human, Role};
use super::joint_map::parts_of_target;
use super::reference::{self, FoundReference, Motion, Reference};
use super::standing_pose::standing_orientation;
use super::trunk::Trunk;
use super::up_axis::{FoundUpAxis, UpAxis};
use super::{JointMap, Soles, Source};
use crate::recording::RecordingError;
use crate::skeleton::Skeleton;

/// Which bones of the target become parallel to those of the source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Alignment {
    /// The long bones of limbs. The trunk keeps its own form and rotates as the source's does.
    #[default]
    Limbs,
    /// One bone of every matched joint.
    EveryBone,
}

/// The joints of the source that move those of the target, and the rotations between both.
#[derive(Clone, Debug)]
pub(super) struct Correspondence {
    /// For each joint of the target, the one of the source that moves it.
    pub(super) source_of: Vec<Option<usize>>,
    /// For each joint of the target, the rotor K.
    pub(super) alignment: Vec<Rotor<f64>>,
    /// For each joint of the target, the bone that is parallel to the source's in every frame.
    pub(super) parallel: Vec<Option<Bone>>,
    pub(super) legs: Vec<Leg>,
    /// One unit of the source in units of the target.
    pub(super) scale: f64,
    /// The mean of the legs.
    pub(super) source_leg_length: f64,
    /// The vertical that the motion shows, and the rotation that makes the one that is used y.
    pub(super) up: Option<FoundUpAxis>,
    pub(super) upright: Rotor<f64>,
    pub(super) reference: FoundReference,
    /// How far the source is from standing where it stands most.
    pub(super) least_cost: Option<f64>,
    pub(super) soles: Soles,
    pub(super) hanging: Hanging,
    /// The joints of the target, and its trunk, for human bodies.
    pub(super) human: Option<Human>,
    pub(super) trunk: Option<Trunk>,
    /// Whether the target at rest is a body that stands.
    pub(super) stands_at_rest: bool,
}

/// What is to be matched.
pub(super) struct Request<'a> {
    pub(super) source: &'a dyn Source,
    pub(super) target: &'a Skeleton,
    pub(super) map: &'a JointMap,
    pub(super) soles: Option<&'a Soles>,
    pub(super) alignment: Alignment,
    pub(super) reference: Reference<'a>,
    /// A motion of the target's own joints, in the same order.
    pub(super) target_motion: Option<&'a dyn Source>,
    pub(super) up: Option<UpAxis>,
}

impl Correspondence {
    pub(super) fn new(request: &Request) -> Result<Self, RecordingError> {
        let &Request { source, target, .. } = request;
        let source_of = request.map.source_of().to_vec();
        if source_of.iter().all(Option::is_none) {
            return Err(RecordingError::NoMatch);
        }
        let parts = parts_of_target(target);
        let human = Human::new(&parts).and_then(|human| human.matched(&parts, &source_of));
        let (here, there) = (
            human.as_ref().map(|[here, _]| here),
            human.as_ref().map(|[_, there]| there),
        );
        let hanging = Hanging::new(target, here, &source_of);

        let motion = Motion::new(source, there, request.up);
        let pose = reference::pose(source, there, &motion, request.reference)?;
        let target_motion = request
            .target_motion
            .filter(|_| here.is_some())
            .map(|own| Motion::new(own, here, None));
        let rest: Vec<Vector<f64>> = target
            .joints()
            .iter()
            .map(|joint| joint.head.into())
            .collect();
        let at_rest = [reference::at_rest(&rest, Rotor::default())];
        let mut there = there.map(|there| Calibration::new(there, &motion.moments));
        let own = target_motion
            .as_ref()
            .map_or(&at_rest[..], |own| &own.moments);
        let mut own = here.map(|here| Calibration::new(here, own));
        if let (Some(human), Some(there), Some(own)) = (&human, &mut there, &mut own) {
            let [here, source_human] = human;
            let of_source = top_of_head(source, source_human.head);
            let of_target = match request.target_motion {
                Some(own) => top_of_head(own, here.head),
                None => top_joint(target, here.head),
            };
            let is_at_rest = target_motion.is_none();
            Calibration::set_heads(there, own, [of_source, of_target], is_at_rest);
        }
        // A target that has a motion of its own need not stand at rest.
        let stands_at_rest = match (here, &target_motion) {
            (Some(here), Some(_)) => {
                standing_orientation(here, &rest).is_some_and(|rotor| rotor == Rotor::default())
            }
            _ => true,
        };

        let stands = match own
            .as_ref()
            .and_then(Calibration::most_upright)
            .filter(|_| !stands_at_rest)
        {
            Some(moment) => moment.places.clone(),
            None => rest,
        };
        let upright = there.as_ref().and_then(Calibration::most_upright);
        let source_rest = match pose.as_ref().or(upright) {
            Some(moment) => moment.places.clone(),
            None => reference::rest_places(source),
        };
        let standing = own
            .as_ref()
            .and_then(Calibration::most_upright)
            .filter(|_| !stands_at_rest);
        let soles = match (request.soles, standing) {
            (Some(soles), _) => soles.clone(),
            (None, Some(moment)) => {
                let joints = target.joints().iter().zip(&moment.motors);
                let motions = joints.map(|(joint, &motor)| {
                    motor * Translator::from_displacement(joint.head.map(|x| -x))
                });
                Soles::of_pose(target, &motions.collect::<Vec<_>>())
            }
            (None, None) => Soles::of_skeleton(target),
        };
        let soles = match here {
            // A root on the ground or the hem of a dress is nothing to stand on, nor is what hangs
            // on the head of a body whose feet have no mesh.
            Some(here) => {
                let is_foot = |joint| {
                    let mut ankles = here.legs.iter().map(|leg| leg[2]);
                    ankles.any(|ankle| is_below(&hanging.parents, joint, ankle))
                };
                let of_feet = soles.of_joints(is_foot);
                let of_skeleton = || Soles::of_skeleton(target).of_joints(is_foot);
                of_feet.or_else(of_skeleton).unwrap_or(soles)
            }
            None => soles,
        };
        let bodies = Bodies::new(target, &hanging, stands, &source_of, source_rest, &soles);
        let long_bones = bodies.long_bones(here);

        let is_given = !matches!(request.reference, Reference::Found);
        // A pose that is given is also that of a target which stands so in its motion alone.
        let stood = standing.filter(|_| is_given);
        let has_pose = stands_at_rest || stood.is_some();
        let by_pose = pose.as_ref().filter(|_| has_pose).map(|pose| {
            let aligned = bodies.aligned(&long_bones);
            let rotors = aligned.into_iter().zip(&source_of).enumerate();
            let rotors = rotors.map(|(joint, (aligned, source))| {
                let stood = stood.map_or(Rotor::default(), |moment| moment.motors[joint].rotor());
                match source {
                    Some(there) => pose.motors[*there].rotor().reverse() * aligned * stood,
                    None => aligned * stood,
                }
            });
            rotors.collect::<Vec<_>>()
        });
        let by_motion = match (&there, &own, here) {
            (Some(there), Some(own), Some(here)) if !is_given => {
                let mut roles = here.roles(&parts, target.len());
                for joint in ancestors(&hanging.parents, here.hips) {
                    roles[joint] = Some(Role::Trunk(0.0));
                }
                let found = reference::axes(
                    there,
                    &roles,
                    |joint| source_of[joint],
                    &hanging.matched_above,
                    &hanging.order,
                );
                let wanted = reference::axes(
                    own,
                    &roles,
                    |joint| source_of[joint].map(|_| joint),
                    &hanging.matched_above,
                    &hanging.order,
                );
                let rotors = found
                    .into_iter()
                    .zip(wanted)
                    .map(|(found, wanted)| found * wanted.reverse());
                Some((roles, rotors.collect::<Vec<_>>()))
            }
            _ => None,
        };
        let (rotors, reference) = match (by_pose, by_motion) {
            (Some(by_pose), Some((roles, by_motion))) => {
                // Where both have a motion, it says of both what it says of one; what it leaves
                // open is as at rest. Otherwise only how soles lie on the ground is better known
                // from it.
                let both_move = target_motion.is_some();
                let joints = by_pose.into_iter().zip(by_motion).enumerate();
                let rotors = joints.map(|(joint, (by_pose, by_motion))| match roles[joint] {
                    Some(Role::Trunk(_) | Role::Leg { .. } | Role::Arm { .. }) if both_move => {
                        by_motion
                    }
                    Some(Role::Foot { side }) if both_move || !bodies.is_leg_alike(here, side) => {
                        by_motion
                    }
                    _ => by_pose,
                });
                let reference = if both_move {
                    FoundReference::Motion
                } else {
                    FoundReference::Rest
                };
                (rotors.collect::<Vec<_>>(), reference)
            }
            (Some(by_pose), None) => {
                let reference = if is_given {
                    FoundReference::Given
                } else {
                    FoundReference::Rest
                };
                (by_pose, reference)
            }
            (None, Some((_, by_motion))) => (by_motion, FoundReference::Motion),
            (None, None) => return Err(RecordingError::NoReference),
        };

        let (legs, [scale, source_leg_length]) = bodies.legs(&long_bones, &soles, here)?;
        let parallel = match request.alignment {
            Alignment::Limbs => long_bones
                .iter()
                .map(|bone| bone.map(|(bone, _)| bone))
                .collect(),
            Alignment::EveryBone => bodies.all_bones(),
        };
        Ok(Self {
            trunk: here
                .zip(human.as_ref())
                .map(|(here, [_, there])| Trunk::new(here, there, &hanging)),
            human: here.cloned(),
            stands_at_rest,
            source_of,
            alignment: rotors,
            parallel,
            legs,
            scale,
            source_leg_length,
            up: motion.up,
            upright: motion.upright,
            reference,
            least_cost: there.map(|there| there.least_cost),
            soles,
            hanging,
        })
    }
}

/// The joints above one.
fn ancestors(parents: &[Option<usize>], joint: usize) -> impl Iterator<Item = usize> + '_ {
    std::iter::successors(parents[joint], |&joint| parents[joint])
}
