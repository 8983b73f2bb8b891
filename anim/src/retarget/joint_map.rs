//! Which joint of a recording moves which joint of a skeleton.

use std::collections::{HashMap, HashSet};

use serde::de::{Deserialize, Deserializer, Error};
use serde_json::Value;

use super::convention::{Part, Side, meaning};
use crate::bvh::Bvh;
use crate::rig::bones::Members;
use crate::skeleton::Skeleton;

/// For each joint of a skeleton, the joint of a recording that moves it, if any.
///
/// ```
/// use ga_anim::retarget::JointMap;
/// use ga_anim::skeleton::{Joint, Skeleton};
///
/// let recording = ga_anim::bvh::parse(b"HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 0
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
/// let map = JointMap::from_json(br#"{"LeftUpLeg": "Bip01 Tail"}"#, &recording, &skeleton)?;
/// assert_eq!(map.source_of(), [None, None, Some(1)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JointMap {
    source_of: Vec<Option<usize>>,
}

/// A map of joints that does not fit.
#[derive(Debug, thiserror::Error)]
pub enum JointMapError {
    /// The text is not JSON, or not an object of names and lists of names.
    #[error(
        "a map is an object {{\"joint of the motion\": \"joint of the skeleton\"}}, or with a list \
         of joints of the skeleton: {0}"
    )]
    Json(#[from] serde_json::Error),
    /// The recording has no such joint.
    #[error("the motion has no joint {name:?}")]
    Source {
        /// The name.
        name: String,
    },
    /// The skeleton has no such joint.
    #[error("the skeleton has no joint {name:?}")]
    Target {
        /// The name.
        name: String,
    },
    /// Two joints of the recording are to move one joint.
    #[error("joint {name:?} of the skeleton stands twice in the map")]
    Twice {
        /// The joint of the skeleton.
        name: String,
    },
    /// A joint of the recording has two entries.
    #[error("joint {name:?} of the motion stands twice in the map")]
    Repeated {
        /// The joint of the recording.
        name: String,
    },
}

impl JointMap {
    /// A map by names. Equal names belong together; the other joints are matched by what their
    /// names mean in the usual conventions: Mixamo's, MakeHuman's, CMU's, 3ds Max Biped's, and
    /// names such as `UpperLeg_L`. Of several joints of a limb with one meaning, such as the halves
    /// of an upper arm, the first one is matched, and the others move with it. Where spines or
    /// necks differ in their numbers of joints, they are matched evenly from first to last.
    #[must_use]
    pub fn by_names(source: &Bvh, target: &Skeleton) -> Self {
        let joints = target.joints();
        let there = parts(source.joints().iter().map(|joint| joint.name.as_str()));
        let here = parts(joints.iter().map(|joint| joint.name.as_str()));
        // A shoulder may be a clavicle in one and an upper arm in the other.
        let means_the_same = |joint: usize, found: usize| {
            part_of(&here, joint)
                .is_none_or(|part| part_of(&there, found).is_none_or(|other| part == other))
        };
        let by_name = joints.iter().enumerate().map(|(joint, rest)| {
            let found = source.index(&rest.name)?;
            means_the_same(joint, found).then_some(found)
        });
        let mut source_of: Vec<Option<usize>> = by_name.collect();
        for (meaning, targets) in &here {
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
        Self { source_of }
    }

    /// A map given as JSON, `{"joint of the recording": "joint of the skeleton"}`. A joint that
    /// moves several has a list of them, `{"Spine": ["spine01", "spine02"]}`. Joints that are not
    /// in the map are not matched.
    ///
    /// # Errors
    ///
    /// Any [`JointMapError`].
    pub fn from_json(bytes: &[u8], source: &Bvh, target: &Skeleton) -> Result<Self, JointMapError> {
        let Members(entries) = serde_json::from_slice::<Members<Targets>>(bytes)?;
        let mut source_of = vec![None; target.len()];
        let mut seen = HashSet::new();
        for (there, targets) in entries {
            let Some(found) = source.index(&there) else {
                return Err(JointMapError::Source { name: there });
            };
            if !seen.insert(found) {
                return Err(JointMapError::Repeated { name: there });
            }
            for here in targets.names() {
                let Some(joint) = target.index(&here) else {
                    return Err(JointMapError::Target { name: here });
                };
                if source_of[joint].replace(found).is_some() {
                    return Err(JointMapError::Twice { name: here });
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
fn part_of(parts: &HashMap<Meaning, Vec<usize>>, joint: usize) -> Option<Meaning> {
    let mut parts = parts.iter();
    let found = parts.find(|(_, joints)| joints.contains(&joint));
    found.map(|(&meaning, _)| meaning)
}

/// A part of the body and its side.
type Meaning = (Part, Option<Side>);

/// The joints of each part of a body, from the root on.
fn parts<'a>(names: impl Iterator<Item = &'a str>) -> HashMap<(Part, Option<Side>), Vec<usize>> {
    let mut parts: HashMap<_, Vec<usize>> = HashMap::new();
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
        // A joint beside the hips is no part where the thigh has a name of its own.
        parts.remove(&(Part::SideOfHips, side));
    }
    parts
}
