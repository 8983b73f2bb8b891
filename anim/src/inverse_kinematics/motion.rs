//! Motions of single joints.

use crate::pose::{Pose, moved};
use crate::skeleton::{JointLimits, Skeleton};
use ga_runtime::cga3::{Motor, Rotor, Translator};

/// The total motion of one joint: that of its parent after its own.
pub(super) fn total_motion(skeleton: &Skeleton, pose: &Pose, joint: usize) -> Motor<f64> {
    let mut motion = pose.joints[joint];
    let mut above = skeleton.joints()[joint].parent;
    while let Some(parent) = above {
        motion = pose.joints[parent] * motion;
        above = skeleton.joints()[parent].parent;
    }
    pose.root * motion
}

/// The own motion of a joint that rotates by a rotor and takes its head at rest to a place, in the
/// coordinates that its parent has at rest. The rotor is normalised: many small steps must not
/// lengthen it.
pub(super) fn own_motion(head: [f64; 3], rotor: Rotor<f64>, place: [f64; 3]) -> Motor<f64> {
    let rotor = Rotor::normalize(rotor.into()).unwrap_or(rotor);
    let [away, back] = [place, head.map(|x| -x)].map(Translator::from_displacement);
    away * rotor * back
}

/// The own motion of a joint after a further rotation about its head, within the joint's limits.
pub(super) fn with_rotation(
    limits: Option<&JointLimits>,
    joint: usize,
    head: [f64; 3],
    own: Motor<f64>,
    rotor: Rotor<f64>,
) -> Motor<f64> {
    let wanted = rotor * own.rotor();
    let wanted = limits.map_or(wanted, |limits| limits.clamp(joint, wanted));
    own_motion(head, wanted, moved(own, head))
}
