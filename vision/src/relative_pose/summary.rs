//! The motion between two views in numbers, under the names of JSON.

use serde::Serialize;

use super::RelativePose;

/// A rotation, and the direction of a translation: a point x in the left camera's frame is at
/// `R x + t` in that of the right one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MotionSummary {
    /// R by rows.
    pub rotation_matrix: [[f64; 3]; 3],
    /// Its axis, of length 1.
    pub rotation_axis: [f64; 3],
    /// Its angle, of no more than 180°.
    pub rotation_degrees: f64,
    /// t, of length 1.
    pub translation_direction: [f64; 3],
    /// The standard deviation of the rotation, where it is known.
    pub rotation_deviation_degrees: Option<f64>,
    /// The standard deviation of the direction, where it is known.
    pub direction_deviation_degrees: Option<f64>,
}

/// Another motion that explains two views as well.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AlternativeMotion {
    /// R by rows.
    pub rotation: [[f64; 3]; 3],
    /// t, of length 1.
    pub direction: [f64; 3],
    /// The standard deviation of the rotation, where it is known.
    pub rotation_deviation_degrees: Option<f64>,
    /// The standard deviation of the direction, where it is known.
    pub direction_deviation_degrees: Option<f64>,
    /// How many pairs agree.
    pub inliers: usize,
    /// How many of these are in front of both cameras.
    pub in_front: usize,
    /// The root mean square of the Sampson distances of the pairs that agree, in pixels.
    pub rms_px: f64,
}

impl RelativePose {
    /// The [alternatives](Self::alternatives) in numbers.
    #[must_use]
    pub fn alternative_summaries(&self) -> Vec<AlternativeMotion> {
        let summary = |pose: &Self| {
            let motion = pose.summary();
            AlternativeMotion {
                rotation: motion.rotation_matrix,
                direction: motion.translation_direction,
                rotation_deviation_degrees: motion.rotation_deviation_degrees,
                direction_deviation_degrees: motion.direction_deviation_degrees,
                inliers: pose.inliers.len(),
                in_front: pose.in_front,
                rms_px: pose.root_mean_square,
            }
        };
        self.alternatives.iter().map(summary).collect()
    }

    /// The motion in numbers.
    #[must_use]
    pub fn summary(&self) -> MotionSummary {
        let motor = self.left_to_right.motor;
        let (rotation_axis, angle) = motor.rotor().canonical().to_axis_angle();
        MotionSummary {
            rotation_matrix: motor.rotor().to_matrix(),
            rotation_axis,
            rotation_degrees: angle.to_degrees(),
            translation_direction: motor.translator().displacement(),
            rotation_deviation_degrees: self.rotation_deviation().map(f64::to_degrees),
            direction_deviation_degrees: self.direction_deviation().map(f64::to_degrees),
        }
    }
}
