//! How well the unknowns are determined where the residuals are not linear in them.

use nalgebra_035::{Cholesky, DMatrix, DVector, SymmetricEigen};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, Normal};

use super::covariance::Covariance;
use super::region::{LEVEL, Region};
use crate::order_statistics::Sorted;

/// How many errors are drawn for an ellipsoid, and for intervals.
const DRAWN: [usize; 2] = [250, 100];
/// How many of them tell whether the residuals are as good as linear.
const TRIED: usize = 25;
/// How many at least are followed one after the other.
const TOGETHER: usize = 8;

/// The covariance of unknowns where residuals bend within their deviations, from that to first
/// order with the residuals at the minimum and after a step of the shared unknowns. See
/// [`Minimum::curved_covariance`](super::Minimum::curved_covariance).
///
/// In coordinates y in which the ellipsoid to first order is the unit ball, errors of the residuals
/// move the minimum by a normal vector z of variance 1 if the residuals are linear in y. Otherwise
/// by the y at which the residuals have moved as far within their tangent space, `z = z(y)` with
///
/// ```text
/// z(y) = Lᵀ Jᵀ (r(L y) − r(0)) / variance,   L Lᵀ = variance (JᵀJ)⁻¹
/// ```
///
/// which is exact for residuals on a surface that is flat, however unevenly the unknowns cover it.
/// Where z does not come as far, as for a point beyond the horizon, y is where it ends. `None`
/// where the residuals do not exist about the minimum, and where variances grow so much that the
/// minimum is a hollow in a wide valley.
pub(super) fn curved<R: FnMut(&[f64]) -> Option<Vec<f64>>>(
    first: &Covariance,
    variance: f64,
    region: Region,
    (start, jacobian): (&[f64], &DMatrix<f64>),
    residuals: impl Fn() -> R + Sync,
) -> Option<Covariance> {
    /// Changes of z up to this are those of residuals that are linear.
    const LINEAR: f64 = 0.05;
    /// Errors that are so much larger are far above rounding.
    const ABOVE_ROUNDING: f64 = 1e3;
    /// Where variances grow by more than this, the minimum says nothing of the truth.
    const GREATEST: f64 = 25.0;
    /// Iterations of a search for eigenvalues, far more than matrices of this size need.
    const SWEEPS: usize = 10_000;
    let count = jacobian.ncols();
    let matrix = DMatrix::from_fn(count, count, |row, column| first.shared(row, column));
    let Some(factor) = Cholesky::new(matrix) else {
        // No variance, as of exact observations.
        return Some(first.clone());
    };
    let axes = factor.l();
    let tangents = jacobian * &axes / variance;
    let start = DVector::from_column_slice(start);
    let moving = || {
        let (mut residuals, axes, tangents, start) = (residuals(), &axes, &tangents, &start);
        move |y: &DVector<f64>| -> Option<DVector<f64>> {
            let residuals = residuals((axes * y).as_slice())?;
            Some(tangents.tr_mul(&(DVector::from_vec(residuals) - start)))
        }
    };
    let drawn = normal_draws(
        count,
        match region {
            Region::Ellipsoid => DRAWN[0],
            Region::Intervals => DRAWN[1].max(4 * count),
        },
    );
    // Errors as small as rounding look bent, but not where they are larger.
    let is_linear = |scale: f64| {
        let tried = drawn.par_iter().take(TRIED).with_min_len(TOGETHER);
        let is_near = tried.map_init(moving, |moved, draw| {
            let draw = draw * scale;
            let moved = moved(&draw);
            moved.is_some_and(|moved| (moved - &draw).norm() <= LINEAR * draw.norm())
        });
        is_near.all(|is_near| is_near)
    };
    if is_linear(1.0) || is_linear(ABOVE_ROUNDING) {
        return Some(first.clone());
    }
    let errors = drawn.par_iter().with_min_len(TOGETHER);
    let errors = errors.map_init(moving, |moved, draw| followed(draw, moved));
    let errors = errors.collect::<Option<Vec<DVector<f64>>>>()?;
    let square = DMatrix::zeros(count, count);
    let sum = errors.iter().fold(square, |sum, y| sum + y * y.transpose());
    let moments = sum / errors.len() as f64;
    let quantile = |values: &mut dyn Iterator<Item = f64>| {
        let mut values: Vec<f64> = values.collect();
        Some(Sorted::new(&mut values)?.quantile(LEVEL))
    };
    let curved = match region {
        Region::Ellipsoid => {
            // As many errors are within their ellipsoid as draws are within a ball.
            let inverse = Cholesky::new(moments.clone())?;
            let reached = quantile(&mut errors.iter().map(|y| y.dot(&inverse.solve(y))))?;
            let drawn = quantile(&mut drawn.iter().map(|draw| draw.norm_squared()))?;
            let moments = moments * (reached / drawn);
            if moments.iter().any(|value| !value.is_finite()) {
                return None;
            }
            let greatest = SymmetricEigen::try_new(moments.clone(), f64::EPSILON, SWEEPS)?;
            if greatest.eigenvalues.max() > GREATEST {
                return None;
            }
            &axes * moments * axes.transpose()
        }
        Region::Intervals => {
            // As many errors of an unknown are within its interval as without a bend.
            let curved = &axes * moments * axes.transpose();
            let width = |unknown: usize| {
                let along = |y: &DVector<f64>| axes.row(unknown).transpose().dot(y).abs();
                let reached = quantile(&mut errors.iter().map(along))?;
                let straight = quantile(&mut drawn.iter().map(along))?;
                let deviation = axes.row(unknown).norm() * reached / straight;
                Some(deviation / curved[(unknown, unknown)].sqrt())
            };
            let widths: Option<Vec<f64>> = (0..count).map(width).collect();
            let widths = widths?;
            DMatrix::from_fn(count, count, |i, j| curved[(i, j)] * widths[i] * widths[j])
        }
    };
    let is_finite = curved.iter().all(|value| value.is_finite());
    is_finite.then(|| first.with_shared(curved))
}

