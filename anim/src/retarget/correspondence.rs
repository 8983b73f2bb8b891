use ga_runtime::cga3::{Direction, Rotor};
use ga_runtime::vga3::Vector;

use super::{JointMap, RetargetError, Soles};
use crate::bvh::Bvh;
use crate::skeleton::Skeleton;

/// As fractions of the body's height: the least length of a long bone, and the least distance of a
/// limb from the middle.
const LONG: f64 = 1.0 / 8.0;
const BESIDE: f64 = 1.0 / 64.0;

/// The joints of the source that move those of the target, and the rotations between their poses at
/// rest.
#[derive(Clone, Debug)]
pub(super) struct Correspondence {
    /// For each joint of the target, the one of the source that moves it.
    pub(super) source_of: Vec<Option<usize>>,
    /// For each joint of the target, the rotor A.
    pub(super) alignment: Vec<Rotor<f64>>,
    pub(super) legs: Vec<Leg>,
    /// One unit of the source in units of the target.
    pub(super) scale: f64,
}

/// The joint at the top of a leg.
#[derive(Clone, Debug)]
pub(super) struct Leg {
    pub(super) target: usize,
    pub(super) source: usize,
}

/// A long bone of a limb: the vector from its joint to the next at rest, in target and source.
struct LongBone {
    target: Vector<f64>,
    source: Vector<f64>,
}

impl Correspondence {
    pub(super) fn new(
        source: &Bvh,
        target: &Skeleton,
        soles: &Soles,
        map: &JointMap,
    ) -> Result<Self, RetargetError> {
        let joints = target.joints();
        let source_of = map.source_of().to_vec();
        if source_of.iter().all(Option::is_none) {
            return Err(RetargetError::NoMatch);
        }
        let long_bones = long_bones(source, target, &source_of);
        let mut alignment: Vec<Rotor<f64>> = Vec::with_capacity(joints.len());
        for (joint, bone) in joints.iter().zip(&long_bones) {
            let above = joint
                .parent
                .map_or(Rotor::default(), |parent| alignment[parent]);
            let correction = bone.as_ref().and_then(|bone| {
                let inherited: Vector<f64> = above.transform(Direction::from(bone.target)).into();
                Rotor::between(inherited.coordinates(), bone.source.coordinates())
            });
            alignment.push(correction.map_or(above, |correction| correction * above));
        }
        let (legs, scale) = legs(target, &source_of, &long_bones, soles)?;
        Ok(Self {
            source_of,
            alignment,
            legs,
            scale,
        })
    }
}

fn long_bones(
    source: &Bvh,
    target: &Skeleton,
    source_of: &[Option<usize>],
) -> Vec<Option<LongBone>> {
    let joints = target.joints();
    let source_rest = source.rest_positions();
    let heights = || {
        joints
            .iter()
            .flat_map(|joint| [joint.head[1], joint.tail[1]])
    };
    let height =
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
    let middle = joints[0].head[0];
    let mut bones: Vec<Option<LongBone>> = Vec::with_capacity(joints.len());
    for (index, joint) in joints.iter().enumerate() {
        let is_beside = (joint.head[0] - middle).abs() >= BESIDE * height;
        let goes_on =
            matched_above(target, source_of, index).is_some_and(|above| bones[above].is_some());
        let head = Vector::from(joint.head);
        let from_tail = |below: usize| Vector::from(joint.tail).distance(joints[below].head.into());
        let below = (index + 1..joints.len())
            .filter(|&below| source_of[below].is_some() && (is_beside || goes_on))
            .filter(|&below| matched_above(target, source_of, below) == Some(index))
            .min_by(|&a, &b| from_tail(a).total_cmp(&from_tail(b)))
            .filter(|&below| head.distance(joints[below].head.into()) >= LONG * height);
        bones.push(below.and_then(|below| {
            Some(LongBone {
                target: Vector::from(joints[below].head) - head,
                source: Vector::from(source_rest[source_of[below]?])
                    - Vector::from(source_rest[source_of[index]?]),
            })
        }));
    }
    bones
}

/// The legs and the ratio of their lengths.
fn legs(
    target: &Skeleton,
    source_of: &[Option<usize>],
    long_bones: &[Option<LongBone>],
    soles: &Soles,
) -> Result<(Vec<Leg>, f64), RetargetError> {
    let mut legs: Vec<Leg> = Vec::new();
    let (mut target_length, mut source_length) = (0.0, 0.0);
    for index in 0..target.len() {
        let mut top = None;
        let up = |joint| matched_above(target, source_of, joint);
        let mut above = up(index).filter(|_| soles.has(index));
        while let Some((joint, bone)) =
            above.and_then(|joint| Some((joint, long_bones[joint].as_ref()?)))
        {
            target_length += bone.target.length();
            source_length += bone.source.length();
            top = Some(joint);
            above = up(joint);
        }
        if let Some((target, source)) = top.and_then(|top| Some((top, source_of[top]?))) {
            legs.push(Leg { target, source });
        }
    }
    let scale = target_length / source_length;
    if legs.is_empty() || !scale.is_finite() {
        Err(RetargetError::NoLegs)
    } else {
        Ok((legs, scale))
    }
}

/// The nearest joint above that is matched: bones in between, such as those that spread a twist,
/// belong to it.
fn matched_above(target: &Skeleton, source_of: &[Option<usize>], joint: usize) -> Option<usize> {
    let parent = |joint: usize| target.joints()[joint].parent;
    let mut above = parent(joint);
    while let Some(joint) = above.filter(|&joint| source_of[joint].is_none()) {
        above = parent(joint);
    }
    above
}
