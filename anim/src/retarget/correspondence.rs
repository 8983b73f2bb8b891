use ga_runtime::cga3::{Motor, Rotor};

use super::{RetargetError, Soles};
use crate::bvh::Bvh;
use crate::pose::moved;
use crate::skeleton::Skeleton;

/// Of the body's height: how long a long bone is, and how far from the middle a limb begins.
const LONG: f64 = 1.0 / 8.0;
const BESIDE: f64 = 1.0 / 64.0;

/// Which joint of the source moves which of the target, and how their rests differ.
#[derive(Clone, Debug)]
pub(super) struct Correspondence {
    /// For each joint of the target, the one of the source that has its name.
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

/// A long bone of a limb: the way from its joint to the next at rest, in target and source.
struct LongBone {
    target: [f64; 3],
    source: [f64; 3],
}

impl Correspondence {
    pub(super) fn new(
        source: &Bvh,
        target: &Skeleton,
        soles: &Soles,
    ) -> Result<Self, RetargetError> {
        let joints = target.joints();
        let source_of: Vec<Option<usize>> = joints
            .iter()
            .map(|joint| source.index(&joint.name))
            .collect();
        if source_of.iter().all(Option::is_none) {
            return Err(RetargetError::NoMatch);
        }
        let long_bones = long_bones(source, target, &source_of);
        let mut alignment: Vec<Rotor<f64>> = Vec::with_capacity(joints.len());
        for (joint, bone) in joints.iter().zip(&long_bones) {
            let above = joint
                .parent
                .map_or(Rotor::default(), |parent| alignment[parent]);
            let turn = bone.as_ref().and_then(|bone| {
                Rotor::between(moved(Motor::from(above), bone.target), bone.source)
            });
            alignment.push(turn.map_or(above, |turn| turn * above));
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
        let goes_on = joint.parent.is_some_and(|parent| bones[parent].is_some());
        let from_tail = |below: usize| length(joint.tail, joints[below].head);
        let below = target
            .children(index)
            .filter(|&below| source_of[below].is_some() && (is_beside || goes_on))
            .min_by(|&a, &b| from_tail(a).total_cmp(&from_tail(b)))
            .filter(|&below| length(joint.head, joints[below].head) >= LONG * height);
        bones.push(below.and_then(|below| {
            Some(LongBone {
                target: difference(joint.head, joints[below].head),
                source: difference(
                    source_rest[source_of[index]?],
                    source_rest[source_of[below]?],
                ),
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
    const ORIGIN: [f64; 3] = [0.0; 3];
    let mut legs: Vec<Leg> = Vec::new();
    let (mut target_length, mut source_length) = (0.0, 0.0);
    for (index, joint) in target.joints().iter().enumerate() {
        let mut top = None;
        let mut above = joint.parent.filter(|_| soles.has(index));
        while let Some((joint, bone)) =
            above.and_then(|joint| Some((joint, long_bones[joint].as_ref()?)))
        {
            target_length += length(ORIGIN, bone.target);
            source_length += length(ORIGIN, bone.source);
            top = Some(joint);
            above = target.joints()[joint].parent;
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

fn difference(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| to[axis] - from[axis])
}

fn length(from: [f64; 3], to: [f64; 3]) -> f64 {
    let [x, y, z] = difference(from, to);
    x.hypot(y).hypot(z)
}