/// The y with `z(y)` at a place, by C. G. Broyden's method ("A class of methods for solving
/// nonlinear simultaneous equations", Mathematics of Computation 19, 1965), or how far it comes
/// towards it. `None` where there are no residuals at all on the way.
fn followed(
    place: &DVector<f64>,
    moved: &mut impl FnMut(&DVector<f64>) -> Option<DVector<f64>>,
) -> Option<DVector<f64>> {
    /// How near, in standard deviations.
    const NEAR: f64 = 0.03;
    const STEPS: usize = 12;
    const HALVINGS: usize = 4;
    let count = place.len();
    let mut y = DVector::zeros(count);
    let mut left = place.clone();
    let mut inverse = DMatrix::identity(count, count);
    for step in 0..STEPS {
        if left.norm() <= NEAR {
            break;
        }
        let mut change = &inverse * &left;
        let mut next = None;
        for _ in 0..=HALVINGS {
            next = moved(&(&y + &change)).map(|moved| place - moved);
            if next.as_ref().is_some_and(|next| next.norm() < left.norm()) {
                break;
            }
            change *= 0.5;
        }
        let next = match next {
            Some(next) => next,
            None if step == 0 => return None,
            None => break,
        };
        let fell = &left - &next;
        let by_fall = &inverse * &fell;
        let length = change.dot(&by_fall);
        if length.abs() > 1e-9 * change.norm_squared() {
            let row = inverse.tr_mul(&change);
            inverse += (&change - by_fall) / length * row.transpose();
        }
        y += change;
        left = next;
    }
    Some(y)
}

/// Vectors that are spread as those of independent normal numbers: the multiples of powers of the
/// root of `φ^(d + 1) = φ + 1`, which fill a cube evenly, as quantiles, brought to the second
/// moments 1.
fn normal_draws(count: usize, drawn: usize) -> Vec<DVector<f64>> {
    let mut root: f64 = 1.5;
    for _ in 0..60 {
        root = (1.0 + root).powf((count as f64 + 1.0).recip());
    }
    let normal = Normal::standard();
    let draw = |index: usize| {
        let one = |axis: usize, _| {
            let multiple = index as f64 * root.powi(-(axis as i32 + 1));
            normal.inverse_cdf((0.5 + multiple).fract())
        };
        DVector::from_fn(count, one)
    };
    let drawn: Vec<DVector<f64>> = (1..=drawn).map(draw).collect();
    let sum = drawn
        .iter()
        .fold(DMatrix::zeros(count, count), |sum, draw| {
            sum + draw * draw.transpose()
        });
    match Cholesky::new(sum / drawn.len() as f64) {
        Some(factor) => {
            let lower = factor.l();
            let scaled = |draw: &DVector<f64>| lower.solve_lower_triangular(draw);
            drawn.iter().filter_map(scaled).collect()
        }
        None => drawn,
    }
}
