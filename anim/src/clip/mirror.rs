//! The mirror image of a motion: left and right change places.

use std::ops::Range;

use ga_runtime::cga3::{DualPlane, Point, Translator};

use super::Clip;
use crate::clip::ClipError;
use crate::pose::Pose;
use crate::recording::RecordingError;
pub use crate::retarget::convention::Side;
use crate::retarget::convention::word_ranges;
use crate::skeleton::Skeleton;

ga_runtime::ga! { ga_runtime::cga3;
    /// The motion as it is seen in a plane: π M π⁻¹.
    pub(crate) fn reflected(plane: DualPlane, motor: Motor) -> Motor {
        plane * motor * plane / (plane | plane)
    }
}

/// The mirror image of poses of one skeleton in a plane.
///
/// Each joint moves as its counterpart on the other side does, seen in the mirror: its motor is
/// π M π⁻¹ with the plane π and the motor M of the counterpart, and the same for the root. Where
/// the skeleton at rest is not its own mirror image, the motion is moved to the joint's position.
/// The mirror image of a mirror image is the pose itself.
///
/// ```
/// use ga_anim::clip::Mirror;
/// use ga_anim::pose::Pose;
/// use ga_anim::skeleton::{Joint, Skeleton};
/// use ga_runtime::cga3::{DualPlane, Motor, Rotor};
/// let joint = |name: &str, x: f64| Joint {
///     name: name.into(),
///     parent: None,
///     head: [x, 0.0, 0.0],
///     tail: [2.0 * x, 0.0, 0.0],
/// };
/// let arms = Skeleton::new(vec![joint("LeftArm", 1.0), joint("RightArm", -1.0)])?;
/// let mirror = Mirror::by_names(&arms, DualPlane::new(1.0, 0.0, 0.0, 0.0))?;
/// let raise = Rotor::from_axis_angle([0.0, 0.0, 1.0], 0.5).ok_or("no axis")?;
/// let left = Pose::from_rotors(&arms, Motor::default(), &[raise, Rotor::default()])?;
/// let [_, hand] = mirror.pose(&left)?.bones(&arms)?[1];
/// assert!((hand[0] + 1.0 + 0.5_f64.cos()).abs() < 1e-15);
/// assert!((hand[1] - 0.5_f64.sin()).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Mirror {
    plane: DualPlane<f64>,
    /// For each joint its counterpart, and the displacement from the image of the counterpart's
    /// position to its own.
    counterparts: Vec<(usize, [f64; 3])>,
}

impl Mirror {
    /// The mirror for a skeleton in which the joints of each pair change places and all others stay
    /// in theirs.
    ///
    /// # Errors
    ///
    /// [`RecordingError::MirrorNoJoint`], [`RecordingError::PairedTwice`],
    /// [`RecordingError::PairParents`] and [`RecordingError::MirrorPlane`].
    pub fn by_pairs(
        skeleton: &Skeleton,
        plane: DualPlane<f64>,
        pairs: &[(usize, usize)],
    ) -> Result<Self, RecordingError> {
        let joints = skeleton.joints();
        let mut counterpart: Vec<usize> = (0..joints.len()).collect();
        for &(left, right) in pairs {
            for joint in [left, right] {
                if joint >= joints.len() {
                    return Err(RecordingError::MirrorNoJoint {
                        joint,
                        count: joints.len(),
                    });
                }
                if counterpart[joint] != joint {
                    return Err(RecordingError::PairedTwice {
                        name: joints[joint].name.clone(),
                    });
                }
            }
            (counterpart[left], counterpart[right]) = (right, left);
        }
        for (joint, &other) in counterpart.iter().enumerate() {
            if joints[joint].parent.map(|parent| counterpart[parent]) != joints[other].parent {
                let (name, other) = (joints[joint].name.clone(), joints[other].name.clone());
                return Err(RecordingError::PairParents { name, other });
            }
        }
        let counterparts = counterpart.into_iter().enumerate().map(|(joint, other)| {
            let image = Point::from(joints[other].head).reflect_in(plane)?;
            let apart = image.vector_to(Point::from(joints[joint].head));
            Some((other, apart.into()))
        });
        let counterparts = counterparts
            .collect::<Option<Vec<_>>>()
            .ok_or(RecordingError::MirrorPlane)?;
        Ok(Self {
            plane,
            counterparts,
        })
    }

