//! What skeletons, poses and limits must have in common.

use super::error::KinematicsError;
use crate::pose::Pose;
use crate::pose::PoseError;
use crate::skeleton::{JointLimits, Skeleton};

/// An error unless a joint is below another one.
pub(super) fn below(
    skeleton: &Skeleton,
    above: usize,
    below: usize,
) -> Result<(), KinematicsError> {
    let joints = skeleton.joints();
    let mut joint = joints[below].parent;
    while let Some(parent) = joint {
        if parent == above {
            return Ok(());
        }
        joint = joints[parent].parent;
    }
    Err(KinematicsError::NotBelow {
        below: joints[below].name.clone(),
        above: joints[above].name.clone(),
    })
}

/// Whether pose and limits are for the skeleton.
pub(super) fn fits(
    skeleton: &Skeleton,
    limits: Option<&JointLimits>,
    pose: &Pose,
) -> Result<(), KinematicsError> {
    let (expected, found) = (skeleton.len(), pose.joints.len());
    if expected != found {
        return Err(PoseError { expected, found }.into());
    }
    match limits.map(JointLimits::joint_count) {
        Some(found) if found != expected => Err(KinematicsError::Limits { expected, found }),
        _ => Ok(()),
    }
}
