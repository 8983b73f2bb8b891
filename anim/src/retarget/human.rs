//! The joints of a human body that a motion is read from.

use super::convention::{Part, Side};
use super::structure::Parts;

/// The sides of a body in the order of arrays.
const SIDES: [Side; 2] = [Side::Left, Side::Right];

/// The joints that say how a body stands and where its limbs point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Human {
    pub(super) hips: usize,
    /// The upper end of the trunk: the head, or what is highest of neck and spine.
    pub(super) head: usize,
    /// Hip, knee and ankle of the left and the right leg.
    pub(super) legs: [[usize; 3]; 2],
    pub(super) toes: [Option<usize>; 2],
    /// Shoulder, elbow and wrist of the left and the right arm, where both are known.
    pub(super) arms: Option<[[usize; 3]; 2]>,
    /// The lowest joint below the head that is known as a neck.
    pub(super) neck: Option<usize>,
}

/// How the rotation of a joint shows in the places of joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Role {
    /// A joint of the trunk, from 0 at the hips to 1 at the shoulders.
    Trunk(f64),
    /// The first or the second long bone of a leg.
    Leg {
        side: usize,
        bone: usize,
    },
    /// The first or the second long bone of an arm.
    Arm {
        side: usize,
        bone: usize,
    },
    Foot {
        side: usize,
    },
    /// A joint between the chest and an arm, which motion alone leaves open.
    Clavicle,
    /// The head, which motion alone leaves open.
    Head,
}

impl Human {
    /// The joints of a body whose parts are known; `None` unless both legs are complete and there
    /// is something above the hips.
    pub(super) fn new(parts: &Parts) -> Option<Self> {
        let first = |part, side| parts.get(&(part, side))?.first().copied();
        let limb = |kinds: [Part; 3], side: Side| {
            let [Some(a), Some(b), Some(c)] = kinds.map(|part| first(part, Some(side))) else {
                return None;
            };
            Some([a, b, c])
        };
        let leg = |side| limb([Part::UpperLeg, Part::LowerLeg, Part::Foot], side);
        let arm = |side| limb([Part::UpperArm, Part::LowerArm, Part::Hand], side);
        let [Some(left), Some(right)] = SIDES.map(leg) else {
            return None;
        };
        let arms = match SIDES.map(arm) {
            [Some(left), Some(right)] => Some([left, right]),
            _ => None,
        };
        Some(Self {
            hips: first(Part::Hips, None)?,
            head: uppermost(parts).next()?,
            legs: [left, right],
            toes: SIDES.map(|side| first(Part::Toes, Some(side))),
            arms,
            neck: first(Part::Neck, None).filter(|_| parts.contains_key(&(Part::Head, None))),
        })
    }

    /// The joints of another body that move these, which have these parts, and these without those
    /// that nothing moves; `None` where legs, hips or all above them are missing. Where nothing
    /// moves the head, the highest joint of neck and spine that is moved takes its place.
    pub(super) fn matched(&self, parts: &Parts, source_of: &[Option<usize>]) -> Option<[Self; 2]> {
        let three = |joints: [usize; 3]| {
            let [Some(a), Some(b), Some(c)] = joints.map(|joint| source_of[joint]) else {
                return None;
            };
            Some([a, b, c])
        };
        let [Some(left), Some(right)] = self.legs.map(three) else {
            return None;
        };
        let toes = self.toes.map(|toes| source_of[toes?]);
        let arms = self.arms.and_then(|arms| match arms.map(three) {
            [Some(left), Some(right)] => Some([left, right]),
            _ => None,
        });
        let head = uppermost(parts).find(|&joint| source_of[joint].is_some())?;
        let neck = self.neck.filter(|_| head == self.head);
        let neck = neck.and_then(|neck| source_of[neck]);
        let there = Self {
            hips: source_of[self.hips]?,
            head: source_of[head]?,
            legs: [left, right],
            // One foot with toes and one without would be judged by two rules.
            toes: if toes.contains(&None) {
                [None; 2]
            } else {
                toes
            },
            arms,
            neck,
        };
        let here = Self {
            head,
            toes: if there.toes[0].is_some() {
                self.toes
            } else {
                [None; 2]
            },
            arms: self.arms.filter(|_| arms.is_some()),
            neck: self.neck.filter(|_| neck.is_some()),
            ..self.clone()
        };
        Some([here, there])
    }

    /// The chains of joints in which each one hangs on the one before.
    pub(super) fn chains(&self) -> impl Iterator<Item = Vec<usize>> + '_ {
        let legs = self.legs.iter().zip(self.toes).map(|(leg, toes)| {
            let mut chain = leg.to_vec();
            chain.extend(toes);
            chain
        });
        legs.chain(self.arms.iter().flatten().map(|arm| arm.to_vec()))
    }

    /// What each joint of a body is, as far as the places of joints tell it.
    pub(super) fn roles(&self, parts: &Parts, count: usize) -> Vec<Option<Role>> {
        let mut roles = vec![None; count];
        roles[self.hips] = Some(Role::Trunk(0.0));
        let joints = |part, side| parts.get(&(part, side)).map_or(&[][..], Vec::as_slice);
        let spine = joints(Part::Spine, None);
        for (number, &joint) in spine.iter().enumerate() {
            roles[joint] = Some(Role::Trunk((number + 1) as f64 / spine.len() as f64));
        }
        for &joint in joints(Part::Neck, None) {
            roles[joint] = Some(Role::Trunk(1.0));
        }
        for side in SIDES {
            for &joint in joints(Part::Shoulder, Some(side)) {
                roles[joint] = Some(Role::Clavicle);
            }
        }
        if let Some(&head) = joints(Part::Head, None).first() {
            roles[head] = Some(Role::Head);
        }
        for side in 0..2 {
            let [thigh, shin, ankle] = self.legs[side];
            roles[thigh] = Some(Role::Leg { side, bone: 0 });
            roles[shin] = Some(Role::Leg { side, bone: 1 });
            roles[ankle] = Some(Role::Foot { side });
            if let Some(toes) = self.toes[side] {
                roles[toes] = Some(Role::Foot { side });
            }
            if let Some(arms) = self.arms {
                roles[arms[side][0]] = Some(Role::Arm { side, bone: 0 });
                roles[arms[side][1]] = Some(Role::Arm { side, bone: 1 });
            }
        }
        roles
    }
}

/// The joints of the head, the neck and the spine, from above.
fn uppermost(parts: &Parts) -> impl Iterator<Item = usize> + '_ {
    let upper = [Part::Head, Part::Neck, Part::Spine];
    let joints = upper
        .into_iter()
        .filter_map(|part| parts.get(&(part, None)));
    joints.flat_map(|joints| joints.iter().rev().copied())
}
