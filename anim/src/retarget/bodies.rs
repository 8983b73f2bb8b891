//! What is known of source and target where both stand: their bones, and which way they look.

use std::f64::consts::FRAC_PI_2;

use ga_runtime::cga3::{Direction, Rotor};
use ga_runtime::vga3::Vector;

use super::Soles;
use super::hierarchy::Hanging;
use super::human::Human;
use crate::recording::RecordingError;
use crate::skeleton::Skeleton;

/// As fractions of the body's height: the least length of a long bone, the least distance of a limb
/// from the middle, and the least length of a bone that has a direction.
const LONG: f64 = 1.0 / 8.0;
const BESIDE: f64 = 1.0 / 64.0;
const TINY: f64 = 1e-6;
/// A bone lies rather than stands where it rises by less than this part of its length.
const LYING: f64 = 0.5;

/// A bone from one matched joint to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bone {
    /// The vector from the joint to the next one at rest, in the target.
    pub(super) target: Vector<f64>,
    /// The same in the source.
    source: Vector<f64>,
    /// The joints of the source at both ends.
    pub(super) ends: [usize; 2],
}

/// A chain of long bones down to an ankle.
#[derive(Clone, Debug)]
pub(super) struct Leg {
    /// The joint at the top, the one above the ankle, and the ankle.
    pub(super) joints: [usize; 3],
    /// The joints of the source that move the joint at the top and the ankle.
    pub(super) source_top: usize,
    pub(super) source_ankle: usize,
}

/// What is known of both bodies at rest.
pub(super) struct Bodies<'a> {
    target: &'a Skeleton,
    source_of: &'a [Option<usize>],
    source_rest: Vec<Vector<f64>>,
    /// Where the joints of the target are when it stands.
    stands: Vec<Vector<f64>>,
    /// Bones between a matched joint and the nearest one above that is matched, such as those that
    /// spread a twist, belong to the latter.
    hanging: &'a Hanging,
    height: f64,
    /// The horizontal axis from one side of the target to the other.
    lateral: Vector<f64>,
    /// The rotation about the vertical by which the source looks in another direction.
    facing: Rotor<f64>,
}

impl<'a> Bodies<'a> {
    pub(super) fn new(
        target: &'a Skeleton,
        hanging: &'a Hanging,
        stands: Vec<Vector<f64>>,
        source_of: &'a [Option<usize>],
        source_rest: Vec<Vector<f64>>,
        soles: &Soles,
    ) -> Self {
        let heights = || {
            stands
                .iter()
                .map(|place| place.e2)
                .chain(target.joints().iter().map(|joint| joint.tail[1]))
        };
        let height =
            heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
        let mut bodies = Self {
            target,
            source_of,
            source_rest,
            stands,
            hanging,
            height,
            lateral: Vector::new(1.0, 0.0, 0.0),
            facing: Rotor::default(),
        };
        if let Some([ours, there]) = bodies.across(soles) {
            let quarter = |v: Vector<f64>| (-v.e3).atan2(v.e1) / FRAC_PI_2;
            let (sin, cos) = (quarter(ours).round() * FRAC_PI_2).sin_cos();
            bodies.lateral = Vector::new(cos, 0.0, -sin);
            // Bodies look along an axis. What remains is a difference of pose.
            let quarters = (quarter(there) - quarter(ours)).round();
            let rotor = Rotor::from_axis_angle([0.0, 1.0, 0.0], quarters * FRAC_PI_2);
            if quarters.rem_euclid(4.0) != 0.0 {
                bodies.facing = rotor.unwrap_or_default();
            }
        }
        bodies
    }

    fn head(&self, joint: usize) -> Vector<f64> {
        self.target.joints()[joint].head.into()
    }

    /// How far a joint is to one side of the root.
    fn offset(&self, joint: usize) -> f64 {
        (self.stands[joint] - self.stands[0])
            .dot(self.lateral)
            .abs()
    }

    /// The horizontal vectors from one hip to the other at rest, in the target and in the source:
    /// where the ways from the root to two soles part.
    fn across(&self, soles: &Soles) -> Option<[Vector<f64>; 2]> {
        let horizontal = |v: Vector<f64>| Vector::new(v.e1, 0.0, v.e3);
        let ways: Vec<Vec<usize>> = soles.joints().map(|joint| self.way_to(joint)).collect();
        let mut found: Option<(usize, [Vector<f64>; 2])> = None;
        for (number, one) in ways.iter().enumerate() {
            for other in &ways[number + 1..] {
                let common = one.iter().zip(other).take_while(|(a, b)| a == b).count();
                if common == 0 || found.as_ref().is_some_and(|&(least, _)| least <= common) {
                    continue;
                }
                let pairs = one[common..].iter().zip(&other[common..]);
                let apart = pairs.clone().find_map(|(&a, &b)| {
                    let apart = horizontal(self.stands[a] - self.stands[b]);
                    (apart.length() > TINY * self.height).then_some(apart)
                });
                let there = pairs.filter_map(|(&a, &b)| {
                    let [a, b] = [self.source_of[a]?, self.source_of[b]?];
                    let [a, b] = [a, b].map(|joint| self.source_rest[joint]);
                    Some(horizontal(a - b)).filter(|apart| apart.length() > 0.0)
                });
                if let Some(pair) = apart.zip(there.into_iter().next()) {
                    found = Some((common, pair.into()));
                }
            }
        }
        found.map(|(_, pair)| pair)
    }

