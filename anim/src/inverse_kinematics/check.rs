//! What arguments must fulfil: skeletons, poses and limits, places and tolerances.

use ga_runtime::vga3::Vector;

use crate::kinematics::KinematicsError;
use crate::pose::Pose;
use crate::skeleton::{JointLimits, Skeleton, SkeletonError};

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
        return Err(SkeletonError::PoseLength { expected, found }.into());
    }
    match limits.map(JointLimits::joint_count) {
        Some(found) if found != expected => Err(KinematicsError::Limits { expected, found }),
        _ => Ok(()),
    }
}

/// An error where a place is not finite.
pub(super) fn finite(
    what: &'static str,
    place: impl Into<Vector<f64>>,
) -> Result<(), KinematicsError> {
    let place = place.into();
    if place.is_finite() {
        return Ok(());
    }
    let coordinates = place.coordinates();
    Err(KinematicsError::NotFinite { what, coordinates })
}

/// An error where a tolerance is negative or not a number.
pub(super) fn check_tolerance(tolerance: f64) -> Result<(), KinematicsError> {
    if tolerance >= 0.0 {
        return Ok(());
    }
    Err(KinematicsError::Tolerance(tolerance))
}

/// An error where a skeleton has no such joint.
pub(super) fn exists(skeleton: &Skeleton, index: usize) -> Result<(), KinematicsError> {
    let joints = skeleton.len();
    if index < joints {
        Ok(())
    } else {
        Err(KinematicsError::NoJoint { index, joints })
    }
}
