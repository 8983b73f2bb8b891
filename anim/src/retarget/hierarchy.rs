//! Which joint moves which: the parents of a skeleton, with limbs put together that rigs for
//! inverse kinematics take apart.

use super::human::Human;
use crate::skeleton::Skeleton;

/// On which joint each one hangs when a motion is transferred.
#[derive(Clone, Debug)]
pub(super) struct Hanging {
    pub(super) parents: Vec<Option<usize>>,
    /// The joints, parents before children.
    pub(super) order: Vec<usize>,
    /// For each joint the nearest one above that is matched.
    pub(super) matched_above: Vec<Option<usize>>,
}

impl Hanging {
    /// The skeleton's own parents, but for the joints of limbs: one that is not below the joint
    /// before it in the limb, such as a foot that hangs on the root, hangs on that joint.
    pub(super) fn new(
        skeleton: &Skeleton,
        human: Option<&Human>,
        source_of: &[Option<usize>],
    ) -> Self {
        let joints = skeleton.joints();
        let mut parents: Vec<Option<usize>> = joints.iter().map(|joint| joint.parent).collect();
        for chain in human.into_iter().flat_map(Human::chains) {
            for pair in chain.windows(2) {
                let (above, joint) = (pair[0], pair[1]);
                // What would close a ring stays where it is.
                if !is_below(&parents, joint, above) && !is_below(&parents, above, joint) {
                    parents[joint] = Some(above);
                }
            }
        }
        let mut order = Vec::with_capacity(joints.len());
        let mut is_placed = vec![false; joints.len()];
        for joint in 0..joints.len() {
            let up = std::iter::successors(Some(joint), |&joint| parents[joint]);
            let way: Vec<usize> = up.take_while(|&joint| !is_placed[joint]).collect();
            for joint in way.into_iter().rev() {
                is_placed[joint] = true;
                order.push(joint);
            }
        }
        let mut matched_above = vec![None; joints.len()];
        for &joint in &order {
            matched_above[joint] = parents[joint].and_then(|parent| match source_of[parent] {
                Some(_) => Some(parent),
                None => matched_above[parent],
            });
        }
        Self {
            parents,
            order,
            matched_above,
        }
    }
}

/// Whether a joint is another one or below it.
pub(super) fn is_below(parents: &[Option<usize>], joint: usize, above: usize) -> bool {
    std::iter::successors(Some(joint), |&joint| parents[joint]).any(|joint| joint == above)
}
