//! The least cost near a state, by damped Gauss–Newton steps.

use crate::normal::Normal;
use nalgebra_035::{Cholesky, DVector};

use super::branched;
use super::chain::{Chain, State};

const FIRST_DAMPING: f64 = 1e-3;
const LEAST_DAMPING: f64 = 1e-9;
const GREATEST_DAMPING: f64 = 1e9;

/// How far a cost is followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search {
    /// The greatest number of steps.
    pub(super) steps: usize,
    /// The search ends where a step promises to lower the cost by no more than this.
    pub(super) tolerance: f64,
}

/// A state and its cost.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) state: State,
    pub(super) cost: f64,
}

/// A cost of states.
pub(super) trait Cost {
    fn chain(&self) -> &Chain<'_>;

    /// `None` where a state has no cost.
    fn cost(&self, state: &State) -> Option<f64>;

    /// The equations of a step from a state; `None` where the cost is.
    fn linearise(&self, state: &State, normal: &mut Normal) -> Option<()>;
}

/// Descends from a state (K. Levenberg, 1944; D. W. Marquardt, 1963). `None` where the start has no
/// cost.
pub(super) fn descend(
    of: &impl Cost,
    start: State,
    search: Search,
    normal: &mut Normal,
) -> Option<Found> {
    of.linearise(&start, normal)?;
    let mut best = Found {
        state: start,
        cost: normal.cost,
    };
    let mut damping = FIRST_DAMPING;
    for _ in 0..search.steps {
        let step = solve(of.chain(), normal, damping);
        let promise = step
            .as_ref()
            .map_or(f64::INFINITY, |step| -normal.gradient.dot(step));
        let next = step.and_then(|step| {
            let state = of.chain().stepped(&best.state, step.as_slice())?;
            let cost = of.cost(&state)?;
            Some(Found { state, cost })
        });
        match next {
            Some(next) if next.cost <= best.cost => {
                best = next;
                if promise <= search.tolerance {
                    break;
                }
                damping = (damping * 0.1).max(LEAST_DAMPING);
                of.linearise(&best.state, normal)?;
            }
            _ if promise <= search.tolerance || damping >= GREATEST_DAMPING => break,
            _ => damping *= 10.0,
        }
    }
    Some(best)
}

/// The logarithm of the determinant of the equations; 0 where they are singular.
pub(super) fn log_determinant(chain: &Chain<'_>, normal: &Normal) -> f64 {
    let mut matrix = normal.matrix.clone();
    for k in 0..matrix.nrows() {
        if matrix[(k, k)] <= 0.0 {
            matrix[(k, k)] = 1.0;
        }
    }
    match &chain.above {
        Some(above) => branched::factor(&mut matrix, above).unwrap_or(0.0),
        None => Cholesky::new(matrix).map_or(0.0, |factor| factor.ln_determinant()),
    }
}

fn solve(chain: &Chain<'_>, normal: &Normal, damping: f64) -> Option<DVector<f64>> {
    let mut matrix = normal.matrix.clone();
    for k in 0..matrix.nrows() {
        let diagonal = matrix[(k, k)];
        // What neither pixels nor rest determine stays as it is.
        matrix[(k, k)] = if diagonal > 0.0 {
            diagonal * (1.0 + damping)
        } else {
            1.0
        };
    }
    let step = match &chain.above {
        Some(above) => {
            branched::factor(&mut matrix, above)?;
            let mut step = normal.gradient.clone();
            branched::solve(&matrix, above, &mut step);
            step
        }
        None => Cholesky::new(matrix)?.solve(&normal.gradient),
    };
    step.iter().all(|x| x.is_finite()).then(|| -step)
}