    /// The mirror for a skeleton whose names tell left from right: one of their words is `left`,
    /// `right`, `l` or `r`, in any case. Words are divided by signs and spaces, by digits, and by
    /// capital letters, as in `thigh_l`, `toe1-1.L`, `LeftUpLeg` and `LHipJoint`. Joints whose
    /// names say neither stay in their places.
    ///
    /// Two kinds of names tell a side only where the counterpart exists: those that begin with
    /// `left` or `right` without a division (`leftarm`, but also `leftover`), and a letter directly
    /// before a number (`L1`, which may be a vertebra).
    ///
    /// # Errors
    ///
    /// [`RecordingError::NoCounterpart`] where only one side is there, and as [`Mirror::by_pairs`].
    pub fn by_names(skeleton: &Skeleton, plane: DualPlane<f64>) -> Result<Self, RecordingError> {
        let mut pairs = Vec::new();
        for (joint, described) in skeleton.joints().iter().enumerate() {
            let Some(counterpart) = other_side(&described.name) else {
                continue;
            };
            let expected = counterpart.name;
            match skeleton.index(&expected) {
                Some(other) if joint < other => pairs.push((joint, other)),
                None if counterpart.is_certain => {
                    let name = described.name.clone();
                    return Err(RecordingError::NoCounterpart { name, expected });
                }
                _ => {}
            }
        }
        Self::by_pairs(skeleton, plane, &pairs)
    }

    /// The index of the counterpart of each joint; its own for a joint in the middle.
    pub fn counterparts(&self) -> impl Iterator<Item = usize> + '_ {
        self.counterparts.iter().map(|&(other, _)| other)
    }

    /// The mirror image of a pose.
    ///
    /// # Errors
    ///
    /// [`ClipError::JointCount`] for a pose of another skeleton.
    pub fn pose(&self, pose: &Pose) -> Result<Pose, ClipError> {
        let (expected, found) = (self.counterparts.len(), pose.joints.len());
        if expected != found {
            return Err(ClipError::JointCount {
                frame: 0,
                expected,
                found,
            });
        }
        let joint = |&(other, apart): &(usize, [f64; 3])| {
            let image = reflected(self.plane, pose.joints[other]);
            if apart == [0.0; 3] {
                return image;
            }
            let there = Translator::from_displacement(apart);
            there * image * there.reverse()
        };
        Ok(Pose {
            root: reflected(self.plane, pose.root),
            joints: self.counterparts.iter().map(joint).collect(),
        })
    }

    /// The mirror image of a clip.
    ///
    /// # Errors
    ///
    /// [`ClipError::JointCount`] for a clip of another skeleton.
    pub fn clip(&self, clip: &Clip) -> Result<Clip, ClipError> {
        let frames = clip.frames.iter().map(|pose| self.pose(pose));
        Clip::new(clip.frame_time, frames.collect::<Result<_, _>>()?)
    }
}

/// The name of the same joint on the other side of the body, where a name tells a side.
///
/// ```
/// use ga_anim::clip::opposite_name;
///
/// assert_eq!(opposite_name("left_wrist").as_deref(), Some("right_wrist"));
/// assert_eq!(opposite_name("RElbow").as_deref(), Some("LElbow"));
/// assert_eq!(opposite_name("nose"), None);
/// ```
#[must_use]
pub fn opposite_name(name: &str) -> Option<String> {
    other_side(name).map(|other| other.name)
}

/// The side of the body that the name of a joint tells, and where in the name the word for it is.
///
/// ```
/// use ga_anim::clip::{Side, side_of_name};
///
/// assert_eq!(side_of_name("mouth_left"), Some((Side::Left, 6..10)));
/// assert_eq!(side_of_name("RElbow"), Some((Side::Right, 0..1)));
/// assert_eq!(side_of_name("nose"), None);
/// ```
#[must_use]
pub fn side_of_name(name: &str) -> Option<(Side, Range<usize>)> {
    let (range, _) = side_word(name)?;
    Some((Side::of_word(&name[range.clone()])?, range))
}

/// The name that the counterpart of a joint would have.
#[derive(Debug, PartialEq)]
pub(crate) struct Counterpart {
    pub(crate) name: String,
    /// Whether the joint is on one side, even if there is no joint of this name.
    pub(crate) is_certain: bool,
}

