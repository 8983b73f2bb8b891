//! From the places of the joints back to angles.

use ga_runtime::cga3::{Point, Rotor};

use super::inverse::{hinged, turns_about_zyx};
use super::vector::{across, cross, dot, length, minus, rows, unit};
use super::{Leg, LegAngles, LegError, finite};

/// Below this sine two directions are taken to be one.
const PARALLEL: f64 = 1e-12;

impl Leg {
    /// The inverse problem for places: the angles of a leg whose hip, knee and ankle are seen at
    /// these points and whose foot is turned from rest by a rotor.
    ///
    /// The hinge of the knee is across thigh, calf and the length of the foot; it is taken from the
    /// two of them that are farther from being in line. Of its two ways round the one nearer to the
    /// foot's own x axis is taken, so the ankle's angle about z comes back in [−π/2, π/2], and the
    /// knee's is negative where the knee bends the wrong way. Where thigh, calf and foot are all in
    /// line, the points do not show the hinge: then the ankle's angle about z is 0, and the hip has
    /// the whole turn about the line. The hip's angles are as of [`Leg::inverse`].
    ///
    /// # Errors
    /// [`LegError::Place`] for a point that is not finite, [`LegError::Bone`] where thigh or calf
    /// differ from the leg's by more than the tolerance in metres, and [`LegError::NotHinged`]
    /// where knee or ankle turn about an axis that they do not have by more than the tolerance in
    /// radians.
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
    /// # Ok::<(), ga_anim::leg::LegError>(())
    /// ```
    pub fn inverse_of_points(
        &self,
        [hip, knee, ankle]: [Point<f64>; 3],
        foot: Rotor<f64>,
        tolerance: f64,
    ) -> Result<LegAngles, LegError> {
        for (place, point) in [("hip", hip), ("knee", knee), ("ankle", ankle)] {
            finite(place, point)?;
        }
        let upper = bone("thigh", minus(knee, hip), self.thigh, tolerance)?;
        let lower = bone("calf", minus(ankle, knee), self.calf, tolerance)?;
        let [foot_x, foot_y, foot_z] = columns(foot.to_matrix());

        let hinge = hinge(upper, lower, foot_x, foot_z);
        // The hinge is across the calf; the sines of the angles by which it is not across the
        // others must be small.
        hinged("knee", dot(hinge, upper).clamp(-1.0, 1.0).asin(), tolerance)?;
        hinged(
            "ankle",
            dot(hinge, foot_z).clamp(-1.0, 1.0).asin(),
            tolerance,
        )?;

        let up = upper.map(|x| -x);
        let hinge = unit(across(hinge, up)).unwrap_or(hinge);
        let [hip_z, hip_y, hip_x] = turns_about_zyx(rows(hinge, up, cross(hinge, up)));
        let knee = dot(cross(upper, lower), hinge).atan2(dot(upper, lower));
        // The calf's axes are the hinge, the calf upwards and what is across both.
        let forward = cross(lower, hinge);
        Ok(LegAngles {
            hip_z,
            hip_y,
            hip_x,
            knee,
            ankle_x: dot(lower, foot_z).atan2(dot(forward, foot_z)),
            ankle_z: (-dot(hinge, foot_y)).atan2(dot(hinge, foot_x)),
        })
    }
}

/// The unit direction of a bone, if it is as long as it should be.
fn bone(
    segment: &'static str,
    between: [f64; 3],
    expected: f64,
    tolerance: f64,
) -> Result<[f64; 3], LegError> {
    let found = length(between);
    let error = LegError::Bone {
        segment,
        expected,
        found,
    };
    if (found - expected).abs() <= tolerance {
        unit(between).ok_or(error)
    } else {
        Err(error)
    }
}

/// The unit vector across thigh, calf and foot that is nearer to the foot's x axis than its
/// opposite.
fn hinge(upper: [f64; 3], lower: [f64; 3], foot_x: [f64; 3], foot_z: [f64; 3]) -> [f64; 3] {
    let candidates = [cross(upper, lower), cross(foot_z, lower)];
    let [at_knee, at_ankle] = candidates.map(length);
    let seen = if at_knee > at_ankle {
        candidates[0]
    } else {
        candidates[1]
    };
    let hinge = unit(seen).filter(|_| at_knee.max(at_ankle) > PARALLEL);
    // A short product is off by rounding in all directions; what is along the calf can be taken
    // away.
    let hinge = across(hinge.unwrap_or(foot_x), lower);
    let hinge = unit(hinge).unwrap_or(foot_x);
    if dot(hinge, foot_x) < 0.0 {
        hinge.map(|x| -x)
    } else {
        hinge
    }
}

fn columns(matrix: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let [x, y, z] = matrix;
    rows(x, y, z)
}
