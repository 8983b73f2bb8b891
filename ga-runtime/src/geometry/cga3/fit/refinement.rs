//! The search for the least sum of squared distances, or of losses of them.

use super::cloud::Weighted;
use super::loss::{Limited, loss};
use super::place::Place;
use super::shape::Shape;
use crate::geometry::cga3::matrix::{Matrix, solve, symmetric};
use crate::scalar::Real;

/// The result of a search.
pub(super) struct Refined<S> {
    pub(super) place: Place<S>,
    /// `Σ w ρ`.
    pub(super) cost: S,
    /// Whether the search came to an end.
    pub(super) has_converged: bool,
}

/// The normal equations at a place.
pub(super) struct Equations<S, const N: usize> {
    /// `Σ w ρ(r)`.
    pub(super) cost: S,
    /// `Σ w ψ(r)/r Jᵀ J`.
    pub(super) matrix: Matrix<S, N>,
    gradient: [S; N],
}

/// The steps that use the matrix of Gauss and Newton.
const FIRST_STEPS: usize = 12;

/// Minimises `Σ w ρ(r)` over the places of a primitive, from a place, in a bounded number of steps,
/// by the method of Levenberg and Marquardt on the tangent space of motors and the curvature
/// (Marquardt, An algorithm for least-squares estimation of nonlinear parameters, 1963). For a loss
/// the equations are weighted anew at each step (iteratively reweighted least squares).
///
/// Where that takes many steps, the further ones are Newton's: the tilt of a low ring of a
/// cylinder, for instance, changes distances less than their errors do, which the first matrix does
/// not see.
pub(super) fn refine<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: &[Weighted<S>],
    total: S,
    start: Place<S>,
    limited: Limited<S>,
    most_steps: usize,
) -> Refined<S> {
    let (zero, epsilon) = (S::zero(), S::epsilon());
    let ratio = |value: i64| S::from_integer(value);
    let mut place = start;
    let mut now = Equations::<S, N>::at::<P>(points, place, limited);
    let mut damping = S::from_f64(1e-4);
    let mut growth = ratio(4);
    let mut has_converged = false;
    for taken in 0..most_steps {
        let step = if taken < FIRST_STEPS {
            now.step(now.matrix, damping)
        } else {
            now.step(hessian::<P, S, N>(points, place, limited), damping)
        };
        let Some(step) = step else { break };
        let next_place = place.moved(&P::step(step));
        let next = Equations::<S, N>::at::<P>(points, next_place, limited);
        // The mean square by which the step changes distances.
        let change = now.form(step) / total;
        let mean_square = now.cost / total;
        // Below this the costs differ by the rounding of their sums only.
        let rounding = epsilon * ratio(4096);
        let least = epsilon * ratio(16);
        let is_small = change.less_than(rounding * mean_square + least * least);
        if next.cost.less_than(now.cost) || (is_small && next.cost.is_finite()) {
            let limit = S::from_f64(1e-10).max(epsilon * ratio(8));
            let rounding = epsilon * ratio(4);
            // A step that damping shortened does not say how far the least is.
            has_converged = damping.less_than(S::one())
                && change.less_than(limit * limit * mean_square + rounding * rounding);
            (place, now) = (next_place, next);
            damping = (damping * S::from_f64(0.1)).max(epsilon * epsilon);
            growth = ratio(4);
            if has_converged {
                break;
            }
        } else {
            damping *= growth;
            growth += growth;
            if !damping.is_finite() {
                break;
            }
        }
    }
    let least = epsilon * ratio(256);
    let is_exact = now.cost.less_than(least * least * total);
    Refined {
        place,
        cost: now.cost,
        has_converged: now.cost.is_finite() && (has_converged || is_exact || now.cost == zero),
    }
}

impl<S: Real<Mask = bool>, const N: usize> Equations<S, N> {
    pub(super) fn at<P: Shape<S, N>>(
        points: &[Weighted<S>],
        place: Place<S>,
        limited: Limited<S>,
    ) -> Self {
        let zero = S::zero();
        let (mut cost, mut matrix, mut gradient) = (zero, [[zero; N]; N], [zero; N]);
        let to_frame = place.motor.reverse();
        for &(weight, point) in points {
            let (distances, rows) = P::rows(Place::local(to_frame, point), place.curvature);
            let distances = &distances[..P::COMPONENTS];
            let square = distances.iter().fold(zero, |sum, &r| r.mul_add(r, sum));
            let [value, factor, _] = loss(limited, square);
            cost = weight.mul_add(value, cost);
            let weight = weight * factor;
            for (&distance, row) in distances.iter().zip(&rows) {
                for i in 0..N {
                    let entry = row[i] * weight;
                    gradient[i] = entry.mul_add(distance, gradient[i]);
                    for j in 0..=i {
                        matrix[i][j] = entry.mul_add(row[j], matrix[i][j]);
                    }
                }
            }
        }
        Self {
            cost,
            matrix: symmetric(matrix),
            gradient,
        }
    }

    /// The solution of the equations with their own or another matrix, to which a part of the
    /// diagonal of their own is added.
    fn step(&self, mut matrix: Matrix<S, N>, damping: S) -> Option<[S; N]> {
        let trace = (0..N).fold(S::zero(), |sum, k| sum + self.matrix[k][k]);
        // Unknowns on which nothing depends stay.
        let least = trace * S::epsilon() * S::epsilon();
        for (k, row) in matrix.iter_mut().enumerate() {
            row[k] += damping * self.matrix[k][k].max(least) + least;
        }
        solve(matrix, self.gradient.map(|slope| -slope))
    }

    fn form(&self, step: [S; N]) -> S {
        let rows = self.matrix.iter().zip(step);
        rows.fold(S::zero(), |sum, (row, x)| {
            let product = row
                .iter()
                .zip(step)
                .fold(S::zero(), |sum, (&a, y)| a.mul_add(y, sum));
            x.mul_add(product, sum)
        })
    }
}

/// Half the second derivatives of `Σ w ρ(r)`, by differences of its slopes. At the least, where
/// these vanish, the change of the frame in which they are taken has no effect.
fn hessian<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: &[Weighted<S>],
    place: Place<S>,
    limited: Limited<S>,
) -> Matrix<S, N> {
    // The cube root of ε, at which central differences are most accurate.
    let size = (S::epsilon().ln() * S::from_ratio(1, 3)).exp();
    let slopes = |unknown: usize, size: S| {
        let mut step = [S::zero(); N];
        step[unknown] = size;
        Equations::<S, N>::at::<P>(points, place.moved(&P::step(step)), limited).gradient
    };
    let rows: Matrix<S, N> = core::array::from_fn(|unknown| {
        let (ahead, behind) = (slopes(unknown, size), slopes(unknown, -size));
        core::array::from_fn(|k| (ahead[k] - behind[k]) / (size + size))
    });
    let half = S::from_ratio(1, 2);
    core::array::from_fn(|i| core::array::from_fn(|j| (rows[i][j] + rows[j][i]) * half))
}
