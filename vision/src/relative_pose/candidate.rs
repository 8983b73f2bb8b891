//! The motions that may explain pairs: local minima of the epipolar distances.

use ga_runtime::cga3::Motor;
use ga_runtime::vga3::Vector;

use super::cheirality::explained;
use super::five_point::five_point;
use super::matrix::EssentialMatrix;
use super::planar;
use super::sampson::{BearingPair, SampsonCost};
use ga_numerics::least_squares::{self, Minimum, minimise};
use ga_numerics::ransac::{Consensus, Search};

/// The least sum of squared Sampson distances over the pairs that agree.
pub(super) struct Settled {
    pub(super) minimum: Minimum<Motor<f64>>,
    pub(super) inliers: Vec<usize>,
    pub(super) selected: Vec<BearingPair>,
}

/// One of the four motions with the essential matrix of a minimum.
pub(super) struct Candidate {
    /// Which minimum.
    pub(super) settled: usize,
    pub(super) motor: Motor<f64>,
    /// For each pair the squared distance in square pixels from what the motion explains with
    /// points in front of both cameras, at most the square of the threshold.
    pub(super) squares: Vec<f64>,
    /// The sum of these.
    pub(super) cost: f64,
    /// How many of the pairs that agree are in front of both cameras.
    pub(super) in_front: usize,
}

impl Candidate {
    fn new(
        settled: usize,
        minimum: &Settled,
        motor: Motor<f64>,
        pairs: &[BearingPair],
        threshold: f64,
    ) -> Self {
        let greatest = threshold * threshold;
        let explained: Vec<_> = pairs.iter().map(|pair| explained(pair, motor)).collect();
        // A distance that is not a number explains nothing.
        let squares = explained
            .iter()
            .map(|one| greatest.min(one.squared_distance));
        let squares: Vec<f64> = squares.collect();
        let agreeing = minimum.inliers.iter();
        Self {
            settled,
            motor,
            cost: squares.iter().sum(),
            squares,
            in_front: agreeing.filter(|&&k| explained[k].is_in_front).count(),
        }
    }
}

/// The angle in radians between the rotations of two motions, and that between their translations.
pub(super) fn angles_between(a: Motor<f64>, b: Motor<f64>) -> [f64; 2] {
    let between = a.rotor() * b.rotor().reverse();
    let directions = [a, b].map(|motor| Vector::from(motor.translator().displacement()));
    [
        between.canonical().to_axis_angle().1,
        directions[0].angle(directions[1]).unwrap_or(0.0),
    ]
}

/// The motions that may explain the pairs, the one that does best first, and the minima that they
/// belong to.
///
/// Minima are searched from the best essential matrices of random samples, and from the motions of
/// the plane with most pairs. All four motions of each count with the distances from what they
/// explain in front of both cameras.
pub(super) fn candidates(pairs: &[BearingPair], search: &Search) -> (Vec<Settled>, Vec<Candidate>) {
    let mut found: Vec<Settled> = Vec::new();
    for start in sampled_starts(pairs, search) {
        add(&mut found, settle(pairs, search, start));
    }
    let cost = |one: &Settled| rate(pairs, search, one.minimum.state).unwrap_or(f64::INFINITY);
    let best = found.iter().min_by(|a, b| cost(a).total_cmp(&cost(b)));
    let plane = best.and_then(|best| planar::motions(&best.selected, search));
    for start in plane.into_iter().flatten() {
        add(&mut found, settle(pairs, search, start));
    }
    let mut candidates: Vec<Candidate> = Vec::new();
    for (index, settled) in found.iter().enumerate() {
        let essential = EssentialMatrix::from_motor(settled.minimum.state);
        let motors = essential.and_then(|essential| essential.motors());
        let new = |motor| Candidate::new(index, settled, motor, pairs, search.threshold);
        candidates.extend(motors.into_iter().flatten().map(new));
    }
    // The sort is stable, so that equal costs keep their order.
    candidates.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    (found, candidates)
}

/// Adds a minimum, unless it is among those found.
fn add(found: &mut Vec<Settled>, settled: Option<Settled>) {
    /// The distance of essential matrices below which they are equal.
    const EQUAL: f64 = 1e-5;
    let Some(new) = settled else { return };
    let motor = new.minimum.state;
    if !(found.iter()).any(|other| are_near(motor, other.minimum.state, EQUAL)) {
        found.push(new);
    }
}

