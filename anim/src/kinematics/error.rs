//! Why a problem of kinematics has no solution.

use crate::skeleton::SkeletonError;

/// Why a problem of forward or inverse kinematics has no solution: of hierarchies and their layers,
/// of chains and whole poses, and of legs.
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
    Skeleton(#[from] SkeletonError),
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
    /// A parent does not come before its child.
    #[error("joint {joint} has joint {parent} as its parent, which does not come before it")]
    ParentNotBefore {
        /// The joint.
        joint: usize,
        /// The index that it has as its parent.
        parent: usize,
    },
    /// The motors are not a whole number of poses.
    #[error("{found} motors are not a whole number of poses of {joints} joints")]
    PoseMotors {
        /// How many joints a pose has.
        joints: usize,
        /// How many motors there are.
        found: usize,
    },
    /// The result has another length than the operand.
    #[error("{found} motors for the result of {expected}")]
    ResultLength {
        /// How many motors there are to compute.
        expected: usize,
        /// How many there is room for.
        found: usize,
    },
    /// The weight of a joint is not a number from 0 to 1.
    #[error("the weight of joint {joint} is not from 0 to 1")]
    LayerWeight {
        /// The joint.
        joint: usize,
    },
    /// A slice does not have one element for each joint.
    #[error("a slice has {found} elements for {expected} joints")]
    SliceLength {
        /// How many joints there are.
        expected: usize,
        /// How many elements the slice has.
        found: usize,
    },
    /// A factor of a joint is not 1, so that its map is not a motor.
    #[error("joint {joint} is scaled, and a motor does not scale")]
    Scaled {
        /// The joint.
        joint: usize,
    },
    /// A segment's length is not positive and finite.
    #[error("the {segment} cannot be {length} m long")]
    LegLength {
        /// The segment.
        segment: &'static str,
        /// Its length.
        length: f64,
    },
    /// An angle is not finite.
    #[error("the angle {angle} is not finite: {value}")]
    LegAngle {
        /// The name of the angle.
        angle: &'static str,
        /// Its value.
        value: f64,
    },
    /// A position is not finite.
    #[error("the {place} has a coordinate that is not finite: {coordinates:?}")]
    LegPlace {
        /// What is there.
        place: &'static str,
        /// Its coordinates.
        coordinates: [f64; 3],
    },
    /// The distance between two joints differs from the length of their bone.
    #[error("the {segment} is {found} m long between its joints; it should be {expected} m")]
    LegBone {
        /// The segment.
        segment: &'static str,
        /// Its length.
        expected: f64,
        /// The distance of the joints.
        found: f64,
    },
    /// Two segments do not meet in their joint.
    #[error("the segments are {gap} m apart at the {joint}")]
    LegApart {
        /// The joint.
        joint: &'static str,
        /// How far they are apart.
        gap: f64,
    },
    /// A joint is rotated about an axis that it does not have.
    #[error("the {joint} is rotated by {angle} rad about an axis that it does not have")]
    LegNotHinged {
        /// The joint.
        joint: &'static str,
        /// By how much, in radians.
        angle: f64,
    },
    /// The target is too far or too near.
    #[error(
        "the target is {distance} m from the hip; the ankle reaches from {least} m to {most} m"
    )]
    LegUnreachable {
        /// The distance of the target from the hip.
        distance: f64,
        /// The least distance.
        least: f64,
        /// The greatest distance.
        most: f64,
    },
    /// The target is the hip, so that the direction of the thigh is not determined.
    #[error(
        "the target is {distance} m from the hip, too close to determine the direction of the thigh"
    )]
    LegFolded {
        /// The distance of the target from the hip.
        distance: f64,
    },
    /// The pole is on the line from hip to target, so that it does not determine a side.
    #[error("the pole is on the line from the hip to the target")]
    LegPole,
}
