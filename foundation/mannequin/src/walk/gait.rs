//! How a person walks: the angles of the joints at eight moments of a stride.
//!
//! The curves of hip, knee and ankle are those of free walking on level ground as in D. A. Winter,
//! The Biomechanics and Motor Control of Human Gait (2nd edition, 1991), and J. Perry and J. M.
//! Burnfield, Gait Analysis (2nd edition, 2010), read off at eighths of the stride; arms after M.
//! P. Murray, S. B. Sepic and E. J. Barnard, Patterns of sagittal rotation of the upper limbs in
//! walking, Physical Therapy 47 (1967). The eight moments are the animator's contact, down, passing
//! and up for either foot.

use std::f64::consts::FRAC_PI_4;

/// Key poses in a stride: four for each step.
pub const KEYS_PER_STRIDE: usize = 8;

/// What animators call the key poses of a stride, first as the left leg takes the weight and then
/// as the right one does.
pub const KEY_NAMES: [&str; KEYS_PER_STRIDE] = [
    "contact left",
    "down left",
    "passing left",
    "up left",
    "contact right",
    "down right",
    "passing right",
    "up right",
];

/// A leg at one moment: angles in degrees.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LegMoment {
    /// How far the thigh is in front of the vertical.
    pub(crate) hip: f64,
    /// How far the knee is bent.
    pub(crate) knee: f64,
    /// How far the ball of the foot is above the heel, as the slope of the sole.
    pub(crate) sole: f64,
}

/// The moment at which a leg's heel touches the ground.
pub(crate) const HEEL_STRIKE: usize = 0;
/// The moment at which the other heel does, when this one has left the ground and the ball is still
/// on it.
pub(crate) const HEEL_OFF: usize = 4;
/// The moment at which the toes leave the ground.
pub(crate) const TOE_OFF: usize = 5;

const fn leg(hip: f64, knee: f64, sole: f64) -> LegMoment {
    LegMoment { hip, knee, sole }
}

/// One leg through its stride, from the moment its heel touches the ground. The slope of the sole
/// at [`HEEL_OFF`] is left to the walk: it follows from both feet being on the ground.
pub(crate) const LEG: [LegMoment; KEYS_PER_STRIDE] = [
    leg(24.0, 5.0, 18.0),
    leg(20.0, 16.0, 0.0),
    leg(7.0, 13.0, 0.0),
    leg(-6.0, 10.0, 0.0),
    leg(-17.0, 13.0, 0.0),
    leg(-7.0, 42.0, -52.0),
    leg(18.0, 63.0, -28.0),
    leg(26.0, 29.0, 5.0),
];

/// The pelvis at one moment: angles in radians, by the right-hand rule.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TrunkMoment {
    /// How far the pelvis is off the middle, to the left, in metres.
    pub(crate) sway: f64,
    /// The pelvis about the vertical; negative brings the left side forward.
    pub(crate) turn: f64,
    /// The pelvis about the way ahead; positive lifts the left side.
    pub(crate) list: f64,
}

/// The pelvis `key` eighths of a stride after the left heel has touched the ground. It swings over
/// the leg that stands, drops a little on the other side, and brings the leg that swings forward.
pub(crate) fn trunk(key: usize) -> TrunkMoment {
    let phase = key as f64 * FRAC_PI_4;
    TrunkMoment {
        sway: 0.020 * (phase - 0.1).sin(),
        turn: -(5.0_f64.to_radians()) * phase.cos(),
        list: 3.5_f64.to_radians() * (phase + 0.25).sin(),
    }
}

/// The left arm at one moment, in radians.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ArmMoment {
    /// How far the upper arm is in front of the vertical.
    pub(crate) shoulder: f64,
    /// How far the elbow is bent.
    pub(crate) elbow: f64,
}

/// The left arm `key` eighths of a stride after the left heel has touched the ground: it goes
/// against the leg.
pub(crate) fn left_arm(key: usize) -> ArmMoment {
    let phase = key as f64 * FRAC_PI_4;
    ArmMoment {
        shoulder: (-4.0 - 17.0 * phase.cos()).to_radians(),
        elbow: (21.0 - 9.0 * (phase - 0.3).cos()).to_radians(),
    }
}
