//! The joints of the body and their bones at rest.

use crate::landmarks::{ELBOW, HAND, Landmarks, TOE_TIP, WRIST, WRIST_FORWARD};
use crate::{Vector, mirror};
use ga_anim::skeleton::{Joint, Skeleton};

pub(crate) const HIPS: usize = 0;
pub(crate) const SPINE: usize = 1;
pub(crate) const CHEST: usize = 2;
pub(crate) const NECK: usize = 3;
pub(crate) const HEAD: usize = 4;
/// The first joint of each limb, left and right; the others follow it in order.
pub(crate) const ARM: [usize; 2] = [5, 9];
pub(crate) const LEG: [usize; 2] = [13, 17];

pub(crate) const COUNT: usize = 21;

const ARM_NAMES: [&str; 4] = ["Shoulder", "UpperArm", "LowerArm", "Hand"];
const LEG_NAMES: [&str; 4] = ["UpperLeg", "LowerLeg", "Foot", "Toe"];

/// The skeleton: five joints from the hips to the head, then the left and the right arm, then the
/// left and the right leg.
pub(crate) fn skeleton(landmarks: &Landmarks) -> Skeleton {
    let spine: [Vector; 6] = [
        Vector::new(0.0, 0.955, -0.005),
        Vector::new(0.0, 1.050, -0.014),
        Vector::new(0.0, 1.190, -0.022),
        Vector::new(0.0, 1.465, -0.028),
        Vector::new(0.0, 1.560, -0.006),
        Vector::new(0.0, 1.745, 0.004),
    ];
    let names = ["Hips", "Spine", "Chest", "Neck", "Head"];
    let mut joints: Vec<Joint> = names
        .iter()
        .enumerate()
        .map(|(i, name)| joint((*name).to_owned(), i.checked_sub(1), spine[i], spine[i + 1]))
        .collect();
    let arm = [
        Vector::new(0.022, 1.436, -0.004),
        landmarks.arm.origin,
        landmarks.arm.point(ELBOW, 0.0, 0.001),
        landmarks.arm.point(WRIST, 0.0, WRIST_FORWARD),
        landmarks.arm.point(HAND, -0.012, WRIST_FORWARD + 0.004),
    ];
    let leg = [
        landmarks.hip,
        landmarks.knee,
        landmarks.ankle,
        landmarks.ball,
        landmarks.foot.point(TOE_TIP, 0.0, 0.012),
    ];
    for (limb, names, above) in [(arm, ARM_NAMES, CHEST), (leg, LEG_NAMES, HIPS)] {
        for side in ["Left", "Right"] {
            for (i, name) in names.iter().enumerate() {
                let place = |p: Vector| if side == "Left" { p } else { mirror(p) };
                let parent = if i == 0 { above } else { joints.len() - 1 };
                let name = format!("{side}{name}");
                joints.push(joint(
                    name,
                    Some(parent),
                    place(limb[i]),
                    place(limb[i + 1]),
                ));
            }
        }
    }
    Skeleton::new(joints).expect("parents come first and names differ")
}

fn joint(name: String, parent: Option<usize>, head: Vector, tail: Vector) -> Joint {
    Joint {
        name,
        parent,
        head: head.coordinates(),
        tail: tail.coordinates(),
    }
}
