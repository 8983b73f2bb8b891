//! Points of the body that detectors find and skeletons do not have: nose, eyes, ears, mouth, heels
//! and toes, and the middles of shoulders and of hips.
//!
//! Each is fixed to a joint, at a place that follows from the proportions of an adult (C. Gordon et
//! al., "Anthropometric survey of U.S. army personnel", 1989): in the axes of the body at rest, and
//! times the length of the trunk. Where a person has them is estimated with the lengths of bones.

use ga_anim::clip::{Side, side_of_name};
use ga_anim::retarget::JointMap;
use ga_anim::skeleton::Skeleton;
use ga_runtime::vga3::Vector;

use crate::format::names::Names;
use crate::model::BodyPoint;

/// What a landmark is fixed to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Head,
    Foot,
    /// The joint that carries both shoulders, from the middle between them.
    Shoulders,
    /// The joint that carries both legs, from the middle between them.
    Hips,
}

/// A landmark of the left side or of the middle.
#[derive(Clone, Copy, Debug)]
struct Landmark {
    /// The letters and digits of its names, without the side.
    names: &'static [&'static str],
    part: Part,
    /// To the left, upwards and forwards, in lengths of the trunk.
    at: [f64; 3],
    /// How far it is from there, as a standard deviation in the same unit.
    deviation: f64,
}

const fn landmark(
    names: &'static [&'static str],
    part: Part,
    at: [f64; 3],
    deviation: f64,
) -> Landmark {
    Landmark {
        names,
        part,
        at,
        deviation,
    }
}

const LANDMARKS: [Landmark; 12] = [
    landmark(&["nose"], Part::Head, [0.0, 0.13, 0.21], 0.05),
    landmark(&["eye"], Part::Head, [0.065, 0.19, 0.17], 0.05),
    landmark(&["eyeinner"], Part::Head, [0.035, 0.19, 0.18], 0.05),
    landmark(&["eyeouter"], Part::Head, [0.09, 0.19, 0.16], 0.05),
    landmark(&["ear"], Part::Head, [0.15, 0.16, 0.0], 0.05),
    landmark(&["mouth"], Part::Head, [0.05, 0.06, 0.18], 0.05),
    landmark(&["headtop"], Part::Head, [0.0, 0.375, 0.0], 0.06),
    landmark(&["heel"], Part::Foot, [0.0, -0.1, -0.11], 0.04),
    landmark(
        &["bigtoe", "footindex"],
        Part::Foot,
        [-0.03, -0.12, 0.37],
        0.04,
    ),
    landmark(&["smalltoe"], Part::Foot, [0.09, -0.12, 0.28], 0.04),
    landmark(&["neck", "thorax"], Part::Shoulders, [0.0; 3], 0.05),
    landmark(&["midhip", "hip", "pelvis"], Part::Hips, [0.0; 3], 0.05),
];

/// A point that is fixed to a joint beside it, and may be elsewhere.
#[derive(Clone, Debug)]
pub(crate) struct SkinPoint {
    pub(crate) point: BodyPoint,
    /// The standard deviation of each coordinate of its place at rest, in the unit of the skeleton.
    pub(crate) deviation: f64,
}

/// The joints of a skeleton that carry landmarks, and the axes of the body at rest.
#[derive(Clone, Debug)]
pub(crate) struct Anatomy<'a> {
    skeleton: &'a Skeleton,
    head: Option<usize>,
    feet: [Option<usize>; 2],
    arms: [usize; 2],
    legs: [usize; 2],
    /// To the left, upwards and forwards.
    pub(crate) axes: [Vector<f64>; 3],
    trunk: f64,
}

