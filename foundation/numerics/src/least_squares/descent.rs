//! Damped steps: the loop of Levenberg and Marquardt for equations of any form.

/// A cost that steps lower, and the place that they have come to.
///
/// [`minimise`](super::minimise) forms and solves equations of its own. Where equations have a
/// structure that another solver uses, as those of a chain of joints or of a closed curve, this
/// trait is all that a search needs.
pub trait Descent {
    /// Solves the equations of a step for a damping, a positive number: the greater, the shorter
    /// the step and the nearer to the direction of steepest descent. Evaluates the cost after it.
    fn attempt(&mut self, damping: f64) -> Attempt;

    /// Goes where the last attempt ended, and prepares the equations of the next step.
    fn accept(&mut self);
}

/// What a step leads to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attempt {
    /// A measure of its length, in any unit.
    pub size: f64,
    /// By how much its equations say that it lowers the cost.
    pub predicted: f64,
    /// Whether the search ends with it: it would be short without the damping too, or promise no
    /// more than the rounding of the cost.
    pub is_small: bool,
    /// The cost after it; infinite where there is none.
    pub cost: f64,
}

impl Attempt {
    /// Where equations have no solution, or a step leads nowhere.
    pub const NONE: Self = Self {
        size: f64::INFINITY,
        predicted: f64::INFINITY,
        is_small: false,
        cost: f64::INFINITY,
    };
}

/// The damping with which a search begins, and its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damping {
    /// The damping of the first step.
    pub first: f64,
    /// It never falls below this.
    pub least: f64,
    /// Beyond this, the search ends without a minimum.
    pub greatest: f64,
}

/// What became of an attempt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Whether the step was taken.
    pub is_accepted: bool,
    /// Whether the step was [small](Attempt::is_small), so that the search is at its end.
    pub has_converged: bool,
}

/// The end of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Descended {
    /// How many steps were tried.
    pub steps: usize,
    /// Whether it came to a minimum.
    pub has_converged: bool,
}

/// The part of a cost that its rounding errors may reach: residuals of thousandths of a pixel
/// between pixels of hundreds have 11 digits.
const ROUNDING: f64 = 1e-10;

/// A search in progress: the cost, and a damping that falls while steps succeed.
///
/// A step is taken where it lowers the cost. The damping then follows the gain, the ratio of the
/// fall of the cost to what the equations predicted: times `1 − (2 gain − 1)³`, between 1/10 and
/// 2. After a step that is refused it is multiplied by 2, then by 4, by 8 and so on (H. B. Nielsen,
/// "Damping parameter in Marquardt's method", 1999).
///
/// ```
/// use ga_numerics::least_squares::{Attempt, Damping, Descent, Search};
///
/// /// The root of x² = 2 as the least of (x² − 2)².
/// struct Root {
///     x: f64,
///     next: f64,
/// }
///
/// impl Descent for Root {
///     fn attempt(&mut self, damping: f64) -> Attempt {
///         let (residual, slope) = (self.x * self.x - 2.0, 2.0 * self.x);
///         let step = -slope * residual / (slope * slope * (1.0 + damping));
///         self.next = self.x + step;
///         Attempt {
///             size: step.abs(),
///             predicted: step * step * slope * slope * (1.0 + 2.0 * damping),
///             is_small: step.abs() < 1e-12,
///             cost: (self.next * self.next - 2.0).powi(2),
///         }
///     }
///
///     fn accept(&mut self) {
///         self.x = self.next;
///     }
/// }
///
/// let mut root = Root { x: 1.0, next: 1.0 };
/// let damping = Damping { first: 1e-3, least: 1e-12, greatest: 1e12 };
/// let found = Search::new(1.0, damping).run(&mut root, 50);
/// assert!(found.has_converged && (root.x - 2_f64.sqrt()).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    cost: f64,
    damping: f64,
    growth: f64,
    limits: Damping,
    last_size: f64,
}

impl Search {
    /// Begins where the cost is this.
    #[must_use]
    #[inline]
    pub fn new(cost: f64, damping: Damping) -> Self {
        Self {
            cost,
            damping: damping.first,
            growth: 2.0,
            limits: damping,
            last_size: f64::INFINITY,
        }
    }

    /// The cost of the place that the search has come to.
    #[must_use]
    pub fn cost(&self) -> f64 {
        self.cost
    }

    /// Whether the damping has grown beyond its limit, so that no further step helps.
    #[must_use]
    #[inline]
    pub fn is_exhausted(&self) -> bool {
        self.damping.is_nan() || self.damping > self.limits.greatest
    }

    /// Goes on from a place with another cost, which was reached without a step of the search.
    pub fn continue_from(&mut self, cost: f64) {
        (self.cost, self.last_size) = (cost, f64::INFINITY);
    }

    /// Tries one step.
    #[inline]
    pub fn step<D: Descent>(&mut self, descent: &mut D) -> Outcome {
        let attempt = descent.attempt(self.damping);
        let fell = self.cost - attempt.cost;
        let rounding = ROUNDING * self.cost.abs();
        // Near the minimum the change of the cost is lost in rounding, and only the steps show that
        // the search goes on.
        let is_lost = attempt.predicted <= rounding && attempt.size < self.last_size;
        let is_accepted = fell > 0.0 || (is_lost && -fell <= rounding);
        if is_accepted {
            descent.accept();
            self.cost = attempt.cost;
            self.last_size = attempt.size;
            let gain = if is_lost {
                1.0
            } else {
                fell / attempt.predicted
            };
            self.damping *= (1.0 - (2.0 * gain - 1.0).powi(3)).clamp(0.1, 2.0);
            (self.damping, self.growth) = (self.damping.max(self.limits.least), 2.0);
        } else {
            (self.damping, self.growth) = (self.damping * self.growth, 2.0 * self.growth);
        }
        Outcome {
            is_accepted,
            has_converged: attempt.is_small,
        }
    }

    /// Tries steps until one is small, at most this many.
    #[inline]
    pub fn run<D: Descent>(&mut self, descent: &mut D, steps: usize) -> Descended {
        let mut found = Descended {
            steps: 0,
            has_converged: false,
        };
        while !found.has_converged && found.steps < steps && !self.is_exhausted() {
            found.steps += 1;
            found.has_converged = self.step(descent).has_converged;
        }
        found
    }
}
