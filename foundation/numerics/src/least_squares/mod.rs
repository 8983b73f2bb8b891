//! Nonlinear least squares by the method of Levenberg and Marquardt.
//!
//! A [`Problem`] says how its residuals depend on its unknowns; [`minimise`] makes the sum of their
//! squares, or of a [`Loss`] of them, least. The unknowns need not be numbers: a state may hold
//! motors, and a step is a change of it in coordinates of its tangent space.
//!
//! The method is that of K. Levenberg, "A method for the solution of certain non-linear problems in
//! least squares", 1944, and D. W. Marquardt, "An algorithm for least-squares estimation of
//! nonlinear parameters", 1963, with the damping of H. B. Nielsen, "Damping parameter in
//! Marquardt's method", 1999. Where equations have a form of their own, [`Search`] takes the same
//! damped steps with any solver, a [`Descent`].

mod covariance;
mod curvature;
mod descent;
mod equations;
mod loss;
mod region;

pub use covariance::Covariance;
pub use descent::{Attempt, Damping, Descended, Descent, Outcome, Search};
pub use equations::{Columns, Equations};
pub use loss::Loss;
pub use region::{Region, region_factor};

/// A sum of squares to make least.
pub trait Problem {
    /// A place where the residuals can be evaluated: numbers, motors, or both.
    type State: Clone;

    /// The unknowns of a step.
    fn columns(&self) -> Columns;

    /// Adds all residuals at a state, with their derivatives by the unknowns of a step at the step
    /// 0, in the same order at every call. `None` where a residual does not exist, as for a point
    /// behind a camera: a step to such a state is refused.
    fn evaluate(&self, state: &Self::State, equations: &mut Equations) -> Option<()>;

    /// The state after a step, which has one number for each column. `None` where there is no such
    /// state.
    fn stepped(&self, state: &Self::State, step: &[f64]) -> Option<Self::State>;
}

/// How a minimum is searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The greatest number of steps that are tried.
    pub steps: usize,
    /// The search ends with a step that changes the residuals by no more than this part of their
    /// root mean square, as it would be without damping…
    pub relative_tolerance: f64,
    /// …or whose change of the residuals has no greater root mean square than this.
    pub absolute_tolerance: f64,
    /// How residuals count.
    pub loss: Loss,
}

impl Default for Options {
    /// 100 steps, 1e-9, 1e-11, and squares.
    fn default() -> Self {
        Self {
            steps: 100,
            relative_tolerance: 1e-9,
            absolute_tolerance: 1e-11,
            loss: Loss::Squares,
        }
    }
}

/// A minimum.
#[derive(Clone, Debug)]
pub struct Minimum<State> {
    /// Where it is.
    pub state: State,
    /// How many steps were tried.
    pub steps: usize,
    /// The sum of the losses there; for [`Loss::Squares`] the sum of the squares of the residuals.
    pub cost: f64,
    /// The number of residuals, each component counted.
    pub residuals: usize,
    /// The number of unknowns.
    pub unknowns: usize,
    equations: Equations,
}

impl<State> Minimum<State> {
    /// The root mean square of the components of the residuals: the root of cost over number.
    #[must_use]
    pub fn root_mean_square(&self) -> f64 {
        (self.cost / self.residuals as f64).sqrt()
    }

    /// The estimated variance of a component of a residual, `cost / (residuals − unknowns)`. `None`
    /// where there are no more residuals than unknowns.
    #[must_use]
    pub fn variance(&self) -> Option<f64> {
        let redundancy = self.residuals.checked_sub(self.unknowns)?;
        (redundancy > 0).then(|| self.cost / redundancy as f64)
    }

    /// The covariance of the unknowns, to first order, for independent errors of the residuals'
    /// components with a variance: `variance · (JᵀWJ)⁻¹`. `None` where the residuals do not
    /// determine the unknowns.
    #[must_use]
    pub fn covariance(&self, variance: f64) -> Option<Covariance> {
        self.equations.covariance(variance).ok()
    }

