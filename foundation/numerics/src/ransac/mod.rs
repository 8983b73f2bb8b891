//! Random sample consensus: models that most observations agree with, in the presence of gross
//! errors.
//!
//! M. A. Fischler and R. C. Bolles, "Random sample consensus: a paradigm for model fitting with
//! applications to image analysis and automated cartography", Communications of the ACM 24, 1981.
//! Models are compared by the cost of P. H. S. Torr and A. Zisserman, "MLESAC: a new robust
//! estimator with application to estimating image geometry", Computer Vision and Image
//! Understanding 78, 2000: the sum of the squared errors, each cut off at the square of the
//! threshold.

mod selection;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

pub use selection::SelectedNoise;

/// Observations, and the models that a few of them determine.
pub trait Consensus {
    /// What explains observations.
    type Model: Clone;

    /// How many observations determine a model, up to a finite number of solutions.
    const SAMPLE: usize;

    /// The number of observations.
    fn count(&self) -> usize;

    /// Adds the models that the observations of a sample determine; none for a degenerate sample.
    fn fit(&self, sample: &[usize], models: &mut Vec<Self::Model>);

    /// The squared error of an observation under a model, in the squared unit of the threshold.
    fn squared_error(&self, model: &Self::Model, observation: usize) -> f64;
}

/// How models are searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// Observations with a smaller error agree with a model.
    pub threshold: f64,
    /// The probability, below 1, with which a sample without gross errors is to be drawn.
    pub confidence: f64,
    /// The least number of samples, however many observations agree. More samples offer more
    /// starts for a refinement.
    pub least_samples: usize,
    /// The greatest number of samples.
    pub samples: usize,
    /// Equal seeds draw equal samples on every machine, and give equal results on one machine.
    pub seed: u64,
}

/// How the pose of points is searched, some of which may be gross errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseOptions {
    /// Points that are nearer than this to where a pose takes them, or to the pixel at which it
    /// shows them, agree with it; `None` where none of them is wrong, and all count.
    pub threshold: Option<f64>,
    /// The greatest number of random samples.
    pub samples: usize,
    /// The seed of the random samples. Equal seeds give equal results.
    pub seed: u64,
}

impl Default for PoseOptions {
    /// All points count; at most 2000 samples, seed 1.
    fn default() -> Self {
        Self {
            threshold: None,
            samples: 2000,
            seed: 1,
        }
    }
}

/// A model, and how well it explains the observations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<Model> {
    /// The model.
    pub model: Model,
    /// The sum of the squared errors, each at most the square of the threshold.
    pub cost: f64,
    /// How many observations agree.
    pub inliers: usize,
}

impl Search {
    /// The models of least cost from random samples, at most `keep` of them, the best first. Empty
    /// where there are fewer observations than a sample needs, or no sample determines a model.
    ///
    /// ```
    /// use ga_numerics::ransac::{Consensus, Search};
    ///
    /// /// The number that most of the numbers are close to.
    /// struct Level([f64; 6]);
    ///
    /// impl Consensus for Level {
    ///     type Model = f64;
    ///     const SAMPLE: usize = 1;
    ///
    ///     fn count(&self) -> usize {
    ///         self.0.len()
    ///     }
    ///
    ///     fn fit(&self, sample: &[usize], models: &mut Vec<f64>) {
    ///         models.push(self.0[sample[0]]);
    ///     }
    ///
    ///     fn squared_error(&self, level: &f64, observation: usize) -> f64 {
    ///         (self.0[observation] - level).powi(2)
    ///     }
    /// }
    ///
    /// let search = Search {
    ///     threshold: 0.5,
    ///     confidence: 0.999,
    ///     least_samples: 1,
    ///     samples: 100,
    ///     seed: 1,
    /// };
    /// let found = search.run(&Level([3.0, 9.0, 3.1, -4.0, 2.9, 3.05]), 1);
    /// assert_eq!(found[0].inliers, 4);
    /// assert!((found[0].model - 3.0).abs() <= 0.1);
    /// ```
    #[must_use]
    pub fn run<C: Consensus>(&self, problem: &C, keep: usize) -> Vec<Candidate<C::Model>> {
        let count = problem.count();
        let mut best: Vec<Candidate<C::Model>> = Vec::with_capacity(keep + 1);
        if count < C::SAMPLE || keep == 0 {
            return best;
        }
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        let mut order: Vec<usize> = (0..count).collect();
        let mut models = Vec::new();
        let (mut drawn, mut needed) = (0, self.samples);
        while drawn < needed {
            drawn += 1;
            draw(&mut order, C::SAMPLE, &mut random);
            models.clear();
            problem.fit(&order[..C::SAMPLE], &mut models);
            for model in models.drain(..) {
                let limit = match best.last() {
                    Some(last) if best.len() == keep => last.cost,
                    _ => f64::INFINITY,
                };
                let Some(candidate) = self.rate(problem, model, limit) else {
                    continue;
                };
                let place = best.partition_point(|other| other.cost <= candidate.cost);
                best.insert(place, candidate);
                best.truncate(keep);
                if place == 0 {
                    needed = self
                        .samples
                        .min(self.needed(best[0].inliers, count, C::SAMPLE));
                }
            }
        }
        best
    }

    /// Which observations agree with a model, rising.
    #[must_use]
    pub fn inliers<C: Consensus>(&self, problem: &C, model: &C::Model) -> Vec<usize> {
        let limit = self.threshold * self.threshold;
        let agrees = |&index: &usize| problem.squared_error(model, index) < limit;
        (0..problem.count()).filter(agrees).collect()
    }

    /// A model with its cost, or `None` as soon as that is not below the limit.
    pub fn rate<C: Consensus>(
        &self,
        problem: &C,
        model: C::Model,
        limit: f64,
    ) -> Option<Candidate<C::Model>> {
        let cut = self.threshold * self.threshold;
        let (mut cost, mut inliers) = (0.0, 0);
        for index in 0..problem.count() {
            let error = problem.squared_error(&model, index);
            // An error that is not a number does not agree.
            if error < cut {
                cost += error;
                inliers += 1;
            } else {
                cost += cut;
            }
            if cost >= limit {
                return None;
            }
        }
        Some(Candidate {
            model,
            cost,
            inliers,
        })
    }

    /// How many samples are needed for the confidence, if the others agree as often as these.
    fn needed(&self, inliers: usize, count: usize, sample: usize) -> usize {
        let good = (inliers as f64 / count as f64).powi(sample as i32);
        // Logarithms of probabilities, at most 0: −∞ / −∞ cannot occur, since the confidence is
        // below 1.
        let samples = (1.0 - self.confidence).ln() / (-good).ln_1p();
        if samples.is_finite() {
            (samples.ceil() as usize).max(self.least_samples)
        } else {
            self.samples
        }
    }
}

/// Puts a random sample in front, each with the same probability.
fn draw(order: &mut [usize], sample: usize, random: &mut ChaCha8Rng) {
    for place in 0..sample {
        let left = (order.len() - place) as u64;
        // The high half of the product is uniform up to 2⁻⁶⁴ times the number of observations.
        let offset = (u128::from(random.next_u64()) * u128::from(left)) >> 64;
        order.swap(place, place + offset as usize);
    }
}
