//! The fitted body as points and bones.

use anyhow::Result;
use ga_anim::clip::{self, opposite_name, side_of_name};
use ga_anim::skeleton::Skeleton;
use ga_body::character::FittedCharacter;
use ga_draw::document::{Bone, Side};

/// The joints of a body in motion and, for what is drawn, the ends of its limbs.
pub(super) struct Figure {
    /// The joints of the skeleton, then the ends of limbs.
    pub(super) names: Vec<String>,
    /// How many of these are joints.
    pub(super) joints: usize,
    /// From each joint to the one above it, and to the end of its limb.
    pub(super) bones: Vec<Bone>,
    /// For each frame where the points are, in metres with y up.
    pub(super) frames: Vec<Vec<[f64; 3]>>,
}

impl Figure {
    pub(super) fn new(fitted: &FittedCharacter) -> Result<Self> {
        let skeleton = fitted.character.skeleton();
        let joints = skeleton.joints();
        let mut names: Vec<String> = joints.iter().map(|joint| joint.name.clone()).collect();
        let mut bones = Vec::new();
        let mut ends = Vec::new();
        for (index, joint) in joints.iter().enumerate() {
            let side = side(skeleton, &joint.name);
            if let Some(parent) = joint.parent {
                let ends = [parent, index];
                bones.push(Bone { ends, side });
            }
            if skeleton.children(index).next().is_none() && joint.tail != joint.head {
                let ends_of_bone = [index, names.len()];
                bones.push(Bone {
                    ends: ends_of_bone,
                    side,
                });
                names.push(format!("end of {}", joint.name));
                ends.push(index);
            }
        }
        let frames = fitted.poses.iter().map(|fit| {
            let of_bones = fit.pose.bones(skeleton)?;
            let heads = of_bones.iter().map(|[head, _]| *head);
            let tails = ends.iter().map(|&joint| of_bones[joint][1]);
            Ok(heads.chain(tails).collect())
        });
        Ok(Self {
            joints: joints.len(),
            frames: frames.collect::<Result<_>>()?,
            names,
            bones,
        })
    }
}

/// The side of a joint whose counterpart is there as well.
fn side(skeleton: &Skeleton, name: &str) -> Side {
    let is_paired = opposite_name(name).is_some_and(|other| skeleton.index(&other).is_some());
    match side_of_name(name).filter(|_| is_paired) {
        Some((clip::Side::Left, _)) => Side::Left,
        Some((clip::Side::Right, _)) => Side::Right,
        None => Side::Middle,
    }
}
