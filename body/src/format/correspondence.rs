//! Which joint of a skeleton a detector means.
//!
//! Names are understood as those of a recording are when it is retargeted
//! ([`JointMap`]), with these meanings of detectors' own names:
//!
//! | COCO | OpenPose | joint of the skeleton |
//! | --- | --- | --- |
//! | | `MidHip` | hips |
//! | | `Neck` | the first joint of the neck |
//! | `left_shoulder` | `LShoulder` | left upper arm, which begins at the shoulder |
//! | `left_elbow` | `LElbow` | left lower arm |
//! | `left_wrist` | `LWrist` | left hand |
//! | `left_hip` | `LHip` | left upper leg |
//! | `left_knee` | `LKnee` | left lower leg |
//! | `left_ankle` | `LAnkle` | left foot |
//! | `nose`, eyes, ears | `Nose`, eyes, ears, toes, heels | none: they are points of the skin |
//!
//! A skeleton whose names do not mean anything is understood by its structure: two chains to the
//! ground are legs, and so on.

use super::Model;
use super::names::Names;
use crate::{BodyError, landmarks};
use ga_anim::retarget::JointMap;
use ga_anim::skeleton::Skeleton;

/// A pose has a place and an orientation.
const NEEDED: usize = 3;

/// For each name the index of the joint of the skeleton that it means; `None` for points of the
/// skin and joints that this skeleton does not have.
///
/// # Errors
/// [`BodyError`] for a name that is neither that of a joint nor known, and where fewer
/// than three match.
///
/// ```
/// use ga_anim::skeleton::{Joint, Skeleton};
/// use ga_body::format::correspondence::correspondence;
///
/// let joint = |name: &str, parent, x: f64, y: f64| Joint {
///     name: name.into(),
///     parent,
///     head: [x, y, 0.0],
///     tail: [x, y - 0.4, 0.0],
/// };
/// let skeleton = Skeleton::new(vec![
///     joint("Hips", None, 0.0, 1.0),
///     joint("LeftUpLeg", Some(0), 0.1, 0.9),
///     joint("LeftLeg", Some(1), 0.1, 0.5),
///     joint("LeftFoot", Some(2), 0.1, 0.1),
/// ])?;
/// let names = ["nose", "left_hip", "left_knee", "left_ankle"].map(String::from);
/// let found = correspondence(&names, &skeleton)?;
/// assert_eq!(found, [None, Some(1), Some(2), Some(3)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn correspondence(
    names: &[String],
    skeleton: &Skeleton,
) -> Result<Vec<Option<usize>>, BodyError> {
    let understood = Names(names.iter().map(|name| alias(name, skeleton)).collect());
    let map = JointMap::by_names_or_structure(&understood, skeleton)
        .unwrap_or_else(|_| JointMap::by_names(&understood, skeleton));
    let mut joints = vec![None; names.len()];
    // Parents come first: of several joints with one meaning, such as those of a neck, the first.
    for (joint, source) in map.source_of().iter().enumerate().rev() {
        if let Some(source) = *source {
            joints[source] = Some(joint);
        }
    }
    for (index, name) in names.iter().enumerate() {
        if joints[index].is_none() && !is_known(name) {
            return Err(BodyError::UnknownJoint {
                name: name.clone(),
                index,
                joints: skeleton.joints().iter().map(|j| j.name.clone()).collect(),
            });
        }
    }
    let found = joints.iter().flatten().count();
    if found < NEEDED {
        let needed = NEEDED;
        return Err(BodyError::TooFewJoints { found, needed });
    }
    Ok(joints)
}

/// A detector's own name as skeletons have it.
fn alias<'a>(name: &'a str, skeleton: &Skeleton) -> &'a str {
    if name == "MidHip" && skeleton.index(name).is_none() {
        "Hips"
    } else {
        name
    }
}

/// Whether a detector has a point of this name.
fn is_known(name: &str) -> bool {
    landmarks::is_known(name)
        || Model::ALL
            .iter()
            .any(|model| model.joints().iter().any(|known| known == name))
}
