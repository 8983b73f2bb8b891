//! A leg of two bones: from angles to the ankle, and from the ankle back to the angles.
//!
//! Everything is about the left leg and in the axes of the pelvis. The knee bends about x, the hip
//! about x and then about z. Angles are rotations from rest in radians, positive by the right-hand
//! rule: bending the knee is positive about x, lifting the thigh to the front negative.

use crate::landmarks::Landmarks;
use crate::vector::{Vector, dot, sub};

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
            thigh: sub(landmarks.knee, landmarks.hip),
            shank: sub(landmarks.ankle, landmarks.knee),
        }
    }

    /// The rotations from rest for the angles that gait analysis measures: how far the thigh is in
    /// front of the vertical, and how far the shank lies behind the line of the thigh.
    pub(crate) fn clinical(&self, hip_flexion: f64, knee_flexion: f64) -> LegAngles {
        let lean = |bone: Vector| bone[2].atan2(-bone[1]);
        LegAngles {
            flexion: lean(self.thigh) - hip_flexion,
            spread: 0.0,
            knee: knee_flexion - (lean(self.thigh) - lean(self.shank)),
        }
    }

    /// From the hip to the ankle.
    pub(crate) fn ankle(&self, angles: LegAngles) -> Vector {
        let [x, y, z] = about_x(self.bent(angles.knee), angles.flexion);
        let (sin, cos) = angles.spread.sin_cos();
        [x * cos - y * sin, x * sin + y * cos, z]
    }

    /// The angles that take the ankle to a place relative to the hip, the knee bent to the back;
    /// `None` when it is out of reach.
    pub(crate) fn reach(&self, ankle: Vector) -> Option<LegAngles> {
        let (t, s) = (self.thigh, self.shank);
        // |thigh + shank turned by the knee|² = |ankle|² is a cos + b sin = c.
        let a = t[1] * s[1] + t[2] * s[2];
        let b = t[2] * s[1] - t[1] * s[2];
        let c = 0.5 * (dot(ankle, ankle) - dot(t, t) - dot(s, s)) - t[0] * s[0];
        let cosine = c / a.hypot(b);
        if !(-1.0..=1.0).contains(&cosine) {
            return None;
        }
        let knee = b.atan2(a) + cosine.acos();
        let bent = self.bent(knee);
        // About x the distance from the x axis stays, about z the height along z.
        let down = dot(bent, bent) - bent[0] * bent[0] - ankle[2] * ankle[2];
        if down < 0.0 {
            return None;
        }
        let y = -down.sqrt();
        Some(LegAngles {
            flexion: ankle[2].atan2(y) - bent[2].atan2(bent[1]),
            spread: ankle[1].atan2(ankle[0]) - y.atan2(bent[0]),
            knee,
        })
    }

    fn bent(&self, knee: f64) -> Vector {
        let shank = about_x(self.shank, knee);
        std::array::from_fn(|k| self.thigh[k] + shank[k])
    }
}

/// Turned about the x axis.
pub(crate) fn about_x([x, y, z]: Vector, angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    [x, y * cos - z * sin, y * sin + z * cos]
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
            for k in 0..3 {
                prop_assert!((again[k] - ankle[k]).abs() < 1e-12);
            }
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
        let expected = sub(landmarks.ankle, landmarks.hip);
        let error = sub(rest, expected);
        assert!(dot(error, error).sqrt() < 1e-15);
    }

    #[test]
    fn clinical_angles_are_those_of_the_bones() {
        let leg = Leg::new(&Landmarks::new());
        let straight = leg.clinical(0.0, 0.0);
        let ankle = leg.ankle(straight);
        assert!(ankle[2].abs() < 1e-15, "a straight leg hangs straight down");
        let bent =
            leg.ankle(leg.clinical(std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_2));
        let thigh = leg.thigh[1].hypot(leg.thigh[2]);
        let shank = leg.shank[1].hypot(leg.shank[2]);
        assert!((bent[2] - thigh).abs() < 1e-15 && (bent[1] + shank).abs() < 1e-15);
    }

    #[test]
    fn what_is_out_of_reach_has_no_angles() {
        let leg = Leg::new(&Landmarks::new());
        assert_eq!(leg.reach([0.0, -1.0, 0.0]), None);
        assert_eq!(leg.reach([0.0, 0.0, f64::NAN]), None);
    }
}
