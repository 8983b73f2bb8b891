use ga_runtime::vga3::Vector;

use crate::pose::PoseError;
use crate::skeleton::Skeleton;

/// Why a problem of inverse kinematics has no solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum KinematicsError {
    /// A number is infinite or not a number.
    #[error("{what} is not finite: {coordinates:?}")]
    NotFinite {
        /// What the number belongs to.
        what: &'static str,
        /// The coordinates there.
        coordinates: [f64; 3],
    },
    /// The length of a bone is not positive and finite.
    #[error("bone {bone} cannot be {length} long")]
    Length {
        /// The bone, from 0 at the root of the chain.
        bone: usize,
        /// Its length.
        length: f64,
    },
    /// A chain has no bones, or another number of points than its bones have ends.
    #[error("a chain of {bones} bones cannot have {points} joints")]
    Chain {
        /// How many bones.
        bones: usize,
        /// How many points.
        points: usize,
    },
    /// The target is at the root of two bones of any lengths, so that their direction is not
    /// determined.
    #[error("the target is at the root of the limb, so the direction of its bones is undetermined")]
    Folded,
    /// The pole is on the line from root to target, so that it does not determine a side.
    #[error("the pole is on the line from the root of the limb to the target")]
    Pole,
    /// An axis has no length or is not finite.
    #[error("the {what} {axis:?} is not a direction")]
    Axis {
        /// Which axis.
        what: &'static str,
        /// Its coordinates.
        axis: [f64; 3],
    },
    /// Two directions that determine a rotation together are parallel.
    #[error("the {up} is parallel to the {axis}")]
    Parallel {
        /// The one.
        axis: &'static str,
        /// The other.
        up: &'static str,
    },
    /// There is no such joint.
    #[error("joint {index} is not in a skeleton of {joints} joints, which count from 0")]
    NoJoint {
        /// The index.
        index: usize,
        /// How many joints there are.
        joints: usize,
    },
    /// A joint of a chain is not below the one before it.
    #[error("joint {below:?} is not below joint {above:?}")]
    NotBelow {
        /// The joint that should be farther down.
        below: String,
        /// The joint that should be farther up.
        above: String,
    },
    /// A bone of a chain has no length.
    #[error("the bone of joint {joint:?} has no length")]
    ZeroLengthBone {
        /// The joint that the bone begins at.
        joint: String,
    },
    /// A pose does not fit the skeleton.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// The number of limits is not that of the joints.
    #[error("limits of {found} joints for a skeleton of {expected}")]
    Limits {
        /// How many joints there are.
        expected: usize,
        /// For how many the limits are.
        found: usize,
    },
    /// A tolerance is negative or not a number.
    #[error("{0} is not a tolerance")]
    Tolerance(f64),
    /// There is no marker.
    #[error("a fit needs at least one marker")]
    NoMarkers,
    /// There is not one target for each marker.
    #[error("{found} targets for {expected} markers")]
    Targets {
        /// How many markers there are.
        expected: usize,
        /// How many targets.
        found: usize,
    },
    /// A weight is negative or not finite, or all of them are zero.
    #[error("target {index} has the weight {weight}, or all weights are 0")]
    Weight {
        /// The target.
        index: usize,
        /// Its weight.
        weight: f64,
    },
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
