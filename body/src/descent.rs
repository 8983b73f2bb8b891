//! The least cost near a state, by damped Gauss–Newton steps on the equations of a chain.

use crate::normal::Normal;
use ga_numerics::least_squares::{self, Attempt, Damping, Descent};
use nalgebra_035::{Cholesky, DVector};

use super::branched;
use super::chain::{Chain, State};

const DAMPING: Damping = Damping {
    first: 1e-3,
    least: 1e-9,
    greatest: 1e9,
};

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

/// Descends from a state. `None` where the start, or a state on the way, has no equations.
pub(super) fn descend<C: Cost>(
    of: &C,
    start: State,
    search: Search,
    normal: &mut Normal,
) -> Option<Found> {
    of.linearise(&start, normal)?;
    let mut descent = Descending {
        of,
        tolerance: search.tolerance,
        state: start,
        next: None,
        normal,
        has_equations: true,
    };
    let mut found = least_squares::Search::new(descent.normal.cost, DAMPING);
    found.run(&mut descent, search.steps);
    descent.has_equations.then(|| Found {
        state: descent.state,
        cost: found.cost(),
    })
}

struct Descending<'a, C> {
    of: &'a C,
    tolerance: f64,
    state: State,
    next: Option<State>,
    /// The equations at the state.
    normal: &'a mut Normal,
    has_equations: bool,
}

impl<C: Cost> Descent for Descending<'_, C> {
    fn attempt(&mut self, damping: f64) -> Attempt {
        self.next = None;
        if !self.has_equations {
            return Attempt {
                is_small: true,
                ..Attempt::NONE
            };
        }
        let chain = self.of.chain();
        let Some(step) = solve(chain, self.normal, damping) else {
            return Attempt::NONE;
        };
        let promise = -self.normal.gradient.dot(&step);
        let diagonal = self.normal.matrix.diagonal();
        let damped: f64 = diagonal.iter().zip(&step).map(|(d, x)| d * x * x).sum();
        self.next = chain.stepped(&self.state, step.as_slice());
        let cost = self.next.as_ref().and_then(|next| self.of.cost(next));
        Attempt {
            size: step.norm(),
            predicted: promise + damping * damped,
            is_small: promise <= self.tolerance,
            cost: cost.unwrap_or(f64::INFINITY),
        }
    }

    fn accept(&mut self) {
        if let Some(next) = self.next.take() {
            self.has_equations = self.of.linearise(&next, self.normal).is_some();
            self.state = next;
        }
    }
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
