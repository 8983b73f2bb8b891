//! The mirror image of a motion: left and right change places.

use ga_runtime::cga3::{DualPlane, Point, Translator};

use super::{Clip, ClipError};
use crate::pose::Pose;
use crate::recording::RecordingError;
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

/// A skeleton that cannot be mirrored as asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MirrorError {
    /// The normal of the plane is zero, or a coefficient is not finite.
    #[error("the plane has no direction")]
    Plane,
    /// A pair names a joint that does not exist.
    #[error("there is no joint {joint} in a skeleton of {count}")]
    NoJoint {
        /// The joint.
        joint: usize,
        /// How many joints there are.
        count: usize,
    },
    /// A joint is in two pairs.
    #[error("joint {name:?} is in more than one pair")]
    Twice {
        /// Its name.
        name: String,
    },
    /// A joint of one side has none on the other.
    #[error("joint {name:?} has no counterpart {expected:?}")]
    NoCounterpart {
        /// Its name.
        name: String,
        /// The name that the counterpart would have.
        expected: String,
    },
    /// A joint is scaled so that its image is not a rotation, a translation and factors along its
    /// axes.
    #[error(
        "joint {name:?} is scaled unevenly or by a negative factor in {}, and has no mirror image",
        frame.map_or("rest".to_owned(), |frame| format!("frame {frame}"))
    )]
    Scaled {
        /// Its name.
        name: String,
        /// The frame, from 0; `None` at rest.
        frame: Option<usize>,
    },
    /// The mirror image overflows.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// The parents of two counterparts are not counterparts.
    #[error("joints {name:?} and {other:?} are a pair, but their parents are not")]
    Parents {
        /// The name of a joint.
        name: String,
        /// The name of its counterpart.
        other: String,
    },
}

impl Mirror {
    /// The mirror for a skeleton in which the joints of each pair change places and all others stay
    /// in theirs.
    ///
    /// # Errors
    ///
    /// [`MirrorError`].
    pub fn by_pairs(
        skeleton: &Skeleton,
        plane: DualPlane<f64>,
        pairs: &[(usize, usize)],
    ) -> Result<Self, MirrorError> {
        let joints = skeleton.joints();
        let mut counterpart: Vec<usize> = (0..joints.len()).collect();
        for &(left, right) in pairs {
            for joint in [left, right] {
                if joint >= joints.len() {
                    return Err(MirrorError::NoJoint {
                        joint,
                        count: joints.len(),
                    });
                }
                if counterpart[joint] != joint {
                    return Err(MirrorError::Twice {
                        name: joints[joint].name.clone(),
                    });
                }
            }
            (counterpart[left], counterpart[right]) = (right, left);
        }
        for (joint, &other) in counterpart.iter().enumerate() {
            if joints[joint].parent.map(|parent| counterpart[parent]) != joints[other].parent {
                let (name, other) = (joints[joint].name.clone(), joints[other].name.clone());
                return Err(MirrorError::Parents { name, other });
            }
        }
        let counterparts = counterpart.into_iter().enumerate().map(|(joint, other)| {
            let image = Point::from(joints[other].head).reflect_in(plane)?;
            let apart = image.vector_to(Point::from(joints[joint].head));
            Some((other, apart.into()))
        });
        let counterparts = counterparts
            .collect::<Option<Vec<_>>>()
            .ok_or(MirrorError::Plane)?;
        Ok(Self {
            plane,
            counterparts,
        })
    }

    /// The mirror for a skeleton whose names tell left from right: `Left` and `Right` in any case
    /// anywhere in the name, or `L` and `R`, in either case, apart from the rest by a point, a
    /// space, a hyphen or an underscore, or in front of a capital letter. Joints whose names say
    /// neither stay in their places.
    ///
    /// # Errors
    ///
    /// [`MirrorError::NoCounterpart`] where only one side is there, and as [`Mirror::by_pairs`].
    pub fn by_names(skeleton: &Skeleton, plane: DualPlane<f64>) -> Result<Self, MirrorError> {
        let mut pairs = Vec::new();
        for (joint, described) in skeleton.joints().iter().enumerate() {
            let Some(expected) = other_side(&described.name) else {
                continue;
            };
            match skeleton.index(&expected) {
                Some(other) if joint < other => pairs.push((joint, other)),
                Some(_) => {}
                None => {
                    let name = described.name.clone();
                    return Err(MirrorError::NoCounterpart { name, expected });
                }
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

/// The name of the counterpart of a joint, where a name tells a side.
pub(crate) fn other_side(name: &str) -> Option<String> {
    const WORDS: [[&str; 2]; 3] = [["Left", "Right"], ["left", "right"], ["LEFT", "RIGHT"]];
    for [left, right] in WORDS {
        for (from, to) in [(left, right), (right, left)] {
            if let Some(place) = name.find(from) {
                return Some(format!(
                    "{}{to}{}",
                    &name[..place],
                    &name[place + from.len()..]
                ));
            }
        }
    }
    let bytes = name.as_bytes();
    let is_apart = |byte: Option<&u8>| byte.is_none_or(|byte| b". -_:".contains(byte));
    bytes.iter().enumerate().find_map(|(place, letter)| {
        let other = match letter {
            b'L' => "R",
            b'R' => "L",
            b'l' => "r",
            b'r' => "l",
            _ => return None,
        };
        let before = place.checked_sub(1).map(|before| &bytes[before]);
        let after = bytes.get(place + 1);
        // As in lHand and LHand.
        let is_prefix = after.is_some_and(u8::is_ascii_uppercase)
            && (letter.is_ascii_lowercase()
                || bytes.get(place + 2).is_some_and(u8::is_ascii_lowercase));
        let is_word = is_apart(before) && (is_apart(after) || is_prefix);
        is_word.then(|| format!("{}{other}{}", &name[..place], &name[place + 1..]))
    })
}

#[cfg(test)]
mod tests {
    use super::other_side;

    #[test]
    fn names_of_the_usual_conventions() {
        let pairs = [
            ("LeftUpLeg", "RightUpLeg"),
            ("mixamorig:LeftHand", "mixamorig:RightHand"),
            ("upperarm01.L", "upperarm01.R"),
            ("UpperLeg_L", "UpperLeg_R"),
            ("thigh_l", "thigh_r"),
            ("Bip01 L Thigh", "Bip01 R Thigh"),
            ("L_Foot", "R_Foot"),
            ("lHand", "rHand"),
            ("LHipJoint", "RHipJoint"),
            ("hand.left", "hand.right"),
            ("toe1-1.L", "toe1-1.R"),
            ("l", "r"),
        ];
        for (left, right) in pairs {
            assert_eq!(other_side(left).as_deref(), Some(right));
            assert_eq!(other_side(right).as_deref(), Some(left));
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
        ] {
            assert_eq!(other_side(middle), None, "{middle}");
        }
    }
}
