//! A leg of two bones: from angles to the ankle, and from the ankle back to the angles.
//!
//! Everything is about the left leg and in the axes of the pelvis. The knee bends about x, the hip
//! about x and then about z. Angles are rotations from rest in radians, positive by the right-hand
//! rule: bending the knee is positive about x, lifting the thigh to the front negative.

use crate::Vector;
use crate::landmarks::Landmarks;

/// The rotations of hip and knee from rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LegAngles {
    /// Of the hip about x, which comes first.
    pub(crate) flexion: f64,
    /// Of the hip about z.
    pub(crate) spread: f64,
    /// Of the knee about x.
    pub(crate) knee: f64,
}

/// The two bones of the left leg at rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leg {
    thigh: Vector,
    shank: Vector,
}

impl Leg {
    pub(crate) fn new(landmarks: &Landmarks) -> Self {
        Leg {
            thigh: landmarks.knee - landmarks.hip,
            shank: landmarks.ankle - landmarks.knee,
        }
    }

    /// The rotations from rest for the angles that gait analysis measures: how far the thigh is in
    /// front of the vertical, and how far the shank lies behind the line of the thigh.
    pub(crate) fn clinical(&self, hip_flexion: f64, knee_flexion: f64) -> LegAngles {
        let lean = |bone: Vector| bone.e3.atan2(-bone.e2);
        LegAngles {
            flexion: lean(self.thigh) - hip_flexion,
            spread: 0.0,
            knee: knee_flexion - (lean(self.thigh) - lean(self.shank)),
        }
    }

    /// From the hip to the ankle.
    pub(crate) fn ankle(&self, angles: LegAngles) -> Vector {
        let [x, y, z] = about_x(self.bent(angles.knee), angles.flexion).coordinates();
        let (sin, cos) = angles.spread.sin_cos();
        Vector::new(x * cos - y * sin, x * sin + y * cos, z)
    }

    /// The angles that take the ankle to a place relative to the hip, the knee bent to the back;
    /// `None` when it is out of reach.
    pub(crate) fn reach(&self, ankle: Vector) -> Option<LegAngles> {
        let (t, s) = (self.thigh, self.shank);
        // |thigh + shank rotated by the knee|² = |ankle|² is a cos + b sin = c.
        let a = t.e2 * s.e2 + t.e3 * s.e3;
        let b = t.e3 * s.e2 - t.e2 * s.e3;
        let squares = ankle.length_squared() - t.length_squared() - s.length_squared();
        let c = 0.5 * squares - t.e1 * s.e1;
        let cosine = c / a.hypot(b);
        if !(-1.0..=1.0).contains(&cosine) {
            return None;
        }
        let knee = b.atan2(a) + cosine.acos();
        let bent = self.bent(knee);
        // About x the distance from the x axis stays, about z the height along z.
        let down = bent.e2 * bent.e2 + bent.e3 * bent.e3 - ankle.e3 * ankle.e3;
        if down < 0.0 {
            return None;
        }
        let y = -down.sqrt();
        Some(LegAngles {
            flexion: ankle.e3.atan2(y) - bent.e3.atan2(bent.e2),
            spread: ankle.e2.atan2(ankle.e1) - y.atan2(bent.e1),
            knee,
        })
    }

    fn bent(&self, knee: f64) -> Vector {
        self.thigh + about_x(self.shank, knee)
    }
}

/// A vector rotated about the x axis.
fn about_x(vector: Vector, angle: f64) -> Vector {
    let [x, y, z] = vector.coordinates();
    let (sin, cos) = angle.sin_cos();
    Vector::new(x, y * cos - z * sin, y * sin + z * cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn reach_brings_the_ankle_back(
            flexion in -1.5..1.0f64,
            spread in -0.4..0.4f64,
            knee in 0.0..2.2f64,
        ) {
            let leg = Leg::new(&Landmarks::new());
            let ankle = leg.ankle(LegAngles { flexion, spread, knee });
            let found = leg.reach(ankle).expect("it was reached");
            let again = leg.ankle(found);
            prop_assert!(again.distance(ankle) < 1e-12);
            prop_assert!((found.knee - knee).abs() < 1e-7);
        }
    }

    #[test]
    fn at_rest_the_ankle_is_where_the_landmarks_say() {
        let landmarks = Landmarks::new();
        let leg = Leg::new(&landmarks);
        let rest = leg.ankle(LegAngles {
            flexion: 0.0,
            spread: 0.0,
            knee: 0.0,
        });
        assert!(rest.distance(landmarks.ankle - landmarks.hip) < 1e-15);
    }

    #[test]
    fn clinical_angles_are_those_of_the_bones() {
        let leg = Leg::new(&Landmarks::new());
        let straight = leg.clinical(0.0, 0.0);
        let ankle = leg.ankle(straight);
        assert!(ankle.e3.abs() < 1e-15, "a straight leg hangs straight down");
        let bent =
            leg.ankle(leg.clinical(std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_2));
        let thigh = leg.thigh.e2.hypot(leg.thigh.e3);
        let shank = leg.shank.e2.hypot(leg.shank.e3);
        assert!((bent.e3 - thigh).abs() < 1e-15 && (bent.e2 + shank).abs() < 1e-15);
    }

    #[test]
    fn what_is_out_of_reach_has_no_angles() {
        let leg = Leg::new(&Landmarks::new());
        assert_eq!(leg.reach(Vector::new(0.0, -1.0, 0.0)), None);
        assert_eq!(leg.reach(Vector::new(0.0, 0.0, f64::NAN)), None);
    }
}
