//! The positions of the joints and the directions of the limbs at rest.
//!
//! Lengths follow the segment lengths as fractions of stature that Winter, Biomechanics and Motor
//! Control of Human Movement (4th edition, 2009, figure 4.1, after Drillis and Contini) gives, for
//! a stature of 1.75 m.

use crate::Vector;
use crate::frame::Frame;

/// Stature in metres.
pub(crate) const STATURE: f64 = 1.75;

/// Points of the left half of the body and of its middle, in metres: x to the left, y up, z to the
/// front.
#[derive(Clone, Debug)]
pub(crate) struct Landmarks {
    pub(crate) hip: Vector,
    pub(crate) knee: Vector,
    pub(crate) ankle: Vector,
    /// Where the toes bend, in the ball of the foot.
    pub(crate) ball: Vector,
    /// Frame of the foot: under the ankle on the ground, along towards the toes, depth up.
    pub(crate) foot: Frame,
    /// Frame of the arm: at the shoulder joint, along towards the wrist, across away from the body,
    /// depth to the front.
    pub(crate) arm: Frame,
}

/// The arms hang this far below the horizontal (radians), half way between stretched out and
/// hanging down.
pub(crate) const ARM_DROP: f64 = 48.0 * std::f64::consts::PI / 180.0;
/// The feet point outwards by this much (radians).
pub(crate) const TOE_OUT: f64 = 8.0 * std::f64::consts::PI / 180.0;

/// Distances along the arm from the shoulder joint, in metres.
pub(crate) const ELBOW: f64 = 0.305;
pub(crate) const WRIST: f64 = 0.560;
/// Half way along the fingers.
pub(crate) const HAND: f64 = 0.700;
/// How far in front of the arm's axis the middle of the wrist lies: the elbow is slightly bent.
pub(crate) const WRIST_FORWARD: f64 = 0.016;

/// Distances along the foot from the ankle, in metres.
pub(crate) const HEEL: f64 = -0.058;
const BALL: f64 = 0.118;
pub(crate) const TOE_TIP: f64 = 0.200;

impl Landmarks {
    pub(crate) fn new() -> Self {
        let ankle = Vector::new(0.102, 0.078, -0.028);
        let (sin, cos) = TOE_OUT.sin_cos();
        let (arm_sin, arm_cos) = ARM_DROP.sin_cos();
        let foot = Frame {
            origin: Vector::new(ankle.e1, 0.0, ankle.e3),
            along: Vector::new(sin, 0.0, cos),
            across: Vector::new(cos, 0.0, -sin),
            depth: Vector::Y,
        };
        Landmarks {
            hip: Vector::new(0.088, 0.915, 0.0),
            knee: Vector::new(0.094, 0.500, 0.006),
            ankle,
            ball: foot.point(BALL, 0.0, 0.016),
            foot,
            arm: Frame {
                origin: Vector::new(0.182, 1.408, -0.018),
                along: Vector::new(arm_cos, -arm_sin, 0.0),
                across: Vector::new(arm_sin, arm_cos, 0.0),
                depth: Vector::Z,
            },
        }
    }
}
