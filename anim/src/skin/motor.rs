use ga_runtime::cga3::{Motor, Point};

use super::SkinError;
use crate::weights::SkinWeights;

/// Moves each vertex by the blend of its motors, [`Motor::blend_influences`]. One pass is faster
/// than all blends first and then a batch of motions, since the blends then need no memory.
pub(super) fn blend(
    positions: &[Point<f64>],
    weights: &SkinWeights,
    motions: &[Motor<f64>],
) -> Result<Vec<Point<f64>>, SkinError> {
    let vertices = positions.iter().zip(weights.iter()).enumerate();
    let moved = vertices.map(|(vertex, (position, influences))| {
        let weighted = influences
            .iter()
            .map(|influence| (influence.weight, motions[influence.joint as usize]));
        let motor = Motor::blend_influences(weighted).ok_or(SkinError::NoMean { vertex })?;
        Ok(motor.transform(*position))
    });
    moved.collect()
}
