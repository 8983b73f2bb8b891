//! How sure it is which joints belong together.

use ga_runtime::vga3::Vector;
use serde::Serialize;

use super::Source;
use super::convention::{Part, Side};
use super::joint_map::{JointMap, MapOrigin, parts_of_target};
use super::structure::Parts;
use crate::skeleton::Skeleton;

/// How sure a map of joints is, and which parts of a person it lacks.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mapping {
    /// 1 for a map that is given. Otherwise the part that is matched of hips, head, and two of
    /// thigh, shin, foot, upper arm, forearm and hand, times the cosine of the angle between the
    /// vertical and the way from the hips to the head of a target at rest, and by structure times
    /// the likeness of left and right: the mean ratio of the shorter to the longer of two bones.
    /// Where at least half of all joints have the names of those that move them, it is not less
    /// than their part.
    pub confidence: f64,
    /// The parts that are not matched, such as `"left hand"`.
    pub parts_missing: Vec<String>,
}

/// The parts of a person that have sides, by their names.
const LIMBS: [(Part, &str); 6] = [
    (Part::UpperLeg, "thigh"),
    (Part::LowerLeg, "shin"),
    (Part::Foot, "foot"),
    (Part::UpperArm, "upper arm"),
    (Part::LowerArm, "forearm"),
    (Part::Hand, "hand"),
];
const SIDES: [(Side, &str); 2] = [(Side::Left, "left"), (Side::Right, "right")];

impl Mapping {
    /// What is to be said of a map to a skeleton, which stands as a person at rest or need not.
    pub(super) fn new(
        source: &dyn Source,
        (map, map_by): (&JointMap, MapOrigin),
        skeleton: &Skeleton,
        stands_at_rest: bool,
    ) -> Self {
        let parts = parts_of_target(skeleton);
        let is_matched = |part, side| {
            let joints = parts.get(&(part, side)).map_or(&[][..], Vec::as_slice);
            joints.iter().any(|&joint| map.source_of()[joint].is_some())
        };
        let middle = [(Part::Hips, "hips"), (Part::Head, "head")];
        let middle = middle.map(|(part, name)| (is_matched(part, None), name.to_owned()));
        let limbs = SIDES.iter().flat_map(|&(side, of_side)| {
            LIMBS.map(|(part, name)| {
                let is_there = is_matched(part, Some(side));
                (is_there, format!("{of_side} {name}"))
            })
        });
        let all: Vec<(bool, String)> = middle.into_iter().chain(limbs).collect();
        let count = all.len() as f64;
        let missing = all.into_iter().filter(|(is_there, _)| !is_there);
        let mut parts_missing: Vec<String> = missing.map(|(_, name)| name).collect();
        let mut confidence = 1.0 - parts_missing.len() as f64 / count;
        if stands_at_rest {
            confidence *= upright(&parts, skeleton);
        }
        if map_by == MapOrigin::Structure {
            confidence *= likeness(&parts, skeleton);
        }
        let same = same_names(source, map, skeleton);
        if same >= 0.5 && same > confidence {
            confidence = same;
            parts_missing.clear();
        }
        if map_by == MapOrigin::File {
            confidence = 1.0;
        }
        Self {
            confidence,
            parts_missing,
        }
    }
}

/// The part of the joints that have the names of those that move them.
fn same_names(source: &dyn Source, map: &JointMap, skeleton: &Skeleton) -> f64 {
    let names = source.names();
    let pairs = skeleton.joints().iter().zip(map.source_of());
    let same = pairs.filter(|(joint, there)| there.is_some_and(|there| names[there] == joint.name));
    same.count() as f64 / skeleton.len() as f64
}

fn place(
    parts: &Parts,
    skeleton: &Skeleton,
    part: Part,
    side: Option<Side>,
) -> Option<Vector<f64>> {
    let joint = parts.get(&(part, side))?.first()?;
    Some(skeleton.joints()[*joint].head.into())
}

/// The cosine of the angle between the trunk and the vertical, at least 0; 1 without a trunk.
fn upright(parts: &Parts, skeleton: &Skeleton) -> f64 {
    let [hips, head] = [Part::Hips, Part::Head].map(|part| place(parts, skeleton, part, None));
    let trunk = hips
        .zip(head)
        .and_then(|(hips, head)| (head - hips).normalized());
    trunk.map_or(1.0, |trunk| trunk.e2.max(0.0))
}

/// The mean ratio of the shorter to the longer of the bones of both sides.
fn likeness(parts: &Parts, skeleton: &Skeleton) -> f64 {
    let length = |side, [from, to]: [Part; 2]| {
        let [from, to] = [from, to].map(|part| place(parts, skeleton, part, Some(side)));
        Some(from?.distance(to?))
    };
    let pairs = [LIMBS[0].0, LIMBS[1].0, LIMBS[2].0]
        .windows(2)
        .chain([LIMBS[3].0, LIMBS[4].0, LIMBS[5].0].windows(2))
        .filter_map(|pair| {
            let [left, right] = SIDES.map(|(side, _)| length(side, [pair[0], pair[1]]));
            let (left, right) = left.zip(right)?;
            let longer = left.max(right);
            (longer > 0.0).then(|| left.min(right) / longer)
        })
        .collect::<Vec<f64>>();
    match pairs.len() {
        0 => 1.0,
        count => pairs.iter().sum::<f64>() / count as f64,
    }
}
