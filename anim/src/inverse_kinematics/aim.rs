//! Aiming: an axis of a joint towards a target, another one upwards.

use super::check::{exists, finite, fits};
use super::motion::{own_motion, total_motion};
use super::rotation::{rotated, rotation_between_frames};
use ga_runtime::cga3::{Point, Rotor};
use ga_runtime::vga3::Vector;

use crate::kinematics::KinematicsError;
use crate::pose::{Pose, moved};
use crate::skeleton::{JointLimits, Skeleton};

/// Below this sine of the angle between them, two directions count as parallel.
const PARALLEL: f64 = 1e-9;

/// What is to be aimed: an axis, such as that of the eyes, and a direction that is to be upwards.
///
/// ```
/// use ga_anim::inverse_kinematics::Aim;
/// use ga_runtime::cga3::Direction;
///
/// // A head that looks along z, with its crown along y.
/// let head = Aim::new([0.0, 0.0, 1.0], [0.0, 1.0, 0.0])?;
/// let rotor = head.rotor([3.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
/// let eyes = rotor.transform(Direction::new(0.0, 0.0, 1.0));
/// assert!((eyes - Direction::new(1.0, 0.0, 0.0)).length() < 1e-15);
/// # Ok::<(), ga_anim::kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    axis: Vector<f64>,
    up: Vector<f64>,
}

impl Aim {
    /// An axis and an upward direction, of any lengths, in the axes of the skeleton at rest.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Axis`] for a direction without length, and [`KinematicsError::Parallel`].
    pub fn new(axis: [f64; 3], up: [f64; 3]) -> Result<Self, KinematicsError> {
        let (axis, up) = (direction("axis", axis)?, direction("upward axis", up)?);
        if axis.cross(up).length() <= PARALLEL {
            let (axis, up) = ("axis", "upward axis");
            return Err(KinematicsError::Parallel { axis, up });
        }
        Ok(Self { axis, up })
    }

    /// The rotor that takes the axis to a direction and the upward axis into the half plane of that
    /// direction and `up`, as near to `up` as possible.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Axis`] for a direction without length, and [`KinematicsError::Parallel`].
    pub fn rotor(&self, towards: [f64; 3], up: [f64; 3]) -> Result<Rotor<f64>, KinematicsError> {
        let (axis, up_name) = ("direction to the target", "upward direction");
        let (towards, up) = (direction(axis, towards)?, direction(up_name, up)?);
        let parallel = KinematicsError::Parallel { axis, up: up_name };
        if towards.cross(up).length() <= PARALLEL {
            return Err(parallel);
        }
        rotation_between_frames([self.axis, self.up], [towards, up]).ok_or(parallel)
    }
}

/// Rotates a joint of a pose about its head so that the axis points to a target and the upward axis
/// as nearly as possible along `up`, both in the coordinates of the model; with limits, as nearly
/// as they admit. Gives the angle in radians by which the axis misses the target.
///
/// # Errors
///
/// [`KinematicsError::NoJoint`], [`KinematicsError::Skeleton`], [`KinematicsError::Limits`],
/// [`KinematicsError::NotFinite`], and those of [`Aim::rotor`], as for a target at the joint.
pub fn aim_joint(
    skeleton: &Skeleton,
    limits: Option<&JointLimits>,
    pose: &mut Pose,
    joint: usize,
    aim: &Aim,
    target: Point<f64>,
    up: [f64; 3],
) -> Result<f64, KinematicsError> {
    exists(skeleton, joint)?;
    fits(skeleton, limits, pose)?;
    finite("the target", target)?;
    let rest = &skeleton.joints()[joint];
    let above = rest
        .parent
        .map_or(pose.root, |parent| total_motion(skeleton, pose, parent));
    // Where the joint is displaced, its head is not where its parent has it.
    let head = Point::from(moved(above * pose.joints[joint], rest.head));
    let towards = head.vector_to(target);
    let total = aim.rotor(towards.into(), up)?;
    let own = above.rotor().reverse() * total;
    let own = limits.map_or(own, |limits| limits.clamp(joint, own));
    let place = moved(pose.joints[joint], rest.head);
    pose.joints[joint] = own_motion(rest.head, own, place);
    let reached = rotated(above.rotor() * own, aim.axis);
    Ok(reached.angle(towards).unwrap_or(0.0))
}

fn direction(what: &'static str, axis: [f64; 3]) -> Result<Vector<f64>, KinematicsError> {
    let vector = Vector::from(axis).normalized();
    vector.ok_or(KinematicsError::Axis { what, axis })
}
