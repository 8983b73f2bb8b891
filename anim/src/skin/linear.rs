use ga_runtime::cga3::{Motor, Point};

use crate::weights::{Influence, SkinWeights};

pub(super) fn blend(
    positions: &[Point<f64>],
    weights: &SkinWeights,
    motions: &[Motor<f64>],
) -> Vec<Point<f64>> {
    let matrices: Vec<[[f64; 4]; 3]> = motions.iter().map(|motion| motion.to_matrix()).collect();
    let mean = |influences: &[Influence]| {
        let mut mean = [[0.0; 4]; 3];
        for influence in influences {
            let matrix = &matrices[influence.joint as usize];
            for (sum, entry) in mean
                .as_flattened_mut()
                .iter_mut()
                .zip(matrix.as_flattened())
            {
                *sum += influence.weight * entry;
            }
        }
        mean
    };
    let moved = positions
        .iter()
        .zip(weights.iter())
        .map(|(position, influences)| {
            let [x, y, z] = position.coordinates();
            Point::from(mean(influences).map(|[a, b, c, d]| a * x + b * y + c * z + d))
        });
    moved.collect()
}
