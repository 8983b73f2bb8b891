//! Which joint of a recording moves which joint of a skeleton.

use std::collections::{HashMap, HashSet};

use serde::Serialize;
use serde::de::{Deserialize, Deserializer, Error};
use serde_json::Value;

use super::Source;
use super::convention::{Part, Side, meaning};
use super::structure::{BodyProblem, Meaning, Parts, parts_by_structure, parts_of_person};
use crate::recording::RecordingError;
use crate::rig::bones::Members;
use crate::skeleton::Skeleton;

/// For each joint of a skeleton, the joint of a recording that moves it, if any.
///
/// ```
/// use ga_anim::retarget::JointMap;
/// use ga_anim::skeleton::{Joint, Skeleton};
///
/// let recording = ga_anim::bvh::decode(b"HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 0
///     JOINT LeftUpLeg { OFFSET 1 0 0 CHANNELS 1 Xrotation } }
///     MOTION Frames: 0 Frame Time: 0.01\n")?;
/// let joint = |name: &str, parent| Joint {
///     name: name.into(),
///     parent,
///     head: [0.0; 3],
///     tail: [0.0; 3],
/// };
/// let skeleton = Skeleton::new(vec![
///     joint("Bip01 Pelvis", None),
///     joint("Bip01 L Thigh", Some(0)),
///     joint("Bip01 Tail", Some(0)),
/// ])?;
/// let map = JointMap::by_names(&recording, &skeleton);
/// assert_eq!(map.source_of(), [Some(0), Some(1), None]);
///
/// let map = JointMap::decode(br#"{"LeftUpLeg": "Bip01 Tail"}"#, &recording, &skeleton)?;
/// assert_eq!(map.source_of(), [None, None, Some(1)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JointMap {
    source_of: Vec<Option<usize>>,
}

/// Where a [`JointMap`] comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum MapOrigin {
    /// The names of the joints.
    Names,
    /// The structure of the skeletons.
    Structure,
    /// A file.
    File,
}

impl JointMap {
    /// A map by names. Equal names belong together; the other joints are matched by what their
    /// names mean in the usual conventions: Mixamo's, MakeHuman's, CMU's, 3ds Max Biped's, and
    /// names such as `UpperLeg_L`. Of several joints of a limb with one meaning, such as the halves
    /// of an upper arm, the first one is matched, and the others move with it. Where spines or
    /// necks differ in their numbers of joints, they are matched evenly from first to last.
    #[must_use]
    pub fn by_names(source: &dyn Source, target: &Skeleton) -> Self {
        let there = parts_of_source(source);
        let here = parts_by_names(target);
        Self::of_parts(source, target, &there, &here)
    }