/// The counterpart of a joint, where its name tells a side.
pub(crate) fn other_side(name: &str) -> Option<Counterpart> {
    let (range, is_certain) = side_word(name)?;
    let other = opposite(&name[range.clone()]);
    Some(Counterpart {
        name: format!("{}{other}{}", &name[..range.start], &name[range.end..]),
        is_certain,
    })
}

/// Where in a name the word for a side is, and whether the joint is on one side for sure.
fn side_word(name: &str) -> Option<(Range<usize>, bool)> {
    let after_colon = name.rfind(':').map_or(0, |colon| colon + 1);
    let ranges = word_ranges(name);
    // What stands before a colon is the name of a scene or a rig, which seldom tells a side.
    let (before, own): (Vec<_>, Vec<_>) = ranges
        .into_iter()
        .partition(|range| range.start < after_colon);
    let words = || own.iter().chain(&before);
    if let Some(range) = words().find(|&range| Side::of_word(&name[range.clone()]).is_some()) {
        let after = name.as_bytes().get(range.end);
        let is_numbered = range.len() == 1 && after.is_some_and(u8::is_ascii_digit);
        return Some((range.clone(), !is_numbered));
    }
    let first = own.first()?;
    let prefix = ["left", "right"].into_iter().find_map(|side| {
        let prefix = name[first.clone()].get(..side.len())?;
        prefix
            .eq_ignore_ascii_case(side)
            .then_some(first.start..first.start + side.len())
    })?;
    Some((prefix, false))
}

/// The word for the other side, in the same case.
fn opposite(word: &str) -> String {
    let other = match (Side::of_word(word), word.len()) {
        (Some(Side::Left), 1) => "r",
        (Some(Side::Left), _) => "right",
        (_, 1) => "l",
        _ => "left",
    };
    let is_capital = |byte: Option<&u8>| byte.is_some_and(u8::is_ascii_uppercase);
    match (word.as_bytes().first(), word.as_bytes().last()) {
        (_, last) if is_capital(last) => other.to_ascii_uppercase(),
        (first, _) if is_capital(first) => {
            format!("{}{}", other[..1].to_ascii_uppercase(), &other[1..])
        }
        _ => other.to_owned(),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::{Side, other_side, side_of_name};

    #[test]
    fn names_of_the_usual_conventions() {
        let pairs = [
            ("LeftUpLeg", "RightUpLeg", true),
            ("mixamorig:LeftHand", "mixamorig:RightHand", true),
            ("upperarm01.L", "upperarm01.R", true),
            ("UpperLeg_L", "UpperLeg_R", true),
            ("thigh_l", "thigh_r", true),
            ("Bip01 L Thigh", "Bip01 R Thigh", true),
            ("L_Foot", "R_Foot", true),
            ("lHand", "rHand", true),
            ("hand.left", "hand.right", true),
            ("toe1-1.L", "toe1-1.R", true),
            ("l", "r", true),
            ("LHipJoint", "RHipJoint", true),
            ("LFingers", "RFingers", true),
            ("LThumb", "RThumb", true),
            ("LEFT_ARM", "RIGHT_ARM", true),
            ("L:Hand", "R:Hand", true),
            ("leftarm", "rightarm", false),
            ("Leftarm", "Rightarm", false),
            ("toe_L1", "toe_R1", false),
        ];
        for (left, right, is_certain) in pairs {
            for (name, expected) in [(left, right), (right, left)] {
                let found = other_side(name).unwrap();
                assert_eq!(
                    (found.name.as_str(), found.is_certain),
                    (expected, is_certain)
                );
            }
            for (name, expected) in [(left, Side::Left), (right, Side::Right)] {
                let (side, word) = side_of_name(name).unwrap();
                assert_eq!(side, expected);
                let words: &[&str] = match side {
                    Side::Left => &["l", "left"],
                    Side::Right => &["r", "right"],
                };
                assert!(
                    words.contains(&name[word].to_lowercase().as_str()),
                    "{name}"
                );
            }
        }
        // A vertebra, and a word that begins like a side.
        for uncertain in ["L5", "leftover"] {
            assert!(!other_side(uncertain).unwrap().is_certain);
        }
        for middle in [
            "Hips",
            "LowerBack",
            "Head",
            "root",
            "spine05",
            "Lung",
            "leg",
            "Reel",
            "LOD",
            "bright",
            "cleft",
            "Bip01",
            "läßt",
            "",
        ] {
            assert_eq!(other_side(middle), None, "{middle}");
        }
    }
}