    /// The joints from a root to a joint.
    fn way_to(&self, joint: usize) -> Vec<usize> {
        let parent = |&joint: &usize| self.hanging.parents[joint];
        let mut way: Vec<usize> = std::iter::successors(Some(joint), parent).collect();
        way.reverse();
        way
    }

    /// The matched joints right below a matched joint.
    fn below(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        let below = 0..self.target.len();
        below.filter(move |&below| {
            self.source_of[below].is_some() && self.hanging.matched_above[below] == Some(joint)
        })
    }

    fn distance_from_tail(&self, joint: usize, below: usize) -> f64 {
        Vector::from(self.target.joints()[joint].tail).distance(self.head(below))
    }

    fn bone(&self, joint: usize, below: usize, ends: [usize; 2]) -> Bone {
        let [from, to] = ends.map(|joint| self.source_rest[joint]);
        Bone {
            target: self.head(below) - self.head(joint),
            source: to - from,
            ends,
        }
    }

    /// The long bones of limbs, each with the joint at its end: those of a human body, and of
    /// others those that are long.
    pub(super) fn long_bones(&self, human: Option<&Human>) -> Vec<Option<(Bone, usize)>> {
        let mut bones: Vec<Option<(Bone, usize)>> = vec![None; self.target.len()];
        let mut is_known = vec![false; self.target.len()];
        if let Some(human) = human {
            let limbs = human.legs.iter().chain(human.arms.iter().flatten());
            for pair in limbs.flat_map(|limb| limb.windows(2)) {
                let ends = [pair[0], pair[1]].map(|joint| self.source_of[joint]);
                if let [Some(from), Some(to)] = ends {
                    bones[pair[0]] = Some((self.bone(pair[0], pair[1], [from, to]), pair[1]));
                }
            }
            // A foot lies as its sole does.
            let feet = human.legs.iter().map(|leg| leg[2]);
            let known = (0..bones.len())
                .filter(|&joint| bones[joint].is_some())
                .chain(feet);
            known
                .collect::<Vec<_>>()
                .into_iter()
                .for_each(|joint| is_known[joint] = true);
        }
        for &joint in &self.hanging.order {
            if is_known[joint] {
                continue;
            }
            let is_beside = self.offset(joint) >= BESIDE * self.height;
            let goes_on =
                self.hanging.matched_above[joint].is_some_and(|above| bones[above].is_some());
            bones[joint] = self.source_of[joint].and_then(|from| {
                let below = self
                    .below(joint)
                    .filter(|_| is_beside || goes_on)
                    .min_by(|&a, &b| {
                        let [a, b] = [a, b].map(|below| self.distance_from_tail(joint, below));
                        a.total_cmp(&b)
                    })
                    .filter(|&below| {
                        self.head(joint).distance(self.head(below)) >= LONG * self.height
                    })?;
                let ends = [from, self.source_of[below]?];
                Some((self.bone(joint, below, ends), below))
            });
        }
        bones
    }

    /// For each joint of the target the rotor A from the pose in which it stands to that of the
    /// source.
    pub(super) fn aligned(&self, long_bones: &[Option<(Bone, usize)>]) -> Vec<Rotor<f64>> {
        let mut rotors: Vec<Rotor<f64>> = vec![Rotor::default(); self.target.len()];
        for &joint in &self.hanging.order {
            let above = self.hanging.parents[joint].map_or(self.facing, |parent| rotors[parent]);
            let correction = long_bones[joint].as_ref().and_then(|(bone, below)| {
                let stands = self.stands[*below] - self.stands[joint];
                let inherited: Vector<f64> = above.transform(Direction::from(stands)).into();
                Rotor::between(inherited.coordinates(), bone.source.coordinates())
            });
            rotors[joint] = correction.map_or(above, |correction| correction * above);
        }
        rotors
    }

    /// Whether a leg stands at rest as the source's does, so that its foot lies as the source's.
    pub(super) fn is_leg_alike(&self, human: Option<&Human>, side: usize) -> bool {
        const ALIKE: f64 = 1e-3;
        let Some(human) = human else { return true };
        let mut chain = human.legs[side].to_vec();
        chain.extend(human.toes[side]);
        chain.windows(2).all(|pair| {
            let ends = [pair[0], pair[1]].map(|joint| self.source_of[joint]);
            let [Some(from), Some(to)] = ends else {
                return true;
            };
            let bone = self.bone(pair[0], pair[1], [from, to]);
            let rotated: Vector<f64> = self.facing.transform(Direction::from(bone.target)).into();
            let angle = rotated.angle(bone.source);
            angle.is_some_and(|angle| angle < ALIKE)
        })
    }

