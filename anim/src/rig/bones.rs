use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};

use crate::file_error::MotionFileError;
use crate::skeleton::{Joint, Skeleton};

/// The members of a JSON object in their order, including those with the same name, which a map
/// would drop silently.
pub(crate) struct Members<V>(pub(crate) Vec<(String, V)>);

impl<V> Members<V> {
    /// The members by name.
    pub(super) fn by_name(self) -> Result<BTreeMap<String, V>, MotionFileError> {
        let mut map = BTreeMap::new();
        for (bone, value) in self.0 {
            if map.contains_key(&bone) {
                return Err(MotionFileError::DuplicateBone { bone });
            }
            map.insert(bone, value);
        }
        Ok(map)
    }
}

impl<'de, V: Deserialize<'de>> Deserialize<'de> for Members<V> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Collect<V>(PhantomData<V>);

        impl<'de, V: Deserialize<'de>> Visitor<'de> for Collect<V> {
            type Value = Members<V>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object of bones by name")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Members<V>, A::Error> {
                let mut members = Vec::new();
                while let Some(member) = map.next_entry()? {
                    members.push(member);
                }
                Ok(Members(members))
            }
        }

        deserializer.deserialize_map(Collect(PhantomData))
    }
}

#[derive(serde::Deserialize)]
struct Bone {
    head: End,
    tail: End,
    parent: String,
}

#[derive(serde::Deserialize)]
struct End {
    default_position: [f64; 3],
}

impl End {
    /// From Blender's axes and unit to those of the mesh.
    fn in_mesh(&self) -> [f64; 3] {
        let [x, y, z] = self.default_position;
        [10.0 * x, 10.0 * z, -10.0 * y]
    }
}

pub(super) fn parse(bytes: &[u8]) -> Result<Skeleton, MotionFileError> {
    let bones: Members<Bone> =
        serde_json::from_slice(bytes).map_err(|error| MotionFileError::Json(error.to_string()))?;
    let bones = bones.by_name()?;
    let mut roots = Vec::new();
    let mut children: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (name, bone) in &bones {
        let parent = bone.parent.as_str();
        if parent.is_empty() {
            roots.push(name.as_str());
        } else if bones.contains_key(parent) {
            children.entry(parent).or_default().push(name);
        } else {
            return Err(MotionFileError::UnknownParent {
                bone: name.clone(),
                parent: parent.to_owned(),
            });
        }
    }

    let mut joints = Vec::with_capacity(bones.len());
    let mut to_visit: Vec<(&str, Option<usize>)> =
        roots.iter().rev().map(|&root| (root, None)).collect();
    while let Some((name, parent)) = to_visit.pop() {
        let (head, tail) = (bones[name].head.in_mesh(), bones[name].tail.in_mesh());
        let below = children.remove(name).unwrap_or_default();
        to_visit.extend(
            below
                .into_iter()
                .rev()
                .map(|child| (child, Some(joints.len()))),
        );
        joints.push(Joint {
            name: name.to_owned(),
            parent,
            head,
            tail,
        });
    }
    // A bone that was not reached from a root is in a cycle or below one, and going up far enough
    // ends in the cycle.
    if let Some((&above, _)) = children.first_key_value() {
        let bone = (0..bones.len())
            .fold(above, |bone, _| &bones[bone].parent)
            .to_owned();
        return Err(MotionFileError::Cycle { bone });
    }
    Ok(Skeleton::new(joints)?)
}
