//! Chains of joints: where they move what they carry, and how fast.
//!
//! A chain is described by its generators at rest (the product of exponentials: Brockett, 1984;
//! Lynch and Park, Modern Robotics, 2017, chapters 4 and 5). With a generator `Gₖ` and a coordinate
//! `qₖ` for each joint, from the base to the tip, the motor
//!
//! ```text
//! M = exp(q₁ G₁) exp(q₂ G₂) … exp(qₙ Gₙ)
//! ```
//!
//! takes what is fixed to the tip from its place at rest, where all coordinates are zero, to its
//! place now. Its derivatives by the coordinates are the columns of the Jacobian: `∂M/∂qₖ = Jₖ M`,
//! with `Jₖ` the generator of the k-th joint where it is now. All generators are given in the
//! coordinates of the world, so that joints need no frames of their own.
//!
//! Nothing here allocates: the columns are iterators.
//!
//! ```
//! use ga_runtime::cga3::{Direction, Line, Point};
//! use ga_runtime::geometry::kinematics::{Joint, point_jacobian, pose};
//!
//! // A planar arm: two joints about vertical axes, a metre apart, and a metre to the tip.
//! let axis = |x: f64| Line::from_point_direction(Point::new(x, 0.0, 0.0), [0.0, 0.0, 1.0]);
//! let quarter = std::f64::consts::FRAC_PI_2;
//! let arm = [
//!     Joint::revolute(axis(0.0), 0.0).unwrap(),
//!     Joint::revolute(axis(1.0), quarter).unwrap(),
//! ];
//! let tip = Point::new(2.0, 0.0, 0.0);
//! assert!(pose(&arm).transform(tip).distance(Point::new(1.0, 1.0, 0.0)) < 1e-15);
//! // Metres that the tip moves for each radian of a joint.
//! let mut columns = point_jacobian(&arm, tip);
//! let (first, second) = (columns.next().unwrap(), columns.next().unwrap());
//! assert!((first - Direction::new(-1.0, 1.0, 0.0)).length() < 1e-15);
//! assert!((second - Direction::new(-1.0, 0.0, 0.0)).length() < 1e-15);
//! ```

use super::Screw;
use crate::cga3::{Direction, Line, Motor, MotorGenerator, Point};
use crate::scalar::Real;

/// A joint of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<S> {
    /// The generator G of the joint at rest, in the coordinates of the world: the joint moves by
    /// `exp(q G)`.
    pub generator: MotorGenerator<S>,
    /// The coordinate q of the joint: radians for one that rotates, the unit of length for one that
    /// slides.
    pub coordinate: S,
}

impl<S: Real<Mask = bool>> Joint<S> {
    /// A revolute joint: a rotation about an axis, right-handed, by an angle in radians. `None`
    /// where the axis has weight zero or a number is not finite.
    #[must_use]
    pub fn revolute(axis: Line<S>, angle: S) -> Option<Self> {
        let rate = Screw {
            axis,
            angle: S::one(),
            displacement: S::zero(),
        };
        Self::new(rate, angle)
    }

    /// A prismatic joint: a translation along a direction by a length. `None` where the direction
    /// is zero or a number is not finite.
    #[must_use]
    pub fn prismatic(direction: Direction<S>, length: S) -> Option<Self> {
        let rate = Screw {
            axis: Line::from_point_direction(Point::default(), direction.vector()),
            angle: S::zero(),
            displacement: S::one(),
        };
        Self::new(rate, length)
    }

    fn new(rate: Screw<S>, coordinate: S) -> Option<Self> {
        coordinate.is_finite().then_some(Self {
            generator: rate.generator()?,
            coordinate,
        })
    }

    /// The motor of the joint, `exp(q G)`.
    #[must_use]
    pub fn motor(self) -> Motor<S> {
        (self.generator * self.coordinate).exp()
    }
}

/// The motor of a chain, from the base to the tip: it takes what is fixed to the tip from its place
/// at rest to its place now. The identity for no joints.
#[must_use]
pub fn pose<S: Real<Mask = bool>>(joints: &[Joint<S>]) -> Motor<S> {
    joints
        .iter()
        .fold(Motor::default(), |pose, joint| pose * joint.motor())
}

/// The columns of the Jacobian of a chain, one for each joint: the generator of the motion of the
/// tip for a unit rate of that joint alone, `Jₖ = M₁…ₖ₋₁ Gₖ ~M₁…ₖ₋₁`, in the coordinates of the
/// world. The motion of the tip for rates q̇ has the generator `Σ q̇ₖ Jₖ`.
///
/// As numbers, the columns of the 6×n matrix (the spatial Jacobian) are
/// [`angular_velocity`](MotorGenerator::angular_velocity) and
/// [`velocity_at`](MotorGenerator::velocity_at) the origin.
pub fn jacobian<S: Real<Mask = bool>>(
    joints: &[Joint<S>],
) -> impl ExactSizeIterator<Item = MotorGenerator<S>> {
    let mut before = Motor::default();
    joints.iter().map(move |joint| {
        let column = before.transform(joint.generator);
        before *= joint.motor();
        column
    })
}

/// The columns of the 3×n Jacobian of a point that is fixed to the tip of a chain, given by its
/// place at rest: its velocity for a unit rate of each joint alone. In units of length per radian
/// for a revolute joint, without unit for a prismatic one.
pub fn point_jacobian<S: Real<Mask = bool>>(
    joints: &[Joint<S>],
    at_rest: Point<S>,
) -> impl ExactSizeIterator<Item = Direction<S>> {
    let place = pose(joints).transform(at_rest);
    jacobian(joints).map(move |column| column.velocity_at(place))
}
