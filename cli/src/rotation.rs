//! Rotations as they are reported.

use ga_runtime::cga3::Rotor;

/// The axis of a rotation and its angle in degrees, of which there are no more than 180.
pub(crate) fn smaller_rotation(rotor: Rotor<f64>) -> ([f64; 3], f64) {
    // A rotor and its negative rotate to the same orientation, in opposite directions.
    let smaller = if rotor.scalar() < 0.0 { -rotor } else { rotor };
    let (axis, angle) = smaller.to_axis_angle();
    (axis, angle.to_degrees())
}
