use ga_runtime::batch;
use ga_runtime::cga3::{Motor, Point};

use super::SkinError;
use crate::weights::SkinWeights;

/// Moves each vertex by the blend of its motors, [`Motor::blend_influences`].
pub(super) fn blend(
    positions: &[Point<f64>],
    weights: &SkinWeights,
    motions: &[Motor<f64>],
) -> Result<Vec<Point<f64>>, SkinError> {
    let blends = weights.iter().enumerate().map(|(vertex, influences)| {
        let weighted = influences
            .iter()
            .map(|influence| (influence.weight, motions[influence.joint as usize]));
        Motor::blend_influences(weighted).ok_or(SkinError::NoMean { vertex })
    });
    let blends = blends.collect::<Result<Vec<_>, _>>()?;
    let mut moved = vec![Point::default(); positions.len()];
    batch::transform_each(&blends, positions, &mut moved).map_err(|mismatch| {
        SkinError::VertexCount {
            expected: mismatch.expected,
            found: mismatch.found,
        }
    })?;
    Ok(moved)
}