    /// One bone of every matched joint that has one: where several begin, that of the trunk, and
    /// beside the trunk the one that the joint's own bone points to.
    pub(super) fn all_bones(&self) -> Vec<Option<Bone>> {
        let mut bones: Vec<Option<Bone>> = vec![None; self.target.len()];
        for &joint in self.hanging.order.iter().rev() {
            let Some(from) = self.source_of[joint] else {
                continue;
            };
            let mut candidates: Vec<(usize, Bone)> = self
                .below(joint)
                .filter_map(|below| {
                    let to = self.source_of[below]?;
                    // Joints that one joint of the source moves form a straight line.
                    let ends = match from == to {
                        true => bones[below]?.ends,
                        false => [from, to],
                    };
                    let bone = self.bone(joint, below, ends);
                    let has_length = bone.target.length() > TINY * self.height
                        && bone.source.length() > TINY * self.source_height();
                    has_length.then_some((below, bone))
                })
                .collect();
            if candidates.len() > 1 {
                let in_the_middle = |joint: usize| self.offset(joint) < BESIDE * self.height;
                if in_the_middle(joint) {
                    candidates.retain(|&(below, _)| in_the_middle(below));
                    candidates.sort_by(|a, b| self.stands[b.0].e2.total_cmp(&self.stands[a.0].e2));
                } else {
                    let from_tail =
                        |&(below, _): &(usize, Bone)| self.distance_from_tail(joint, below);
                    candidates.sort_by(|a, b| from_tail(a).total_cmp(&from_tail(b)));
                }
            }
            bones[joint] = candidates.first().map(|&(_, bone)| bone);
        }
        bones
    }

    fn source_height(&self) -> f64 {
        let heights = || self.source_rest.iter().map(|place| place.e2);
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
    }

    /// The legs, the ratio of their lengths, and their mean length in the source.
    pub(super) fn legs(
        &self,
        long_bones: &[Option<(Bone, usize)>],
        soles: &Soles,
        human: Option<&Human>,
    ) -> Result<(Vec<Leg>, [f64; 2]), RecordingError> {
        let mut legs: Vec<Leg> = Vec::new();
        let (mut target_length, mut source_length) = (0.0, 0.0);
        for joints in human.iter().flat_map(|human| human.legs) {
            let [Some(source_top), _, Some(source_ankle)] =
                joints.map(|joint| self.source_of[joint])
            else {
                continue;
            };
            for (bone, _) in joints[..2]
                .iter()
                .filter_map(|&joint| long_bones[joint].as_ref())
            {
                target_length += bone.target.length();
                source_length += bone.source.length();
            }
            legs.push(Leg {
                joints,
                source_top,
                source_ankle,
            });
        }
        let others = soles.joints().filter(|_| human.is_none());
        for sole in others {
            let is_matched = self.source_of[sole].is_some();
            let lowest = if is_matched {
                Some(sole)
            } else {
                self.hanging.matched_above[sole]
            };
            let up = std::iter::successors(lowest, |&joint| self.hanging.matched_above[joint]);
            let long = up.filter_map(|joint| Some((joint, long_bones[joint]?)));
            let mut chain: Vec<(usize, (Bone, usize))> = Vec::new();
            for (joint, bone) in long {
                if chain.last().is_some_and(|&(below, _)| bone.1 != below) {
                    break;
                }
                chain.push((joint, bone));
            }
            // The ankle is the end of the lowest long bone above the sole, but for a long foot.
            let lies = |bone: &Bone| bone.target.e2.abs() < LYING * bone.target.length();
            if chain.len() > 2 && chain.first().is_some_and(|(_, (foot, _))| lies(foot)) {
                chain.remove(0);
            }
            let (Some(&(lower, (_, ankle))), Some(&(top, _))) = (chain.first(), chain.last())
            else {
                continue;
            };
            if legs.iter().any(|leg| leg.joints[2] == ankle) {
                continue;
            }
            for (_, (bone, _)) in &chain {
                target_length += bone.target.length();
                source_length += bone.source.length();
            }
            if let (Some(source_top), Some(source_ankle)) =
                (self.source_of[top], self.source_of[ankle])
            {
                legs.push(Leg {
                    joints: [top, lower, ankle],
                    source_top,
                    source_ankle,
                });
            }
        }
        let scale = target_length / source_length;
        if legs.is_empty() || !scale.is_finite() {
            Err(RecordingError::NoLegs)
        } else {
            let mean = source_length / legs.len() as f64;
            Ok((legs, [scale, mean]))
        }
    }
}
