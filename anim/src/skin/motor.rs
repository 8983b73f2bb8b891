use ga_runtime::cga3::{DualQuaternion, Motor, Point};

use super::SkinError;
use crate::weights::{Influence, SkinWeights};

pub(super) fn blend(
    positions: &[Point<f64>],
    weights: &SkinWeights,
    motions: &[Motor<f64>],
) -> Result<Vec<Point<f64>>, SkinError> {
    let moved =
        positions
            .iter()
            .zip(weights.iter())
            .enumerate()
            .map(|(vertex, (position, influences))| {
                let motor = mean(influences, motions).ok_or(SkinError::NoMean { vertex })?;
                Ok(motor.transform(*position))
            });
    moved.collect()
}

fn mean(influences: &[Influence], motions: &[Motor<f64>]) -> Option<Motor<f64>> {
    // Of equal weights the first decides, as in `SkinWeights::strongest`.
    let strongest = influences
        .iter()
        .reduce(|a, b| if b.weight > a.weight { b } else { a })?;
    let guide = motions[strongest.joint as usize];
    let mut sum = DualQuaternion::default();
    for influence in influences {
        let motion = motions[influence.joint as usize];
        let weight = if rotor_product(guide, motion) < 0.0 {
            -influence.weight
        } else {
            influence.weight
        };
        sum += motion * weight;
    }
    sum.normalize()
}

/// The scalar part of the one rotor times the other's reverse: the cosine of half the angle between
/// them.
fn rotor_product(a: Motor<f64>, b: Motor<f64>) -> f64 {
    a.scalar() * b.scalar() + a.e12() * b.e12() + a.e13() * b.e13() + a.e23() * b.e23()
}
