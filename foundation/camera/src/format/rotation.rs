//! Rotations of few digits.

use ga_runtime::cga3::Rotor;
use nalgebra_035::Matrix3;

/// How far the entries of a matrix may be from those of a rotation: matrices with four digits after
/// the point are accepted.
pub(super) const ROTATION_TOLERANCE: f64 = 1e-4;

/// The rotation nearest to a matrix, unless one of its entries is further than
/// [`ROTATION_TOLERANCE`] from it; then how far.
pub(super) fn nearest_rotor(rows: [[f64; 3]; 3]) -> Result<Rotor<f64>, f64> {
    if let Some(rotor) = Rotor::from_matrix(rows) {
        return Ok(rotor);
    }
    let given = Matrix3::from_fn(|row, column| rows[row][column]);
    let parts = given.svd(true, true);
    let (Some(u), Some(v)) = (parts.u, parts.v_t) else {
        return Err(f64::INFINITY);
    };
    let nearest = u * v;
    let deviation = (nearest - given).amax();
    if nearest.determinant() < 0.0 || deviation.is_nan() || deviation > ROTATION_TOLERANCE {
        return Err(if nearest.determinant() < 0.0 {
            2.0
        } else {
            deviation
        });
    }
    let rows = [0, 1, 2].map(|row| [0, 1, 2].map(|column| nearest[(row, column)]));
    Rotor::from_matrix(rows).ok_or(deviation)
}