impl<'a> Anatomy<'a> {
    /// `None` for a skeleton without two arms and two legs.
    pub(crate) fn new(skeleton: &'a Skeleton) -> Option<Self> {
        const NAMES: [&str; 7] = [
            "head",
            "left_ankle",
            "right_ankle",
            "left_shoulder",
            "right_shoulder",
            "left_hip",
            "right_hip",
        ];
        let map = JointMap::by_names_or_structure(&Names(NAMES.to_vec()), skeleton).ok()?;
        let found = NAMES.map(|name| {
            let source = NAMES.iter().position(|other| *other == name);
            map.source_of()
                .iter()
                .position(|of| of.is_some() && *of == source)
        });
        let [head, left_foot, right_foot, arms @ .., left_leg, right_leg] = found;
        let [arms, legs] = [[arms[0]?, arms[1]?], [left_leg?, right_leg?]];
        let at = |joint: usize| Vector::from(skeleton.joints()[joint].head);
        let middle = |[a, b]: [usize; 2]| (at(a) + at(b)) * 0.5;
        let spine = middle(arms) - middle(legs);
        let trunk = spine.length();
        let up = spine / trunk;
        let across = at(legs[0]) - at(legs[1]);
        let across = across - up * across.dot(up);
        let left = across / across.length();
        let axes = [left, up, left.cross(up)];
        let is_finite = axes
            .iter()
            .all(|axis| axis.coordinates().iter().all(|x| x.is_finite()));
        is_finite.then_some(Self {
            skeleton,
            head,
            feet: [left_foot, right_foot],
            arms,
            legs,
            axes,
            trunk,
        })
    }

    /// The point of a name that a detector has; `None` for a name that is not known here, and for a
    /// part that the skeleton does not have.
    pub(crate) fn point(&self, name: &str) -> Option<SkinPoint> {
        let side = side(name);
        let own = bare(name);
        let landmark = LANDMARKS
            .iter()
            .find(|known| known.names.contains(&own.as_str()))?;
        let at = |joint: usize| Vector::from(self.skeleton.joints()[joint].head);
        let middle = |[a, b]: [usize; 2]| (at(a) + at(b)) * 0.5;
        let (joint, from) = match landmark.part {
            Part::Head => (self.head?, at(self.head?)),
            Part::Foot => {
                let foot = self.feet[usize::from(side? == Side::Right)]?;
                (foot, at(foot))
            }
            Part::Shoulders => (self.carrier(self.arms)?, middle(self.arms)),
            Part::Hips => (self.carrier(self.legs)?, middle(self.legs)),
        };
        let [left, up, forward] = landmark.at;
        let left = match side {
            Some(Side::Left) => left,
            Some(Side::Right) => -left,
            None => 0.0,
        };
        let [x, y, z] = self.axes;
        let offset = (x * left + y * up + z * forward) * self.trunk;
        Some(SkinPoint {
            point: BodyPoint {
                name: name.to_owned(),
                at_rest: (from + offset).into(),
                joints: vec![(joint, 1.0)],
            },
            deviation: landmark.deviation * self.trunk,
        })
    }

    /// The joints of the ankles.
    pub(crate) fn joints_of_feet(&self) -> Vec<usize> {
        self.feet.iter().copied().flatten().collect()
    }

    /// The points of a body that are at ankles, or fixed to feet.
    pub(crate) fn points_of_feet(&self, points: &[BodyPoint]) -> Vec<usize> {
        let feet = self.joints_of_feet();
        let is_of_foot = |point: &BodyPoint| point.joints.iter().any(|(of, _)| feet.contains(of));
        (0..points.len())
            .filter(|&point| is_of_foot(&points[point]))
            .collect()
    }

    /// The joint that stands where a point of a foot does: the ankle by itself, and the joint of
    /// the toes by their tips. `None` for the other points of feet.
    pub(crate) fn standing_joint(&self, point: &BodyPoint) -> Option<usize> {
        let joints = self.skeleton.joints();
        let of_feet = self.joints_of_feet().into_iter();
        let mut own = of_feet.filter(|foot| point.joints.iter().any(|(of, _)| of == foot));
        let foot = own.next()?;
        if joints[foot].head == point.at_rest {
            return Some(foot);
        }
        let is_toe = ["bigtoe", "footindex"].contains(&bare(&point.name).as_str());
        joints
            .iter()
            .position(|joint| is_toe && joint.parent == Some(foot))
    }

