//! The most likely pose of one frame, by damped Gauss–Newton steps.

use nalgebra_035::{Cholesky, DVector};

use super::Observation;
use super::chain::State;
use super::likelihood::{Likelihood, Normal};

const FIRST_DAMPING: f64 = 1e-3;
const LEAST_DAMPING: f64 = 1e-9;
const GREATEST_DAMPING: f64 = 1e9;
/// The search ends where a step promises to lower the cost by no more than this: the likelihood
/// then is within a thousandth of the greatest.
const TOLERANCE: f64 = 1e-6;

/// A state and its cost.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) state: State,
    pub(super) cost: f64,
}

/// Descends from a state in at most so many steps (K. Levenberg, 1944; D. W. Marquardt, 1963).
/// `None` where a camera does not see the points there.
pub(super) fn descend(
    likelihood: &Likelihood<'_>,
    observation: &Observation,
    start: State,
    steps: usize,
    normal: &mut Normal,
) -> Option<Found> {
    likelihood.linearise(&start, observation, normal)?;
    let mut best = Found {
        state: start,
        cost: normal.cost,
    };
    let mut damping = FIRST_DAMPING;
    for _ in 0..steps {
        let step = solve(normal, damping);
        let promise = step
            .as_ref()
            .map_or(f64::INFINITY, |step| -normal.gradient.dot(step));
        let next = step.and_then(|step| {
            let state = likelihood.chain.stepped(&best.state, step.as_slice())?;
            let cost = likelihood.cost(&state, observation)?;
            Some(Found { state, cost })
        });
        match next {
            Some(next) if next.cost <= best.cost => {
                best = next;
                if promise <= TOLERANCE {
                    break;
                }
                damping = (damping * 0.1).max(LEAST_DAMPING);
                likelihood.linearise(&best.state, observation, normal)?;
            }
            _ if promise <= TOLERANCE || damping >= GREATEST_DAMPING => break,
            _ => damping *= 10.0,
        }
    }
    Some(best)
}

fn solve(normal: &Normal, damping: f64) -> Option<DVector<f64>> {
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
    let step = Cholesky::new(matrix)?.solve(&normal.gradient);
    step.iter().all(|x| x.is_finite()).then(|| -step)
}