    /// The covariance of the shared unknowns for a problem whose loss is squares, where the valley
    /// of the cost bends within a standard deviation: that of the normal distribution with a
    /// [`Region`] for 95 % of all errors. Errors of the residuals, drawn in their tangent space,
    /// are followed to the unknowns that bring the residuals there, with the groups that make the
    /// cost the least; the second moments of these about the minimum are scaled so that 95 % are
    /// within the region. It is [`covariance`](Self::covariance) where the residuals are as good as
    /// linear, and for the groups.
    ///
    /// The draws are the same at every call, and are followed in parallel. `None` where the
    /// residuals do not determine the unknowns, do not exist about the minimum, or let errors leave
    /// an ellipsoid by more than five times its size to first order: the minimum then is a hollow
    /// in a wide valley.
    #[must_use]
    pub fn curved_covariance<P: Problem<State = State> + Sync>(
        &self,
        problem: &P,
        variance: f64,
        region: Region,
    ) -> Option<Covariance>
    where
        State: Clone + Sync,
    {
        /// Steps of the groups after one of the shared unknowns.
        const RELAXATIONS: usize = 4;
        /// What is left of the sum of squares after these, in variances.
        const REST: f64 = 1e-3;
        let first = self.covariance(variance)?;
        let mut equations = self.equations.keeping();
        evaluate(problem, &self.state, &mut equations)?;
        let [shared, groups] = equations.parts();
        if shared == 0 {
            return Some(first);
        }
        let relaxations = if groups > 0 { RELAXATIONS } else { 0 };
        let start = equations.kept_residuals().to_vec();
        let following = equations.following()?;
        let linear = (start.as_slice(), &following.jacobian);
        let after_step = |equations: &mut Equations, step: &[f64]| {
            let mut state = problem.stepped(&self.state, &following.step(step))?;
            evaluate(problem, &state, equations)?;
            for _ in 0..relaxations {
                let (step, fall) = equations.step_of_groups()?;
                if fall <= REST * variance {
                    break;
                }
                state = problem.stepped(&state, &step)?;
                evaluate(problem, &state, equations)?;
            }
            Some(equations.kept_residuals().to_vec())
        };
        curvature::curved(&first, variance, region, linear, || {
            let mut equations = equations.clone();
            move |step: &[f64]| after_step(&mut equations, step)
        })
    }

    /// Where there is no [`covariance`](Self::covariance), an unknown that the residuals do not
    /// determine beside the others: the first of those that depend on each other, with all groups
    /// before the shared unknowns, to show a dependence.
    #[must_use]
    pub fn undetermined(&self) -> Option<usize> {
        self.equations.covariance(1.0).err()
    }
}

/// Why there is no minimum.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LeastSquaresError {
    /// The residuals do not exist, or are not finite, where the search begins.
    #[error("the residuals do not exist where the search for the least squares begins")]
    Start,
    /// There are fewer residuals than unknowns.
    #[error("{residuals} residuals do not determine {unknowns} unknowns")]
    TooFewResiduals {
        /// The components of all residuals.
        residuals: usize,
        /// The unknowns.
        unknowns: usize,
    },
    /// The search ended before it came to a minimum.
    #[error(
        "the least squares did not converge in {steps} steps: \
         the root mean square of the residuals is {root_mean_square}"
    )]
    NotConverged {
        /// How many steps were tried.
        steps: usize,
        /// The root mean square of the residuals at the end.
        root_mean_square: f64,
    },
}

const DAMPING: Damping = Damping {
    first: 1e-4,
    least: 1e-15,
    greatest: 1e16,
};