/// Whether two motions have nearly one epipolar geometry: those with one essential matrix may
/// rotate in two ways.
fn are_near(a: Motor<f64>, b: Motor<f64>, limit: f64) -> bool {
    match [a, b].map(EssentialMatrix::from_motor) {
        [Some(a), Some(b)] => a.distance(&b) <= limit,
        _ => false,
    }
}

/// The cost of a motion to random samples.
fn rate(pairs: &[BearingPair], search: &Search, motor: Motor<f64>) -> Option<f64> {
    let essential = EssentialMatrix::from_motor(motor)?;
    let rated = search.rate(&Bearings(pairs), essential, f64::INFINITY)?;
    Some(rated.cost)
}

/// The best essential matrices of random samples, refined with a part of the pairs: the best of
/// those that differ.
fn sampled_starts(pairs: &[BearingPair], search: &Search) -> Vec<Motor<f64>> {
    /// Starts for a first refinement.
    const STARTS: usize = 16;
    /// Pairs that take part in a first refinement.
    const FEW: usize = 300;
    /// Results of it that are refined with all pairs that agree.
    const FINALISTS: usize = 3;
    /// The distance of essential matrices below which they are one.
    const EQUAL: f64 = 1e-3;

    let problem = Bearings(pairs);
    let options = least_squares::Options::default();
    let starts = search
        .run(&problem, STARTS)
        .into_iter()
        .filter_map(|candidate| {
            let agreeing = search.inliers(&problem, &candidate.model);
            let stride = agreeing.len().div_ceil(FEW).max(1);
            let few: Vec<_> = agreeing.iter().step_by(stride).map(|&k| pairs[k]).collect();
            let start = candidate.model.motors()?[0];
            let refined = minimise(&SampsonCost { pairs: &few }, start, &options);
            let motor = refined.map_or(start, |minimum| minimum.state);
            Some((rate(pairs, search, motor)?, motor))
        });
    let mut starts: Vec<_> = starts.collect();
    // The sort is stable, so that equal costs keep the order of the samples.
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut chosen: Vec<Motor<f64>> = Vec::new();
    for (_, motor) in starts {
        if chosen.len() < FINALISTS && !chosen.iter().any(|one| are_near(*one, motor, EQUAL)) {
            chosen.push(motor);
        }
    }
    chosen
}

/// Refines a motion with all pairs that agree, which are collected anew after each search.
fn settle(pairs: &[BearingPair], search: &Search, start: Motor<f64>) -> Option<Settled> {
    /// How often the pairs that agree are collected anew.
    const ROUNDS: usize = 10;
    let problem = Bearings(pairs);
    let mut motor = start;
    let mut last = Vec::new();
    let mut best: Option<(f64, Settled)> = None;
    for _ in 0..ROUNDS {
        let inliers = search.inliers(&problem, &EssentialMatrix::from_motor(motor)?);
        if inliers == last {
            break;
        }
        let selected: Vec<_> = inliers.iter().map(|&k| pairs[k]).collect();
        last.clone_from(&inliers);
        let cost = SampsonCost { pairs: &selected };
        let Ok(minimum) = minimise(&cost, motor, &least_squares::Options::default()) else {
            break;
        };
        motor = minimum.state;
        let Some(cost) = rate(pairs, search, motor) else {
            break;
        };
        let settled = Settled {
            minimum,
            inliers,
            selected,
        };
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, settled));
        }
    }
    best.map(|(_, settled)| settled)
}

struct Bearings<'a>(&'a [BearingPair]);

impl Consensus for Bearings<'_> {
    type Model = EssentialMatrix;

    const SAMPLE: usize = 5;

    fn count(&self) -> usize {
        self.0.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<EssentialMatrix>) {
        let directions = |k: usize| {
            let BearingPair { left, right } = &self.0[sample[k]];
            [left.direction, right.direction]
        };
        models.extend(five_point(&std::array::from_fn(directions)));
    }

    fn squared_error(&self, model: &EssentialMatrix, observation: usize) -> f64 {
        self.0[observation].sampson_distance_by(model).powi(2)
    }
}