    /// A map by the shapes of both hierarchies at rest: two chains that go down to the ground are
    /// legs, where they meet are the hips, and two chains to the sides above them are arms. In a
    /// limb the two long bones are found by their lengths, so that bones in between do not matter.
    /// Left and right are told by the feet, which point forwards; feet without direction look along
    /// z. Digits are not matched. Names do not count.
    ///
    /// Bodies stand upright, y up. No joint is matched where one of them does not have two legs,
    /// stands on four, or lies.
    ///
    /// ```
    /// use ga_anim::retarget::JointMap;
    ///
    /// let body = |names: [&str; 7]| {
    ///     let [hips, thigh_l, shin_l, foot_l, thigh_r, shin_r, foot_r] = names;
    ///     format!(
    ///         "HIERARCHY ROOT {hips} {{ OFFSET 0 9 0 CHANNELS 1 Xrotation
    ///            JOINT {thigh_l} {{ OFFSET 1 0 0 CHANNELS 1 Xrotation
    ///              JOINT {shin_l} {{ OFFSET 0 -4 0 CHANNELS 1 Xrotation
    ///                JOINT {foot_l} {{ OFFSET 0 -4 0 CHANNELS 1 Xrotation }} }} }}
    ///            JOINT {thigh_r} {{ OFFSET -1 0 0 CHANNELS 1 Xrotation
    ///              JOINT {shin_r} {{ OFFSET 0 -4 0 CHANNELS 1 Xrotation
    ///                JOINT {foot_r} {{ OFFSET 0 -4 0 CHANNELS 1 Xrotation }} }} }} }}
    ///          MOTION Frames: 0 Frame Time: 0.01\n"
    ///     )
    /// };
    /// let a = ga_anim::bvh::decode(body(["a", "b", "c", "d", "e", "f", "g"]).as_bytes())?;
    /// let b = ga_anim::bvh::decode(body(["1", "2", "3", "4", "5", "6", "7"]).as_bytes())?;
    /// let map = JointMap::by_structure(&a, &b.skeleton()?);
    /// assert_eq!(map.source_of(), [0, 1, 2, 3, 4, 5, 6].map(Some));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn by_structure(source: &dyn Source, target: &Skeleton) -> Self {
        let there = parts_of_person(&source.parents(), &source.rest_positions());
        let here = parts_of_skeleton(target);
        let mut map = Self {
            source_of: vec![None; target.len()],
        };
        map.add(&there.unwrap_or_default(), &here.unwrap_or_default());
        map
    }

    /// A map by names where both have names that mean something, and by structure otherwise: a body
    /// whose names do not tell both legs is described by its structure, the other one by its names.
    ///
    /// # Errors
    ///
    /// [`RecordingError::NotAPerson`] where only the structure could tell and does not.
    pub fn by_names_or_structure(
        source: &dyn Source,
        target: &Skeleton,
    ) -> Result<Self, RecordingError> {
        let by_names = Self::by_names(source, target);
        let there = parts_of_source(source);
        let here = parts_by_names(target);
        let matched: HashSet<usize> = by_names.source_of.iter().copied().flatten().collect();
        // Equal names need no meaning.
        let is_known = 2 * matched.len() >= target.len().min(source.names().len());
        if is_known || (has_legs(&there) && has_legs(&here)) {
            return Ok(by_names);
        }
        let there = match has_legs(&there) {
            true => Ok(there),
            false => parts_of_person(&source.parents(), &source.rest_positions())
                .map_err(|problem| ("the recording", problem)),
        };
        let here = match has_legs(&here) {
            true => Ok(here),
            false => parts_of_skeleton(target).map_err(|problem| ("the skeleton", problem)),
        };
        let (there, here) = match (there, here) {
            (Ok(there), Ok(here)) => (there, here),
            _ if !matched.is_empty() => return Ok(by_names),
            (Err((body, problem)), _) | (_, Err((body, problem))) => {
                let body = body.to_owned();
                return Err(RecordingError::NotAPerson { body, problem });
            }
        };
        let mut map = Self {
            source_of: vec![None; target.len()],
        };
        map.add(&there, &here);
        let count = |map: &Self| map.source_of.iter().flatten().count();
        Ok(match count(&map) > count(&by_names) {
            true => map,
            false => by_names,
        })
    }

    fn of_parts(source: &dyn Source, target: &Skeleton, there: &Parts, here: &Parts) -> Self {
        let joints = target.joints();
        // A shoulder may be a clavicle in one and an upper arm in the other.
        let means_the_same = |joint: usize, found: usize| {
            part_of(here, joint)
                .is_none_or(|part| part_of(there, found).is_none_or(|other| part == other))
        };
        let source_names = source.names();
        let by_name = joints.iter().enumerate().map(|(joint, rest)| {
            let found = source_names.iter().position(|name| *name == rest.name)?;
            means_the_same(joint, found).then_some(found)
        });
        let mut map = Self {
            source_of: by_name.collect(),
        };
        map.add(there, here);
        map
    }

    /// Matches the joints of equal parts that are not matched yet.
    fn add(&mut self, there: &Parts, here: &Parts) {
        let source_of = &mut self.source_of;
        for (meaning, targets) in here {
            let Some(sources) = there.get(meaning) else {
                continue;
            };
            if matches!(meaning.0, Part::Spine | Part::Neck) {
                let [last, last_there] = [targets, sources].map(|joints| joints.len() - 1);
                for (place, &joint) in targets.iter().enumerate() {
                    let there = (place * last_there + last / 2) / last.max(1);
                    source_of[joint].get_or_insert(sources[there]);
                }
            } else if targets.iter().all(|&joint| source_of[joint].is_none()) {
                source_of[targets[0]] = Some(sources[0]);
            }
        }
    }

    /// The map of [`by_names_or_structure`](Self::by_names_or_structure), and by which of both it
    /// is.
    ///
    /// # Errors
    ///
    /// Those of [`by_names_or_structure`](Self::by_names_or_structure).
    pub fn found(
        source: &dyn Source,
        target: &Skeleton,
    ) -> Result<(Self, MapOrigin), RecordingError> {
        let map = Self::by_names_or_structure(source, target)?;
        let origin = match map == Self::by_names(source, target) {
            true => MapOrigin::Names,
            false => MapOrigin::Structure,
        };
        Ok((map, origin))
    }

    /// The map as JSON, in the form that [`JointMap::decode`] reads.
    #[must_use]
    pub fn to_json(&self, source: &dyn Source, target: &Skeleton) -> Value {
        let mut entries = serde_json::Map::new();
        let joints = target.joints();
        for (there, name) in source.names().into_iter().enumerate() {
            let moved = self.source_of.iter().zip(joints);
            let moved = moved.filter(|(source, _)| **source == Some(there));
            let mut names: Vec<Value> = moved.map(|(_, joint)| joint.name.clone().into()).collect();
            let value = match names.len() {
                0 => continue,
                1 => names.remove(0),
                _ => Value::Array(names),
            };
            entries.insert(name.to_owned(), value);
        }
        Value::Object(entries)
    }

    /// A map given as JSON, `{"joint of the recording": "joint of the skeleton"}`. A joint that
    /// moves several has a list of them, `{"Spine": ["spine01", "spine02"]}`. Joints that are not
    /// in the map are not matched.
    ///
    /// # Errors
    ///
    /// [`RecordingError::MapJson`], [`RecordingError::MapSource`], [`RecordingError::MapTarget`],
    /// [`RecordingError::MapTwice`] and [`RecordingError::MapRepeated`].
    pub fn decode(
        bytes: &[u8],
        source: &dyn Source,
        target: &Skeleton,
    ) -> Result<Self, RecordingError> {
        let Members(entries) = serde_json::from_slice::<Members<Targets>>(bytes)
            .map_err(|error| RecordingError::MapJson(error.to_string()))?;
        let source_names = source.names();
        let mut source_of = vec![None; target.len()];
        let mut seen = HashSet::new();
        for (there, targets) in entries {
            let Some(found) = source_names.iter().position(|name| *name == there) else {
                return Err(RecordingError::MapSource { name: there });
            };
            if !seen.insert(found) {
                return Err(RecordingError::MapRepeated { name: there });
            }
            for here in targets.names() {
                let Some(joint) = target.index(&here) else {
                    return Err(RecordingError::MapTarget { name: here });
                };
                if source_of[joint].replace(found).is_some() {
                    return Err(RecordingError::MapTwice { name: here });
                }
            }
        }
        Ok(Self { source_of })
    }

    /// For each joint of the skeleton, the index of the joint of the recording that moves it.
    #[must_use]
    pub fn source_of(&self) -> &[Option<usize>] {
        &self.source_of
    }
}