    /// The middle of the ankles and that of the shoulders, where the heads of joints are.
    pub(crate) fn ends(&self, heads: &[Vector<f64>]) -> [Vector<f64>; 2] {
        let middle = |[a, b]: [usize; 2]| (heads[a] + heads[b]) * 0.5;
        let low = match self.feet {
            [Some(left), Some(right)] => middle([left, right]),
            _ => middle(self.legs),
        };
        [low, middle(self.arms)]
    }

    /// How high a place is above the lowest point of the skeleton at rest.
    pub(crate) fn height_at_rest(&self, place: Vector<f64>) -> f64 {
        let [_, up, _] = self.axes;
        let joints = self.skeleton.joints().iter();
        let ends = joints.flat_map(|joint| [joint.head, joint.tail]);
        let lowest = ends
            .map(|end| Vector::from(end).dot(up))
            .fold(f64::INFINITY, f64::min);
        place.dot(up) - lowest
    }

    /// The lowest joint above both.
    fn carrier(&self, [a, b]: [usize; 2]) -> Option<usize> {
        let joints = self.skeleton.joints();
        let above =
            |joint: usize| std::iter::successors(joints[joint].parent, |&j| joints[j].parent);
        above(a).find(|&joint| above(b).any(|other| other == joint))
    }
}

/// Whether a landmark of this name is known.
pub(crate) fn is_known(name: &str) -> bool {
    let own = bare(name);
    LANDMARKS
        .iter()
        .any(|known| known.names.contains(&own.as_str()))
}

/// The side that a name tells.
fn side(name: &str) -> Option<Side> {
    Some(side_of_name(name)?.0)
}

/// The small letters of a name without its side.
fn bare(name: &str) -> String {
    let word = side_of_name(name).map_or(0..0, |(_, word)| word);
    let own = name[..word.start].chars().chain(name[word.end..].chars());
    let letters = own.filter(char::is_ascii_alphanumeric);
    letters.map(|c| c.to_ascii_lowercase()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_all_detectors_are_understood() {
        for (name, expected, on) in [
            ("nose", "nose", None),
            ("LEar", "ear", Some(Side::Left)),
            ("right_eye_inner", "eyeinner", Some(Side::Right)),
            ("mouth_left", "mouth", Some(Side::Left)),
            ("RBigToe", "bigtoe", Some(Side::Right)),
            ("RHeel", "heel", Some(Side::Right)),
            ("LHeel", "heel", Some(Side::Left)),
            ("ear_L", "ear", Some(Side::Left)),
            ("ear_R", "ear", Some(Side::Right)),
            ("left_foot_index", "footindex", Some(Side::Left)),
            ("MidHip", "midhip", None),
        ] {
            assert_eq!((bare(name).as_str(), side(name)), (expected, on), "{name}");
            assert!(is_known(name), "{name}");
        }
        assert!(!is_known("left_wrist"));
    }

    #[test]
    fn landmarks_of_the_two_sides_are_mirrored() {
        let human = ga_mannequin::Human::new();
        let anatomy = Anatomy::new(&human.skeleton).unwrap();
        // The person faces z, with the left side at x.
        for (axis, expected) in anatomy.axes.iter().zip([Vector::X, Vector::Y, Vector::Z]) {
            assert!(axis.distance(expected) < 0.1, "{axis:?}");
        }
        for name in ["eye", "ear", "heel", "big_toe", "small_toe"] {
            let [a, b] = ["left", "right"].map(|side| {
                let found = anatomy.point(&format!("{side}_{name}")).unwrap();
                found.point.at_rest
            });
            let mirrored = [-b[0], b[1], b[2]];
            assert!(
                Vector::from(a).distance(mirrored.into()) < 1e-9,
                "{name}: {a:?} {b:?}"
            );
        }
        // Near to the skin of the figure: its vertices know where the body ends.
        for name in ["nose", "left_ear", "left_heel", "left_big_toe"] {
            let found = anatomy.point(name).unwrap();
            let at = Vector::from(found.point.at_rest);
            let skin = human.mesh.positions().iter().copied();
            let near = skin
                .map(|position| at.distance(Vector::from(position)))
                .fold(1.0, f64::min);
            assert!(near < 0.02, "{name} is {near} m from the skin");
        }
    }
}
