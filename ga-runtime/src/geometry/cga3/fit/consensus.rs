//! Primitives with which most points agree, from random samples.

use alloc::vec::Vec;

use super::random::SplitMix64;
use super::refinement::refine;
use super::result::Located;
use super::search::cloud_of;
use super::settings::RobustSettings;
use super::shape::Shape;
use crate::geometry::FitError;
use crate::scalar::Real;
use crate::vga3::Vector;

/// The greatest number of steps of the search for the primitive of a sample, and of one
/// improvement.
const STEPS: usize = 20;

/// The indices of the points that are nearer than a threshold.
pub(super) fn agreeing<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: &[Vector<S>],
    located: &Located<S>,
    threshold: S,
) -> Vec<usize> {
    let is_near = |&k: &usize| {
        located
            .residual::<P, N>(points[k])
            .abs()
            .less_than(threshold)
    };
    (0..points.len()).filter(is_near).collect()
}

/// The primitive of least cost, and the number of samples drawn.
pub(super) fn best_of_samples<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: &[Vector<S>],
    settings: &RobustSettings<S>,
) -> Result<(Located<S>, usize), FitError<S>> {
    let (found, needed) = (points.len(), P::NEEDED);
    if found < needed {
        return Err(FitError::TooFewPoints { found, needed });
    }
    let mut random = SplitMix64::new(settings.seed);
    let mut order: Vec<usize> = (0..found).collect();
    let mut best: Option<Rated<S>> = None;
    let mut drawn = 0;
    while drawn < settings.samples {
        drawn += 1;
        random.draw(&mut order, needed);
        for located in through::<P, S, N>(points, &order[..needed]) {
            let limit = best.as_ref().map(|best| best.cost);
            let Some(rated) = Rated::of::<P, N>(points, located, settings.threshold, limit) else {
                continue;
            };
            best = Some(improved::<P, S, N>(points, rated, settings.threshold));
        }
        if let Some(best) = &best
            && best.is_sure(drawn, found, needed, settings.confidence)
        {
            break;
        }
    }
    match best {
        Some(best) => Ok((best.located, drawn)),
        None => Err(FitError::NoConsensus { found: 0, needed }),
    }
}

/// The primitives through the points of a sample; none for a degenerate one.
fn through<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: &[Vector<S>],
    sample: &[usize],
) -> Vec<Located<S>> {
    let chosen = sample.iter().map(|&k| (S::one(), points[k]));
    let Ok(cloud) = cloud_of::<P, S, N>(chosen) else {
        return Vec::new();
    };
    let starts = P::starts(&cloud).unwrap_or_default();
    let near = |start| {
        let found = refine::<P, S, N>(&cloud.points, cloud.total, start, None, STEPS);
        Located::new(&cloud, found.place)
    };
    starts.into_iter().map(near).collect()
}

/// A primitive, and how well the points agree with it.
struct Rated<S> {
    located: Located<S>,
    cost: S,
    inliers: usize,
}

impl<S: Real<Mask = bool>> Rated<S> {
    /// `None` as soon as the cost is not below the limit.
    fn of<P: Shape<S, N>, const N: usize>(
        points: &[Vector<S>],
        located: Located<S>,
        threshold: S,
        limit: Option<S>,
    ) -> Option<Self> {
        let (mut cost, mut inliers) = (S::zero(), 0);
        for &point in points {
            // In thresholds, so that squares stay in range. What is not a number does not agree.
            let distance = located.residual::<P, N>(point).abs() / threshold;
            if distance.less_than(S::one()) {
                cost = distance.mul_add(distance, cost);
                inliers += 1;
            } else {
                cost += S::one();
            }
            if limit.is_some_and(|limit| limit.less_or_equal(cost)) {
                return None;
            }
        }
        Some(Self {
            located,
            cost,
            inliers,
        })
    }

    /// Whether a sample without gross errors was drawn with the confidence, if other points agree
    /// as often as these.
    fn is_sure(&self, drawn: usize, count: usize, sample: usize, confidence: S) -> bool {
        let share = S::from_ratio(self.inliers as i64, count as i64);
        let good = (0..sample).fold(S::one(), |product, _| product * share);
        let rest = S::one() - good;
        if !S::zero().less_than(rest) {
            return true;
        }
        // Logarithms of probabilities: both are negative.
        let unsure = (S::one() - confidence).ln();
        (S::from_integer(drawn as i64) * rest.ln()).less_or_equal(unsure)
    }
}

/// A primitive after least squares over the points that agree with it, where that is better.
fn improved<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: &[Vector<S>],
    mut best: Rated<S>,
    threshold: S,
) -> Rated<S> {
    const ROUNDS: usize = 3;
    for _ in 0..ROUNDS {
        let inliers = agreeing::<P, S, N>(points, &best.located, threshold);
        let Ok(cloud) = cloud_of::<P, S, N>(inliers.iter().map(|&k| (S::one(), points[k]))) else {
            break;
        };
        let start = best.located.seen_from(&cloud);
        let found = refine::<P, S, N>(&cloud.points, cloud.total, start, None, STEPS);
        let located = Located::new(&cloud, found.place);
        match Rated::of::<P, N>(points, located, threshold, Some(best.cost)) {
            Some(better) => best = better,
            None => break,
        }
    }
    best
}