/// What one joint of a recording moves.
enum Targets {
    One(String),
    Several(Vec<String>),
}

impl Targets {
    fn names(self) -> Vec<String> {
        match self {
            Self::One(name) => vec![name],
            Self::Several(names) => names,
        }
    }
}

impl<'de> Deserialize<'de> for Targets {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Value::deserialize(deserializer)? {
            Value::String(name) => Ok(Self::One(name)),
            list @ Value::Array(_) => {
                let names = serde_json::from_value(list).map_err(D::Error::custom)?;
                Ok(Self::Several(names))
            }
            other => Err(D::Error::custom(format!(
                "{other} is neither a name nor a list of names"
            ))),
        }
    }
}

/// The part that a joint belongs to.
fn part_of(parts: &Parts, joint: usize) -> Option<Meaning> {
    let mut parts = parts.iter();
    let found = parts.find(|(_, joints)| joints.contains(&joint));
    found.map(|(&meaning, _)| meaning)
}

/// The joints of each part of a recording by their names.
fn parts_of_source(source: &dyn Source) -> Parts {
    parts(source.names().into_iter(), &source.parents())
}

/// The joints of each part of a skeleton by their names.
fn parts_by_names(skeleton: &Skeleton) -> Parts {
    let joints = skeleton.joints().iter();
    let parents: Vec<Option<usize>> = joints.clone().map(|joint| joint.parent).collect();
    parts(joints.map(|joint| joint.name.as_str()), &parents)
}

/// The joints of each part of a skeleton: by their names, or where those do not tell both legs by
/// its structure, of which a given map may make a person even where it stands on four legs.
pub(super) fn parts_of_target(skeleton: &Skeleton) -> Parts {
    let by_names = parts_by_names(skeleton);
    match has_legs(&by_names) {
        true => by_names,
        false => {
            let (parents, places) = hierarchy(skeleton);
            parts_by_structure(&parents, &places).unwrap_or_default()
        }
    }
}

