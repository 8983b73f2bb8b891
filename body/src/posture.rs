//! The posture about which the rotations of a person's joints are spread.
//!
//! Many skeletons rest with arms stretched to the sides and straight legs, which people rarely do.
//! Thighs and upper arms mostly hang, a little to the front, and knees and elbows bend one way
//! only: a knee by 0° to 140° backwards, an elbow by 0° to 145° forwards (American Academy of
//! Orthopaedic Surgeons, "Joint motion: method of measuring and recording", 1965). The means and
//! deviations here put these ranges within about two standard deviations. Nothing is fitted to
//! recorded motions.

use ga_anim::retarget::JointMap;
use ga_anim::skeleton::Skeleton;
use ga_runtime::cga3::{Direction, Rotor};
use ga_runtime::vga3::Vector;

use crate::format::names::Names;

/// How the rotation of a joint from rest is spread.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spread {
    pub(crate) joint: usize,
    /// The mean, in the axes of rest.
    pub(crate) mean: Rotor<f64>,
    /// The standard deviation about each axis in radians.
    pub(crate) deviation: f64,
}

/// A limb of two long bones as people mostly hold it.
struct Limb {
    /// The names of its three joints, without the side.
    names: [&'static str; 3],
    /// Whether it bends towards the front or, as −1, towards the back.
    bends: f64,
    /// Where the upper bone points: outwards and forwards, where it points down by 1.
    upper: [f64; 2],
    /// The angle by which the limb is bent, in radians.
    bent: f64,
    /// The standard deviations of the rotations of both bones in radians.
    deviations: [f64; 2],
}

const LEG: Limb = Limb {
    names: ["hip", "knee", "ankle"],
    bends: -1.0,
    upper: [0.0, 0.4],
    bent: 0.7,
    deviations: [0.5, 0.5],
};
const ARM: Limb = Limb {
    names: ["shoulder", "elbow", "wrist"],
    bends: 1.0,
    upper: [0.3, 0.3],
    bent: 0.9,
    deviations: [0.8, 0.6],
};

/// Of a body at rest that stands, legs are no farther from the vertical than by this cosine.
const STANDS: f64 = 0.7;

/// The spreads of the joints of a person's limbs; none for a skeleton that is not one of a person,
/// or does not stand at rest.
pub(crate) fn spreads(skeleton: &Skeleton) -> Vec<Spread> {
    of_person(skeleton).unwrap_or_default()
}

fn of_person(skeleton: &Skeleton) -> Option<Vec<Spread>> {
    let sides = ["left", "right"];
    let names =
        [&LEG, &ARM].map(|limb| sides.map(|side| limb.names.map(|n| format!("{side}_{n}"))));
    let names: Vec<&str> = names
        .iter()
        .flatten()
        .flatten()
        .map(String::as_str)
        .collect();
    let map = JointMap::by_names_or_structure(&Names(names), skeleton).ok()?;
    let joint = |source: usize| map.source_of().iter().position(|of| *of == Some(source));
    let limb = |first: usize| {
        let [upper, lower, end] = [0, 1, 2].map(|k| joint(first + k));
        Some([upper?, lower?, end?])
    };
    let legs = [limb(0)?, limb(3)?];
    let at = |joint: usize| Vector::from(skeleton.joints()[joint].head);
    let down = legs.iter().fold(Vector::ZERO, |sum, [hip, _, ankle]| {
        sum + at(*ankle) - at(*hip)
    });
    let down = down.normalized()?;
    let across = at(legs[0][0]) - at(legs[1][0]);
    let left = (across - down * across.dot(down)).normalized()?;
    let forward = down.cross(left);
    let direction = |from: usize, to: usize| (at(to) - at(from)).normalized();
    for [hip, knee, ankle] in legs {
        let bones = [direction(hip, knee)?, direction(knee, ankle)?];
        if bones.iter().any(|bone| bone.dot(down) < STANDS) {
            return None;
        }
    }
    // Names that exchange the sides turn the front to the back.
    let feet = legs.iter().flat_map(|&[.., ankle]| {
        let toes = skeleton.children(ankle);
        toes.map(move |toes| (at(toes) - at(ankle)).dot(forward))
    });
    if feet.sum::<f64>() < 0.0 {
        return None;
    }
    let mut all = Vec::new();
    let arms = [limb(6), limb(9)];
    let limbs = legs.map(|leg| (&LEG, Some(leg))).into_iter();
    let limbs = limbs.chain(arms.map(|arm| (&ARM, arm)));
    for ((limb, joints), outward) in limbs.zip([left, -left, left, -left]) {
        let Some([upper, lower, end]) = joints else {
            continue;
        };
        let between = |from: Vector<f64>, to: Vector<f64>| Rotor::between(from.into(), to.into());
        let hanging_to_rest = between(down, direction(upper, lower)?)?;
        let goal = down + outward * limb.upper[0] + forward * limb.upper[1];
        let bent = down * limb.bent.cos() + forward * (limb.bends * limb.bent.sin());
        let bent_at_rest = hanging_to_rest.transform(Direction::from_vector(bent.into()));
        let means = [
            between(down, goal)? * hanging_to_rest.reverse(),
            between(direction(lower, end)?, bent_at_rest.vector().into())?,
        ];
        for ((joint, mean), deviation) in [upper, lower].into_iter().zip(means).zip(limb.deviations)
        {
            all.push(Spread {
                joint,
                mean,
                deviation,
            });
        }
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use ga_anim::pose::Pose;
    use ga_anim::skeleton::Joint;
    use ga_runtime::cga3::{Motor, Point};

    use super::*;

    /// A person at rest with arms that point to the side and down, turned about the vertical.
    fn person([side, down]: [f64; 2], facing: f64) -> Skeleton {
        let turned = Rotor::from_axis_angle([0.0, 1.0, 0.0], facing).unwrap();
        let mut joints = Vec::new();
        let mut add = |name: String, parent, place: [f64; 3]| {
            let head = turned.transform(Point::from(place)).coordinates();
            joints.push(Joint {
                name,
                parent,
                head,
                tail: head,
            });
            joints.len() - 1
        };
        let hips = add("Hips".into(), None, [0.0, 1.0, 0.0]);
        let chest = add("Spine".into(), Some(hips), [0.0, 1.3, 0.0]);
        add("Head".into(), Some(chest), [0.0, 1.7, 0.0]);
        for (name, x) in [("Left", 1.0), ("Right", -1.0)] {
            let leg = [
                [0.1, 0.95, 0.0],
                [0.1, 0.5, 0.0],
                [0.1, 0.1, 0.0],
                [0.1, 0.0, 0.1],
            ];
            let arm = [0.0, 0.3, 0.55].map(|t| [0.2 + t * side, 1.5 - t * down, 0.0]);
            let leg = ["UpLeg", "Leg", "Foot", "ToeBase"].into_iter().zip(leg);
            let arm = ["Arm", "ForeArm", "Hand"].into_iter().zip(arm);
            let mut above = hips;
            for (part, [along, y, z]) in leg {
                above = add(format!("{name}{part}"), Some(above), [x * along, y, z]);
            }
            above = chest;
            for (part, [along, y, z]) in arm {
                above = add(format!("{name}{part}"), Some(above), [x * along, y, z]);
            }
        }
        Skeleton::new(joints).unwrap()
    }

    /// From the first of two joints to the second in the usual posture, in the axes of the body: to
    /// the left, upwards, forwards.
    fn way(skeleton: &Skeleton, facing: f64, [from, to]: [&str; 2]) -> [f64; 3] {
        let mut rotors = vec![Rotor::default(); skeleton.len()];
        for Spread { joint, mean, .. } in spreads(skeleton) {
            rotors[joint] = mean;
        }
        let pose = Pose::from_rotors(skeleton, Motor::default(), &rotors).unwrap();
        let bones = pose.bones(skeleton).unwrap();
        let at = |name: &str| Vector::from(bones[skeleton.index(name).unwrap()][0]);
        let back = Rotor::from_axis_angle([0.0, 1.0, 0.0], -facing).unwrap();
        let way = Direction::from_vector((at(to) - at(from)).into());
        back.transform(way).vector()
    }

    #[test]
    fn limbs_bend_one_way_however_the_arms_rest() {
        for arms in [[1.0, 0.0], [0.0, 1.0], [0.6, 0.8]] {
            for facing in [0.0, 0.8, FRAC_PI_2, 3.0] {
                let skeleton = person(arms, facing);
                assert_eq!(spreads(&skeleton).len(), 8);
                for (side, out) in [("Left", 1.0), ("Right", -1.0)] {
                    let way = |from: &str, to: &str| {
                        way(
                            &skeleton,
                            facing,
                            [from, to]
                                .map(|n| format!("{side}{n}"))
                                .each_ref()
                                .map(String::as_str),
                        )
                    };
                    let thigh = way("UpLeg", "Leg");
                    assert!(thigh[0].abs() < 1e-12 && thigh[1] < 0.0 && thigh[2] > 0.1);
                    // The knee is before the line from the hip to the ankle.
                    let shin = way("Leg", "Foot");
                    assert!(shin[2] < -0.1 && shin[1] < 0.0, "{shin:?}");
                    let arm = way("Arm", "ForeArm");
                    assert!(out * arm[0] > 0.05 && arm[1] < -0.2 && arm[2] > 0.05);
                    let [upper, lower] = [arm, way("ForeArm", "Hand")].map(Vector::from);
                    let angle = upper.angle(lower).unwrap();
                    assert!(
                        (angle - ARM.bent).abs() < 1e-9 && lower.e3 > 0.1,
                        "{arms:?} {lower:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn other_bodies_have_no_usual_posture() {
        let skeleton = person([1.0, 0.0], 0.0);
        let named = |name: &dyn Fn(&str) -> String| {
            let joints = skeleton.joints().iter().map(|joint| Joint {
                name: name(&joint.name),
                ..joint.clone()
            });
            Skeleton::new(joints.collect()).unwrap()
        };
        // Toes that would point backwards.
        let exchanged = named(&|name| match name.strip_prefix("Left") {
            Some(part) => format!("Right{part}"),
            None => name.replace("Right", "Left"),
        });
        assert!(spreads(&exchanged).is_empty());
        assert!(spreads(crate::example::model().skeleton()).is_empty());
    }
}
