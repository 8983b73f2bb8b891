//! The leg of hip, knee and ankle (Cui, §2.3.3): points joined by bones that are lines.
//!
//! At rest the leg hangs straight down from the origin: the knee at (0, −a, 0), the ankle at (0, −a
//! − b, 0) and the tip of the foot at (0, −a − b, c), with the lengths a of the thigh, b of the
//! calf and c of the foot. The *forward* problem goes from angles to positions: each segment has a
//! motor from rest to the pose,
//!
//! ```text
//! G_thigh = T(hip) Rz(α) Ry(β) Rx(γ)
//! G_calf  = G_thigh · (Rx(δ) about the knee at rest)
//! G_foot  = G_calf  · (Rx(ε) Rz(ζ) about the ankle at rest)
//! ```
//!
//! and points of the skin follow these motors by weights. The *inverse* problem goes back to
//! angles: from motors by [`Leg::inverse`], from the positions of the joints by
//! [`Leg::inverse_of_points`], from a target for the ankle by [`Leg::reach`]. Angles are in
//! radians, right-handed; a positive knee angle bends the calf backwards, to −z.

mod inverse;
mod points;
mod reach;

use ga_runtime::cga3::{Line, Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;

use crate::kinematics::KinematicsError;
use crate::skin::{Method, skin};
use crate::weights::SkinWeights;
use crate::weights::error::SkinError;

/// A leg, by the lengths of its segments.
///
/// ```
/// use ga_anim::leg::{Leg, LegAngles};
/// use ga_runtime::cga3::Point;
///
/// let leg = Leg::new(0.45, 0.43, 0.2)?;
/// let bent = LegAngles { knee: std::f64::consts::FRAC_PI_2, ..LegAngles::default() };
/// let pose = leg.forward(Point::new(0.0, 0.9, 0.0), &bent)?;
/// // The thigh hangs down, the calf points backwards.
/// assert!(pose.ankle.distance(Point::new(0.0, 0.45, -0.43)) < 1e-15);
/// let (hip, angles) = leg.inverse(&pose.motions, 1e-9)?;
/// assert!(hip.distance(pose.hip) < 1e-15 && (angles.knee - bent.knee).abs() < 1e-15);
/// # Ok::<(), ga_anim::kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    thigh: f64,
    calf: f64,
    foot: f64,
}

/// The angles of a leg's joints in radians. The rotations are intrinsic, about axes that rotate
/// with the segment, in the order z, y, x at the hip and x, z at the ankle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LegAngles {
    /// α: about z, swings the leg sideways.
    pub hip_z: f64,
    /// β: about y, rotates it inwards and outwards.
    pub hip_y: f64,
    /// γ: about x, swings it to the front and back.
    pub hip_x: f64,
    /// δ: about x, bends the knee.
    pub knee: f64,
    /// ε: about x, lifts and lowers the tip of the foot.
    pub ankle_x: f64,
    /// ζ: about z, rolls the foot about its length.
    pub ankle_z: f64,
}

/// The pose of a leg: hip, knee and ankle are conformal points (Cui, eqs. 29 to 31).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LegPose {
    /// The hip joint.
    pub hip: Point<f64>,
    /// The knee joint.
    pub knee: Point<f64>,
    /// The ankle joint.
    pub ankle: Point<f64>,
    /// The tip of the foot.
    pub toe: Point<f64>,
    /// The motors of thigh, calf and foot from rest to the pose.
    pub motions: [Motor<f64>; 3],
}

impl Leg {
    /// A leg with segments of these lengths in metres.
    ///
    /// # Errors
    /// [`KinematicsError::LegLength`] for a length that is not positive and finite.
    pub fn new(thigh: f64, calf: f64, foot: f64) -> Result<Self, KinematicsError> {
        for (segment, length) in [("thigh", thigh), ("calf", calf), ("foot", foot)] {
            if !length.is_finite() || length <= 0.0 {
                return Err(KinematicsError::LegLength { segment, length });
            }
        }
        Ok(Self { thigh, calf, foot })
    }

    /// The lengths of thigh, calf and foot in metres.
    #[must_use]
    pub fn lengths(&self) -> [f64; 3] {
        [self.thigh, self.calf, self.foot]
    }

    /// Hip, knee, ankle and tip of the foot at rest.
    #[must_use]
    pub fn rest(&self) -> [Point<f64>; 4] {
        let below = -self.thigh - self.calf;
        [
            [0.0, 0.0, 0.0],
            [0.0, -self.thigh, 0.0],
            [0.0, below, 0.0],
            [0.0, below, self.foot],
        ]
        .map(Point::from)
    }

