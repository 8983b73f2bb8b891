//! How well pairs determine a motion.

use ga_runtime::cga3::Motor;
use ga_runtime::vga3::Vector;

use super::sampson::{SampsonCost, across_translation};
use crate::feature::PixelPair;
use ga_numerics::least_squares::{Covariance, Minimum};
use ga_numerics::ransac::SelectedNoise;

/// Pairs that differ by no more than this in both views, in pixels, show one corner and have one
/// error.
const REACH: f64 = 2.0;

/// The covariance of the twist that follows a motion, from the distances of the pairs that a
/// threshold has kept. `None` where there are no more pairs than unknowns, or they do not determine
/// the motion or their noise.
pub(super) fn covariance(
    problem: &SampsonCost<'_>,
    minimum: &Minimum<Motor<f64>>,
    pixels: &[PixelPair],
    threshold: f64,
) -> Option<[[f64; 6]; 6]> {
    let noise = SelectedNoise::new(minimum.variance()?, threshold, 1)?;
    let repeated = pixels.len() as f64 / corners(pixels) as f64;
    let covariance = minimum.curved_covariance(problem, noise.of_estimate * repeated)?;
    Some(of_twist(&covariance, minimum.state))
}

/// How many corners pairs show, where one may have been found in several scales of the views.
fn corners(pixels: &[PixelPair]) -> usize {
    let mut order: Vec<&PixelPair> = pixels.iter().collect();
    order.sort_by(|a, b| a.left[0].total_cmp(&b.left[0]));
    let mut chosen: Vec<&PixelPair> = Vec::new();
    for pair in order {
        let nearby = chosen.iter().rev();
        let mut nearby = nearby.take_while(|other| pair.left[0] - other.left[0] <= REACH);
        let is_same = |other: &&PixelPair| {
            let [[u, v], [x, y]] = [pair.left, pair.right];
            let [[a, b], [c, d]] = [other.left, other.right];
            (u - a).hypot(v - b) <= REACH && (x - c).hypot(y - d) <= REACH
        };
        if !nearby.any(is_same) {
            chosen.push(pair);
        }
    }
    chosen.len()
}

/// The covariance of a twist, from that of a rotation and two coordinates across the translation.
fn of_twist(covariance: &Covariance, motor: Motor<f64>) -> [[f64; 6]; 6] {
    let [a, b] = across_translation(motor);
    let axes = [Vector::X, Vector::Y, Vector::Z].map(Vector::coordinates);
    let (a, b) = (a.coordinates(), b.coordinates());
    // The rows of the linear map from the five coordinates to the six of the twist.
    let map: [[f64; 5]; 6] = std::array::from_fn(|row| match row {
        0..3 => {
            let [x, y, z] = axes[row];
            [x, y, z, 0.0, 0.0]
        }
        _ => [0.0, 0.0, 0.0, a[row - 3], b[row - 3]],
    });
    let product = |row: usize, column: usize| -> f64 {
        let terms = (0..25).map(|k| {
            let (i, j) = (k / 5, k % 5);
            map[row][i] * covariance.shared(i, j) * map[column][j]
        });
        terms.sum()
    };
    std::array::from_fn(|row| std::array::from_fn(|column| product(row, column)))
}
