//! How well pairs determine a motion.

use ga_runtime::cga3::Motor;
use ga_runtime::vga3::Vector;

use super::sampson::{SampsonCost, across_translation};
use crate::feature::PixelPair;
use crate::geometry_error::ViewGeometryError;
use ga_numerics::least_squares::{Covariance, Minimum, Region};
use ga_numerics::ransac::SelectedNoise;

/// Distances of corners in the left view up to which their errors may be alike, in pixels: the
/// pictures of their surroundings overlap.
const REACH: f64 = 16.0;

/// The covariance of the twist that follows a motion, from the distances of the pairs that a
/// threshold has kept; `None` where they do not show their noise, as up to seven pairs.
///
/// # Errors
/// [`ViewGeometryError::Undetermined`] where they do not determine the motion.
pub(super) fn covariance(
    problem: &SampsonCost<'_>,
    minimum: &Minimum<Motor<f64>>,
    pixels: &[PixelPair],
    threshold: f64,
) -> Result<Option<[[f64; 6]; 6]>, ViewGeometryError> {
    let Minimum {
        cost,
        residuals,
        unknowns,
        ..
    } = *minimum;
    let noise = SelectedNoise::new(cost, [residuals, unknowns], threshold, 1);
    let Some(variance) = noise.and_then(|noise| noise.of_region(unknowns)) else {
        return Ok(None);
    };
    let variance = variance * correlation(problem, minimum.state, pixels);
    let covariance = minimum.curved_covariance(problem, variance, Region::Ellipsoid);
    let covariance = covariance.ok_or(ViewGeometryError::Undetermined)?;
    Ok(Some(of_twist(&covariance, minimum.state)))
}

/// By how much sums over the pairs vary more than those of independent errors, 1 or more: the sum
/// of the products of the distances of neighbouring pairs over the sum of their squares (T. G.
/// Conley, "GMM estimation with cross sectional dependence", Journal of Econometrics 92, 1999). The
/// errors of corners that are near each other, or of one corner in several scales, are alike.
pub(super) fn correlation(
    problem: &SampsonCost<'_>,
    motor: Motor<f64>,
    pixels: &[PixelPair],
) -> f64 {
    let distances = problem.pairs.iter().map(|one| one.sampson_distance(motor));
    let mut placed: Vec<([f64; 2], f64)> =
        pixels.iter().map(|one| one.left).zip(distances).collect();
    placed.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
    let (mut products, mut squares) = (0.0, 0.0);
    for (index, (place, distance)) in placed.iter().enumerate() {
        squares += distance * distance;
        let before = placed[..index].iter().rev();
        for (other, other_distance) in before.take_while(|one| place[0] - one.0[0] <= REACH) {
            if (place[0] - other[0]).hypot(place[1] - other[1]) <= REACH {
                products += distance * other_distance;
            }
        }
    }
    match squares > 0.0 {
        true => (1.0 + 2.0 * products / squares).max(1.0),
        false => 1.0,
    }
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