    /// The forward problem: the pose of the leg, given the hip and the angles.
    ///
    /// # Errors
    /// [`KinematicsError`] where an angle or the hip is not finite.
    pub fn forward(&self, hip: Point<f64>, angles: &LegAngles) -> Result<LegPose, KinematicsError> {
        for (angle, value) in angles.named() {
            if !value.is_finite() {
                return Err(KinematicsError::LegAngle { angle, value });
            }
        }
        finite("hip", hip)?;
        let [_, knee, ankle, _] = self.rest();
        let to_hip = Translator::from_displacement(hip.coordinates());
        let thigh =
            to_hip * (about_z(angles.hip_z) * about_y(angles.hip_y) * about_x(angles.hip_x));
        let calf = thigh * Motor::about(knee, about_x(angles.knee));
        let foot = calf * Motor::about(ankle, about_x(angles.ankle_x) * about_z(angles.ankle_z));
        Ok(self.posed([thigh, calf, foot]))
    }

    fn posed(&self, motions: [Motor<f64>; 3]) -> LegPose {
        let [hip, knee, ankle, toe] = self.rest();
        let [thigh, calf, foot] = motions;
        LegPose {
            hip: thigh.transform(hip),
            knee: thigh.transform(knee),
            ankle: calf.transform(ankle),
            toe: foot.transform(toe),
            motions,
        }
    }
}

impl LegPose {
    /// Thigh, calf and foot as lines, each from its joint to the next: `p∧q∧ei`.
    #[must_use]
    pub fn bones(&self) -> [Line<f64>; 3] {
        [
            Line::through(self.hip, self.knee),
            Line::through(self.knee, self.ankle),
            Line::through(self.ankle, self.toe),
        ]
    }

    /// The angle between thigh and calf at the knee, π for a straight leg, by the bivector and the
    /// scalar part of the product of the two lines; the arc cosine of the scalar part alone would
    /// lose half the digits there.
    #[must_use]
    pub fn knee_interior_angle(&self) -> f64 {
        let [thigh, calf, _] = self.bones();
        let product = thigh * calf;
        let bivector = product.e12.hypot(product.e13).hypot(product.e23);
        bivector.atan2(-product.scalar)
    }

    /// The distance from hip to ankle, `√(−2 P·Q)` (Cui, eq. 32, corrected).
    #[must_use]
    pub fn hip_ankle_distance(&self) -> f64 {
        self.hip.distance(self.ankle)
    }

    /// The positions in the pose of points of the skin that are given at rest, with weights for
    /// thigh, calf and foot in this order.
    ///
    /// # Errors
    /// [`SkinError`] where points and weights do not fit together.
    pub fn skin(
        &self,
        points: &[Point<f64>],
        weights: &SkinWeights,
        method: Method,
    ) -> Result<Vec<Point<f64>>, SkinError> {
        skin(points, weights, &self.motions, method)
    }
}

impl LegAngles {
    fn named(&self) -> [(&'static str, f64); 6] {
        [
            ("hip_z", self.hip_z),
            ("hip_y", self.hip_y),
            ("hip_x", self.hip_x),
            ("knee", self.knee),
            ("ankle_x", self.ankle_x),
            ("ankle_z", self.ankle_z),
        ]
    }
}

fn finite(place: &'static str, point: Point<f64>) -> Result<(), KinematicsError> {
    let coordinates = point.coordinates();
    if coordinates.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(KinematicsError::LegPlace { place, coordinates })
    }
}

/// The matrix, by rows, of the rotation that takes the x axis to `x` and the y axis to `y`, which
/// are perpendicular unit vectors.
fn rotation(x: Vector<f64>, y: Vector<f64>) -> [[f64; 3]; 3] {
    let z = x.cross(y);
    std::array::from_fn(|k| [x[k], y[k], z[k]])
}

/// The rotor `cos ½θ − sin ½θ B` in the plane of a unit bivector B, for a finite angle.
fn about_x(angle: f64) -> Rotor<f64> {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    Rotor::new_unchecked(cosine, 0.0, 0.0, -sine)
}

fn about_y(angle: f64) -> Rotor<f64> {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    Rotor::new_unchecked(cosine, 0.0, sine, 0.0)
}

fn about_z(angle: f64) -> Rotor<f64> {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    Rotor::new_unchecked(cosine, -sine, 0.0, 0.0)
}