/// Searches a minimum from a state on.
///
/// Each step δ solves `(JᵀWJ + μ D) δ = −JᵀWr` with the derivatives J, the weights W of the loss, D
/// the diagonal of `JᵀWJ`, and a damping μ that falls while the steps succeed. The result does not
/// depend on the units of the unknowns. It is a local minimum: which one depends on the start.
///
/// ```
/// use ga_numerics::least_squares::{Columns, Equations, Problem, Options, minimise};
///
/// /// A circle through points: centre and radius.
/// struct Circle([[f64; 2]; 4]);
///
/// impl Problem for Circle {
///     type State = [f64; 3];
///
///     fn columns(&self) -> Columns {
///         Columns::dense(3)
///     }
///
///     fn evaluate(&self, [x, y, radius]: &[f64; 3], equations: &mut Equations) -> Option<()> {
///         for point in self.0 {
///             let [dx, dy] = [point[0] - x, point[1] - y];
///             let distance = dx.hypot(dy);
///             let derivatives = [(0, [-dx / distance]), (1, [-dy / distance]), (2, [-1.0])];
///             equations.add([distance - radius], &derivatives);
///         }
///         Some(())
///     }
///
///     fn stepped(&self, state: &[f64; 3], step: &[f64]) -> Option<[f64; 3]> {
///         Some([0, 1, 2].map(|k| state[k] + step[k]))
///     }
/// }
///
/// let circle = Circle([[3.0, 1.0], [1.0, 3.0], [-1.0, 1.0], [1.0, -1.0]]);
/// let minimum = minimise(&circle, [0.5, 0.0, 1.0], &Options::default())?;
/// assert!((minimum.state[0] - 1.0).abs() < 1e-12 && (minimum.state[2] - 2.0).abs() < 1e-12);
/// # Ok::<(), ga_numerics::least_squares::LeastSquaresError>(())
/// ```
///
/// # Errors
///
/// [`LeastSquaresError`]; there is no result that has not converged.
pub fn minimise<P: Problem>(
    problem: &P,
    start: P::State,
    options: &Options,
) -> Result<Minimum<P::State>, LeastSquaresError> {
    let mut equations = Equations::new(problem.columns(), options.loss);
    evaluate(problem, &start, &mut equations).ok_or(LeastSquaresError::Start)?;
    let (residuals, unknowns) = (equations.residuals(), equations.unknowns());
    if residuals < unknowns {
        let error = LeastSquaresError::TooFewResiduals {
            residuals,
            unknowns,
        };
        return Err(error);
    }
    let cost = equations.cost();
    let mut descent = Minimising {
        problem,
        options,
        state: start,
        next: None,
        trial: equations.clone(),
        equations,
    };
    let found = match unknowns == 0 || cost == 0.0 {
        true => Descended {
            steps: 0,
            has_converged: true,
        },
        false => Search::new(cost, DAMPING).run(&mut descent, options.steps),
    };
    let minimum = Minimum {
        state: descent.state,
        steps: found.steps,
        cost: descent.equations.cost(),
        residuals,
        unknowns,
        equations: descent.equations,
    };
    if found.has_converged {
        return Ok(minimum);
    }
    Err(LeastSquaresError::NotConverged {
        steps: found.steps,
        root_mean_square: minimum.root_mean_square(),
    })
}

/// The descent of a problem with its own equations.
struct Minimising<'a, P: Problem> {
    problem: &'a P,
    options: &'a Options,
    state: P::State,
    next: Option<P::State>,
    equations: Equations,
    trial: Equations,
}

impl<P: Problem> Descent for Minimising<'_, P> {
    fn attempt(&mut self, damping: f64) -> Attempt {
        self.next = None;
        let Some(step) = self.equations.solve(damping) else {
            return Attempt::NONE;
        };
        self.next = self
            .problem
            .stepped(&self.state, &step.values)
            .filter(|next| evaluate(self.problem, next, &mut self.trial).is_some());
        let cost = match self.next {
            Some(_) => self.trial.cost(),
            None => f64::INFINITY,
        };
        let residuals = self.equations.residuals() as f64;
        let least_change = (self.options.relative_tolerance.powi(2) * self.equations.cost())
            .max(self.options.absolute_tolerance.powi(2) * residuals);
        Attempt {
            size: step.size,
            predicted: step.predicted,
            is_small: cost == 0.0 || step.size * (1.0 + damping).powi(2) <= least_change,
            cost,
        }
    }

    fn accept(&mut self) {
        if let Some(next) = self.next.take() {
            self.state = next;
            std::mem::swap(&mut self.equations, &mut self.trial);
        }
    }
}

/// The equations at a state, or `None` where its residuals or derivatives are not finite.
fn evaluate<P: Problem>(problem: &P, state: &P::State, equations: &mut Equations) -> Option<()> {
    equations.clear();
    problem.evaluate(state, equations)?;
    equations.is_finite().then_some(())
}
