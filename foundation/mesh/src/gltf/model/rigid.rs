//! Motors as glTF has them: a unit quaternion and a translation.

use ga_runtime::cga3::{DualQuaternion, Motor};

/// The motor of length 1 with the same motion; `None` for a motor without a rotor and for one that
/// is not finite.
pub(super) fn normalized(motor: Motor<f64>) -> Option<Motor<f64>> {
    DualQuaternion::from(motor).normalize().filter(is_finite)
}

fn is_finite(motor: &Motor<f64>) -> bool {
    let translation = motor.translator().displacement();
    rotation(*motor)
        .iter()
        .chain(&translation)
        .all(|c| c.is_finite())
}

/// The quaternion *(x, y, z, w)* of a motor's rotor `w − x e23 + y e13 − z e12`: a rotation about
/// the unit axis *n* by α is cos(α/2) − sin(α/2) (n₁ e23 − n₂ e13 + n₃ e12).
pub(super) fn rotation(motor: Motor<f64>) -> [f64; 4] {
    [-motor.e23(), motor.e13(), -motor.e12(), motor.scalar()]
}

/// The translation of a motor, which follows its rotation.
pub(super) fn translation(motor: Motor<f64>) -> [f64; 3] {
    motor.translator().displacement()
}

/// The 4 × 4 matrix of the inverse of a unit motor, column by column.
pub(super) fn inverse_matrix(motor: Motor<f64>) -> [f64; 16] {
    let rows = motor.reverse().to_matrix();
    let mut matrix = [0.0; 16];
    for column in 0..4 {
        for row in 0..3 {
            matrix[4 * column + row] = rows[row][column];
        }
    }
    matrix[15] = 1.0;
    matrix
}

#[cfg(test)]
mod tests {
    use ga_runtime::cga3::{Rotor, Translator};
    use glam::{DMat4, DQuat, DVec3};
    use proptest::prelude::*;

    use super::*;

    fn vector() -> impl Strategy<Value = [f64; 3]> {
        prop::array::uniform3(-1f64..1.0)
    }

    proptest! {
        /// A rotation by the length of a vector about its direction, then a translation.
        #[test]
        fn a_motor_becomes_its_quaternion_and_translation(
            about in vector(),
            step in vector(),
            at in vector(),
        ) {
            let angle = DVec3::from(about).length();
            prop_assume!(angle > 1e-3);
            let rotor = Rotor::from_axis_angle(about, angle).unwrap();
            let motor = Translator::from_displacement(step) * rotor;
            let motor = normalized(motor).unwrap();

            let quaternion = DQuat::from_array(rotation(motor));
            prop_assert!((quaternion.length_squared() - 1.0).abs() < 1e-12);
            let displacement = DVec3::from(translation(motor));
            let found = DMat4::from_rotation_translation(quaternion, displacement);
            let expected = DMat4::from_rotation_translation(
                DQuat::from_scaled_axis(about.into()),
                step.into(),
            );
            let [found, expected] = [found, expected].map(|m| m.transform_point3(at.into()));
            prop_assert!(found.distance(expected) < 1e-12);
        }
    }
}