/// The joints of each part of the body of a motion by their names.
pub(super) fn parts_of_names(source: &dyn Source) -> Parts {
    parts(source.names().into_iter(), &source.parents())
}

/// Whether thighs, shins and feet of both sides are known.
pub(super) fn has_legs(parts: &Parts) -> bool {
    [Part::UpperLeg, Part::LowerLeg, Part::Foot]
        .iter()
        .all(|&part| {
            let sides = [Some(Side::Left), Some(Side::Right)];
            sides.iter().all(|&side| parts.contains_key(&(part, side)))
        })
}

fn parts_of_skeleton(skeleton: &Skeleton) -> Result<Parts, BodyProblem> {
    let (parents, places) = hierarchy(skeleton);
    parts_of_person(&parents, &places)
}

/// The parents and the places of the joints.
fn hierarchy(skeleton: &Skeleton) -> (Vec<Option<usize>>, Vec<[f64; 3]>) {
    let joints = skeleton.joints().iter();
    joints.map(|joint| (joint.parent, joint.head)).unzip()
}

/// The joints of each part by their names and, where hips or head have no usual name, by where
/// legs and arms begin.
fn parts<'a>(names: impl Iterator<Item = &'a str>, parents: &[Option<usize>]) -> Parts {
    let mut parts: Parts = HashMap::new();
    for (index, name) in names.enumerate() {
        if let Some(meaning) = meaning(name) {
            parts.entry(meaning).or_default().push(index);
        }
    }
    let root = parts.remove(&(Part::Root, None));
    if let Some(root) = root {
        parts.entry((Part::Hips, None)).or_insert(root);
    }
    for side in [Some(Side::Left), Some(Side::Right)] {
        for (vague, clear) in [
            (Part::Shoulder, Part::UpperArm),
            (Part::SideOfHips, Part::UpperLeg),
        ] {
            if !parts.contains_key(&(clear, side))
                && let Some(joints) = parts.remove(&(vague, side))
            {
                // The last of several: a collar comes before the shoulder.
                let (last, before) = match joints.split_last() {
                    Some((&last, before)) => (last, before.to_vec()),
                    None => continue,
                };
                parts.insert((clear, side), vec![last]);
                if vague == Part::Shoulder && !before.is_empty() {
                    parts.insert((vague, side), before);
                }
            }
        }
        // A joint beside the hips does not count where the thigh has a name of its own.
        parts.remove(&(Part::SideOfHips, side));
    }
    divide_spine(&mut parts, parents);
    parts
}

/// Makes the joint of the spine from which the legs go the hips, and what is above the arms the
/// neck and the head, where these have no names of their own: some rigs call all of them spine.
fn divide_spine(parts: &mut Parts, parents: &[Option<usize>]) {
    let way_up = |joint: usize| std::iter::successors(Some(joint), move |&joint| parents[joint]);
    let meet = |parts: &Parts, part: Part| {
        let [left, right] = [Side::Left, Side::Right].map(|side| {
            let joints = parts.get(&(part, Some(side)))?;
            joints.first().copied()
        });
        let right: Vec<usize> = way_up(right?).collect();
        way_up(left?).find(|joint| right.contains(joint))
    };
    let [legs, arms] = [Part::UpperLeg, Part::UpperArm].map(|part| meet(parts, part));
    let is_known = |parts: &Parts, part: Part| parts.contains_key(&(part, None));
    let needs_hips = !is_known(parts, Part::Hips);
    let needs_head = needs_hips && !is_known(parts, Part::Head) && !is_known(parts, Part::Neck);
    let Some(spine) = parts.remove(&(Part::Spine, None)) else {
        return;
    };
    let is_above = |joint: usize, arms: usize| joint != arms && way_up(joint).any(|up| up == arms);
    let (mut rest, mut neck) = (Vec::new(), Vec::new());
    for joint in spine {
        if needs_hips && legs == Some(joint) {
            parts.insert((Part::Hips, None), vec![joint]);
        } else if needs_head && arms.is_some_and(|arms| is_above(joint, arms)) {
            neck.push(joint);
        } else {
            rest.push(joint);
        }
    }
    if let Some(head) = neck.pop() {
        parts.insert((Part::Head, None), vec![head]);
    }
    for (part, joints) in [(Part::Neck, neck), (Part::Spine, rest)] {
        if !joints.is_empty() {
            parts.insert((part, None), joints);
        }
    }
}
