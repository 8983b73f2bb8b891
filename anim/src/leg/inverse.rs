//! From the motors of the segments back to angles.

use ga_runtime::cga3::{Motor, Point};

use super::{Leg, LegAngles, finite};
use crate::kinematics::KinematicsError;

impl Leg {
    /// The inverse problem: hip and angles from the motors of thigh, calf and foot.
    ///
    /// The hip's angle about y is returned in [−π/2, π/2], the other angles in [−π, π]. Where it is
    /// ±π/2 the hip's two other axes coincide, and the angle about x gets the whole rotation about
    /// them. Angles come from atan2 of the parts of rotors and matrices, which is accurate for all
    /// of them.
    ///
    /// # Errors
    /// [`KinematicsError::LegApart`] where two segments do not meet within the tolerance in metres,
    /// and [`KinematicsError::LegNotHinged`] where knee or ankle are rotated about an axis that
    /// they do not have by more than the tolerance in radians.
    pub fn inverse(
        &self,
        motions: &[Motor<f64>; 3],
        tolerance: f64,
    ) -> Result<(Point<f64>, LegAngles), KinematicsError> {
        let [hip, knee, ankle, _] = self.rest();
        let [thigh, calf, foot] = *motions;
        let place = thigh.transform(hip);
        finite("hip", place)?;
        meets(
            "knee",
            thigh.transform(knee),
            calf.transform(knee),
            tolerance,
        )?;
        meets(
            "ankle",
            calf.transform(ankle),
            foot.transform(ankle),
            tolerance,
        )?;

        let [hip_z, hip_y, hip_x] = angles_about_zyx(thigh.rotor().to_matrix());
        // The knee rotates about x alone: its rotor is cos ½δ − sin ½δ e23.
        let at_knee = thigh.rotor().reverse() * calf.rotor();
        let sideways = 2.0 * at_knee.e12().hypot(at_knee.e13()).min(1.0).asin();
        hinged("knee", sideways, tolerance)?;
        let knee = wrapped(2.0 * (-at_knee.e23()).atan2(at_knee.scalar()));
        // At the ankle the matrix of Rx(ε) Rz(ζ) has no third entry in its first row.
        let at_ankle = (calf.rotor().reverse() * foot.rotor()).to_matrix();
        hinged("ankle", at_ankle[0][2].clamp(-1.0, 1.0).asin(), tolerance)?;
        let ankle_x = (-at_ankle[1][2]).atan2(at_ankle[2][2]);
        let ankle_z = (-at_ankle[0][1]).atan2(at_ankle[0][0]);
        Ok((
            place,
            LegAngles {
                hip_z,
                hip_y,
                hip_x,
                knee,
                ankle_x,
                ankle_z,
            },
        ))
    }
}

/// The angles α, β, γ of `Rz(α) Ry(β) Rx(γ)` from its matrix. The angle about x is computed from
/// the matrix without the rotation about z, so that near the gimbal lock, where α is not
/// determined, the product of the three is still the same rotation.
pub(super) fn angles_about_zyx(matrix: [[f64; 3]; 3]) -> [f64; 3] {
    let [first, second, third] = matrix;
    let cosine = first[0].hypot(second[0]);
    let about_y = (-third[0]).atan2(cosine);
    let about_z = if cosine < 1e-15 {
        0.0
    } else {
        second[0].atan2(first[0])
    };
    let (s, c) = about_z.sin_cos();
    let about_x = (s * first[2] - c * second[2]).atan2(c * second[1] - s * first[1]);
    [about_z, about_y, about_x]
}

fn meets(
    joint: &'static str,
    above: Point<f64>,
    below: Point<f64>,
    tolerance: f64,
) -> Result<(), KinematicsError> {
    let gap = above.distance(below);
    if gap.is_finite() && gap <= tolerance {
        Ok(())
    } else {
        Err(KinematicsError::LegApart { joint, gap })
    }
}

/// Whether a joint's rotation about an axis that it does not have is small enough.
pub(super) fn hinged(
    joint: &'static str,
    angle: f64,
    tolerance: f64,
) -> Result<(), KinematicsError> {
    if angle.abs() <= tolerance {
        Ok(())
    } else {
        Err(KinematicsError::LegNotHinged { joint, angle })
    }
}

/// The same angle in [−π, π].
fn wrapped(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    if angle > PI {
        angle - TAU
    } else if angle < -PI {
        angle + TAU
    } else {
        angle
    }
}
