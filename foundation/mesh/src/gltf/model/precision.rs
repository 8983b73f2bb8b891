//! Numbers in single precision.

use super::ModelProblem;

/// Rounds to single precision; `what` and `index` name the vector when it does not fit.
pub(super) fn single<const N: usize>(
    vector: [f64; N],
    what: &'static str,
    index: usize,
) -> Result<[f32; N], ModelProblem> {
    let rounded = vector.map(|c| c as f32);
    if rounded.iter().all(|c| c.is_finite()) {
        Ok(rounded)
    } else {
        Err(ModelProblem::NotFinite { what, index })
    }
}
