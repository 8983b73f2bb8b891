//! From the positions of the joints back to angles.

use ga_runtime::cga3::{Point, Rotor};
use ga_runtime::vga3::Vector;

use super::inverse::{angles_about_zyx, hinged};
use super::{Leg, LegAngles, finite, rotation};
use crate::kinematics::KinematicsError;

/// Two directions count as parallel below this sine of the angle between them.
const PARALLEL: f64 = 1e-12;

impl Leg {
    /// The inverse problem for positions: the angles of a leg whose hip, knee and ankle are at
    /// these points and whose foot is rotated from rest by a rotor.
    ///
    /// The hinge of the knee is perpendicular to thigh, calf and the length of the foot; it is
    /// computed from the two of them that are farther from being parallel. Of its two orientations
    /// the one nearer to the foot's own x axis is taken, so the ankle's angle about z is in [−π/2,
    /// π/2], and the knee's is negative where the knee bends the wrong way. Where thigh, calf and
    /// foot are all parallel, the points do not determine the hinge: then the ankle's angle about z
    /// is 0, and the hip has the whole rotation about the line. The hip's angles are as in
    /// [`Leg::inverse`].
    ///
    /// # Errors
    /// [`KinematicsError::LegPlace`] for a point that is not finite, [`KinematicsError::LegBone`]
    /// where thigh or calf differ from the leg's by more than the tolerance in metres, and
    /// [`KinematicsError::LegNotHinged`] where knee or ankle are rotated about an axis that they do
    /// not have by more than the tolerance in radians.
    ///
    /// ```
    /// use ga_anim::leg::{Leg, LegAngles};
    /// use ga_runtime::cga3::Point;
    /// let leg = Leg::new(0.45, 0.43, 0.2)?;
    /// let angles = LegAngles {
    ///     hip_x: -0.7,
    ///     knee: 1.2,
    ///     ankle_x: 0.1,
    ///     ankle_z: 0.2,
    ///     ..LegAngles::default()
    /// };
    /// let pose = leg.forward(Point::new(0.1, 0.9, 0.0), &angles)?;
    /// let found = leg.inverse_of_points(
    ///     [pose.hip, pose.knee, pose.ankle],
    ///     pose.motions[2].rotor(),
    ///     1e-9,
    /// )?;
    /// assert!((found.knee - 1.2).abs() < 1e-14 && (found.ankle_z - 0.2).abs() < 1e-14);
    /// # Ok::<(), ga_anim::kinematics::KinematicsError>(())
    /// ```
    pub fn inverse_of_points(
        &self,
        [hip, knee, ankle]: [Point<f64>; 3],
        foot: Rotor<f64>,
        tolerance: f64,
    ) -> Result<LegAngles, KinematicsError> {
        for (place, point) in [("hip", hip), ("knee", knee), ("ankle", ankle)] {
            finite(place, point)?;
        }
        let upper = bone("thigh", hip.vector_to(knee), self.thigh, tolerance)?;
        let lower = bone("calf", knee.vector_to(ankle), self.calf, tolerance)?;
        let rows = foot.to_matrix();
        let [foot_x, foot_y, foot_z] = [0, 1, 2].map(|k| Vector::from(rows.map(|row| row[k])));

        let hinge = hinge(upper, lower, foot_x, foot_z);
        // The hinge is perpendicular to the calf; the sines of the angles by which it is not
        // perpendicular to the others must be small.
        hinged("knee", hinge.dot(upper).clamp(-1.0, 1.0).asin(), tolerance)?;
        hinged(
            "ankle",
            hinge.dot(foot_z).clamp(-1.0, 1.0).asin(),
            tolerance,
        )?;

        let up = -upper;
        let hinge = (hinge - up * hinge.dot(up)).normalized().unwrap_or(hinge);
        let [hip_z, hip_y, hip_x] = angles_about_zyx(rotation(hinge, up));
        let knee = upper.cross(lower).dot(hinge).atan2(upper.dot(lower));
        // The calf's axes are the hinge, the upward direction of the calf and their cross product.
        let forward = lower.cross(hinge);
        Ok(LegAngles {
            hip_z,
            hip_y,
            hip_x,
            knee,
            ankle_x: lower.dot(foot_z).atan2(forward.dot(foot_z)),
            ankle_z: (-hinge.dot(foot_y)).atan2(hinge.dot(foot_x)),
        })
    }
}

/// The unit direction of a bone, if it is as long as it should be.
fn bone(
    segment: &'static str,
    between: Vector<f64>,
    expected: f64,
    tolerance: f64,
) -> Result<Vector<f64>, KinematicsError> {
    let found = between.length();
    let error = KinematicsError::LegBone {
        segment,
        expected,
        found,
    };
    if (found - expected).abs() <= tolerance {
        between.normalized().ok_or(error)
    } else {
        Err(error)
    }
}

/// The unit vector perpendicular to thigh, calf and foot that is nearer to the foot's x axis than
/// its opposite.
fn hinge(
    upper: Vector<f64>,
    lower: Vector<f64>,
    foot_x: Vector<f64>,
    foot_z: Vector<f64>,
) -> Vector<f64> {
    let (at_knee, at_ankle) = (upper.cross(lower), foot_z.cross(lower));
    let longer = if at_knee.length() > at_ankle.length() {
        at_knee
    } else {
        at_ankle
    };
    let seen = longer
        .normalized()
        .filter(|_| longer.length() > PARALLEL)
        .unwrap_or(foot_x);
    // A short cross product has rounding errors in all directions. The part along the calf can be
    // removed.
    let hinge = (seen - lower * seen.dot(lower))
        .normalized()
        .unwrap_or(foot_x);
    if hinge.dot(foot_x) < 0.0 {
        -hinge
    } else {
        hinge
    }
}
