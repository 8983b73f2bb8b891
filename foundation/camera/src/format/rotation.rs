//! Rotations of few digits, and the motors of which they are a part.

use ga_runtime::cga3::{Motor, Rotor, Translator};
use nalgebra_035::Matrix3;

use super::error::{CameraFileError, Place};

/// How far the entries of a matrix may be from those of a rotation: matrices with four digits after
/// the point are accepted.
pub(super) const ROTATION_TOLERANCE: f64 = 1e-4;

/// The rotation nearest to a matrix, unless one of its entries is further than
/// [`ROTATION_TOLERANCE`] from it.
pub(super) fn nearest_rotor(
    rows: [[f64; 3]; 3],
    place: impl FnOnce() -> Place,
) -> Result<Rotor<f64>, CameraFileError> {
    nearest(rows).map_err(|deviation| CameraFileError::Rotation {
        place: place(),
        deviation,
    })
}

/// The motor of the rows of a rotation and a translation.
pub(super) fn rigid(
    rows: [[f64; 4]; 3],
    place: impl FnOnce() -> Place,
) -> Result<Motor<f64>, CameraFileError> {
    let rotor = nearest_rotor(rows.map(|[a, b, c, _]| [a, b, c]), place)?;
    Ok(Translator::from_displacement(rows.map(|row| row[3])) * rotor)
}

/// As [`rigid`] for the rows of a homogeneous matrix, of which the last may be left out.
pub(super) fn homogeneous(
    rows: &[[f64; 4]],
    place: impl FnOnce() -> Place,
) -> Result<Motor<f64>, CameraFileError> {
    match *rows {
        [a, b, c] | [a, b, c, [0.0, 0.0, 0.0, 1.0]] => rigid([a, b, c], place),
        _ => Err(CameraFileError::Value {
            place: place(),
            expected: "a rotation and a translation of four rows, with 0, 0, 0 and 1 in the last",
        }),
    }
}

/// The rows of a motor's rotation and translation.
pub(super) fn rows(motor: Motor<f64>) -> [[f64; 4]; 3] {
    let (rotation, along) = (motor.rotor().to_matrix(), motor.translator().displacement());
    [0, 1, 2].map(|row| {
        let [a, b, c] = rotation[row];
        [a, b, c, along[row]]
    })
}

/// The nearest rotation, or how far the matrix is from it.
fn nearest(rows: [[f64; 3]; 3]) -> Result<Rotor<f64>, f64> {
    if let Some(rotor) = Rotor::from_matrix(rows) {
        return Ok(rotor);
    }
    let given = Matrix3::from_fn(|row, column| rows[row][column]);
    let parts = given.svd(true, true);
    let (Some(u), Some(v)) = (parts.u, parts.v_t) else {
        return Err(f64::INFINITY);
    };
    // The sign of the last direction, whose singular value is the least, makes a rotation of a
    // reflection.
    let sign = (u * v).determinant().signum();
    let nearest = u * Matrix3::from_diagonal(&[1.0, 1.0, sign].into()) * v;
    let deviation = (nearest - given).amax();
    if deviation.is_nan() || deviation > ROTATION_TOLERANCE {
        return Err(deviation);
    }
    let rows = [0, 1, 2].map(|row| [0, 1, 2].map(|column| nearest[(row, column)]));
    Rotor::from_matrix(rows).ok_or(deviation)
}
