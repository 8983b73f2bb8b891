//! The joints of any person that are those of the mannequin.

use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::recording::Recording;
use ga_anim::retarget::JointMap;
use ga_anim::skeleton::Skeleton;

/// The joints of a person that are those of these names of the mannequin: by their names or by the
/// shape of the body, as a motion of the mannequin finds them.
pub(super) fn counterparts<const N: usize>(
    skeleton: &Skeleton,
    names: [&str; N],
) -> Option<[usize; N]> {
    let human = ga_mannequin::skeleton();
    let rest = Clip::new(1.0, vec![Pose::rest(human.len())]).ok()?;
    let rest = Recording::from_clip(&human, &rest).ok()?;
    let (map, _) = JointMap::found(&rest, skeleton).ok()?;
    let found = names.iter().map(|name| {
        let joint = human.index(name)?;
        let mut moved = map.source_of().iter();
        moved.position(|source| *source == Some(joint))
    });
    let found: Vec<usize> = found.collect::<Option<_>>()?;
    found.try_into().ok()
}

/// The direction in which a person faces at rest, from +z towards +x in radians: from the right hip
/// to the left is its left. Without hips it is +z.
pub(super) fn facing(skeleton: &Skeleton) -> f64 {
    let Some(hips) = counterparts(skeleton, ["LeftUpperLeg", "RightUpperLeg"]) else {
        return 0.0;
    };
    let [left, right] = hips.map(|joint| skeleton.joints()[joint].head);
    (right[2] - left[2]).atan2(left[0] - right[0])
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use ga_anim::skeleton::Joint;

    use super::*;

    /// The mannequin, turned about the vertical, with names that say nothing.
    #[test]
    fn a_person_is_known_by_its_shape() {
        let human = ga_mannequin::skeleton();
        for angle in [0.0_f64, 1.0, -2.5] {
            let (sin, cos) = angle.sin_cos();
            let turned = |[x, y, z]: [f64; 3]| [x * cos + z * sin, y, z * cos - x * sin];
            let joints = human.joints().iter().enumerate();
            let joints = joints.map(|(index, joint)| Joint {
                name: format!("bone {index}"),
                parent: joint.parent,
                head: turned(joint.head),
                tail: turned(joint.tail),
            });
            let skeleton = Skeleton::new(joints.collect()).unwrap();
            let names = ["LeftUpperLeg", "LeftLowerLeg", "LeftFoot"];
            let expected = names.map(|name| human.index(name).unwrap());
            assert_eq!(counterparts(&skeleton, names), Some(expected));
            assert!((facing(&skeleton) - angle).abs() < 1e-9);
        }
        assert_eq!(facing(&human), 0.0);
    }
}
