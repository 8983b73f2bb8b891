//! The most likely motion of a stretch of frames, by Gauss–Newton steps of all frames together.

use crate::normal::{Normal, PointError};
use nalgebra_035::{DVector, Matrix3};

use super::super::Observation;
use super::super::chain::{Chain, State};
use super::super::ground::Anchor;
use super::super::likelihood::Likelihood;
use super::covariances::precisions;
use super::differences::{Difference, difference, kinds};
use ga_numerics::banded::frames::{Blocks, Couplings};

/// The greatest number of steps.
const STEPS: usize = 12;
/// How often a step is halved before the search ends.
const HALVINGS: usize = 6;
/// The search ends where a step promises to lower the cost of a frame by no more than this: the
/// likelihood of a frame then is within some thousandths of the greatest.
const TOLERANCE: f64 = 1e-3;

/// The most likely states, from states that are near, with covariances of accelerations from
/// those of the frames by themselves.
pub(super) fn fit(
    likelihood: &Likelihood<'_>,
    observations: &[Observation],
    mut states: Vec<State>,
    single: &[State],
    frames_per_second: f64,
    anchors: &[Vec<Anchor>],
) -> Vec<State> {
    if states.len() < 3 {
        return states;
    }
    let chain = &likelihood.chain;
    let precisions = precisions(chain, single, frames_per_second);
    let mut normal = Normal::new(chain.count);
    for _ in 0..STEPS {
        let linear = linearise(
            likelihood,
            observations,
            anchors,
            &states,
            &precisions,
            &mut normal,
        );
        let Some((couplings, mut step, cost)) = linear else {
            break;
        };
        let gradient = step.clone();
        let Some(factor) = couplings.factor() else {
            break;
        };
        factor.solve(&mut step);
        let promise: f64 = gradient.iter().zip(&step).map(|(a, b)| a.dot(b)).sum();
        let next = (0..HALVINGS).find_map(|halving| {
            let part = -(0.5_f64.powi(halving as i32));
            let next = states
                .iter()
                .zip(&step)
                .map(|(state, step)| chain.stepped(state, (step * part).as_slice()));
            let next = next.collect::<Option<Vec<State>>>()?;
            let found = total_cost(likelihood, observations, anchors, &next, &precisions)?;
            (found <= cost).then_some(next)
        });
        let Some(next) = next else {
            break;
        };
        states = next;
        if promise <= TOLERANCE * states.len() as f64 {
            break;
        }
    }
    states
}

/// The second differences around a frame, with their precisions.
fn differences<'s>(
    chain: &'s Chain<'_>,
    states: &'s [State],
    middle: usize,
    precisions: &'s [Matrix3<f64>],
) -> impl Iterator<Item = (Difference, &'s Matrix3<f64>)> + 's {
    (0..kinds(chain)).filter_map(move |kind| {
        let frames = [&states[middle - 1], &states[middle], &states[middle + 1]];
        Some((difference(chain, frames, kind)?, &precisions[kind]))
    })
}

/// What it costs that held points are elsewhere.
fn anchor_cost(chain: &Chain<'_>, state: &State, anchors: &[Anchor]) -> f64 {
    if anchors.is_empty() {
        return 0.0;
    }
    let places = chain.places(state);
    let squares = anchors.iter().map(|anchor| {
        let way = places.points[anchor.point] - anchor.place;
        way.length_squared() * anchor.weight
    });
    squares.sum()
}

/// Adds that held points should be at their places.
fn add_anchors(chain: &Chain<'_>, state: &State, anchors: &[Anchor], normal: &mut Normal) {
    if anchors.is_empty() {
        return;
    }
    let places = chain.places(state);
    for anchor in anchors {
        let way = places.points[anchor.point] - anchor.place;
        normal.cost += way.length_squared() * anchor.weight;
        let error = PointError::of_distance(way, anchor.weight);
        normal.add(&places, chain, anchor.point, &error);
    }
}

fn total_cost(
    likelihood: &Likelihood<'_>,
    observations: &[Observation],
    anchors: &[Vec<Anchor>],
    states: &[State],
    precisions: &[Matrix3<f64>],
) -> Option<f64> {
    let mut cost = 0.0;
    for (state, observation) in states.iter().zip(observations) {
        cost += likelihood.cost(state, observation)?;
    }
    for (state, anchors) in states.iter().zip(anchors) {
        cost += anchor_cost(&likelihood.chain, state, anchors);
    }
    for middle in 1..states.len() - 1 {
        for (difference, precision) in differences(&likelihood.chain, states, middle, precisions) {
            cost += difference.squared(precision);
        }
    }
    cost.is_finite().then_some(cost)
}

/// The normal equations of all frames, half the gradient, and the cost.
fn linearise(
    likelihood: &Likelihood<'_>,
    observations: &[Observation],
    anchors: &[Vec<Anchor>],
    states: &[State],
    precisions: &[Matrix3<f64>],
    normal: &mut Normal,
) -> Option<(Couplings, Vec<DVector<f64>>, f64)> {
    let count = states.len();
    let mut couplings = Couplings {
        own: Vec::with_capacity(count),
        before: vec![Blocks::new(); count],
        two_before: vec![Blocks::new(); count],
    };
    let (mut gradient, mut cost) = (Vec::with_capacity(count), 0.0);
    for (frame, (state, observation)) in states.iter().zip(observations).enumerate() {
        likelihood.linearise(state, observation, normal)?;
        let anchors = anchors.get(frame).map_or(&[][..], Vec::as_slice);
        add_anchors(&likelihood.chain, state, anchors, normal);
        cost += normal.cost;
        gradient.push(normal.gradient.clone());
        couplings.own.push(normal.matrix.clone());
    }
    for middle in 1..count - 1 {
        for (difference, precision) in differences(&likelihood.chain, states, middle, precisions) {
            cost += difference.squared(precision);
            for frame in 0..3 {
                let index = middle + frame - 1;
                let by_unknowns = difference.gradient(frame, precision);
                for k in 0..difference.size {
                    gradient[index][difference.first + k] += by_unknowns[k];
                }
                let own = difference.block(frame, frame, precision);
                couplings.add_own(index, &own);
                if frame >= 1 {
                    let block = difference.block(frame, frame - 1, precision);
                    couplings.add_before(index, &block);
                }
            }
            let block = difference.block(2, 0, precision);
            couplings.two_before[middle + 1].push(block);
        }
    }
    Some((couplings, gradient, cost))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JointPixel;
    use crate::example;
    use ga_numerics::least_squares::Loss;
    use ga_runtime::vga3::Vector;

    #[test]
    fn the_gradient_of_a_clip_is_the_slope_of_its_cost() {
        const STEP: f64 = 1e-5;
        let model = example::model();
        let cameras = [example::camera(0.0), example::camera(0.5)];
        let likelihood = Likelihood {
            chain: crate::chain::Chain::new(&model),
            cameras: &cameras,
            loss: Loss::Squares,
            rest: 0.5,
        };
        let chain = &likelihood.chain;
        let states: Vec<State> = (0..4).map(|seed| example::state(chain, seed)).collect();
        let pixel = |k: usize| JointPixel {
            position: [300.0 + 10.0 * k as f64, 250.0],
            deviation: 20.0,
        };
        let views = vec![(0..5).map(|k| (k != 3).then(|| pixel(k))).collect(); 2];
        let observations = vec![Observation { views }; 4];
        let held = Anchor {
            point: 2,
            place: Vector::new(0.1, 0.2, 3.0),
            weight: 50.0,
        };
        let anchors = [vec![], vec![held], vec![held], vec![]];
        let precisions: Vec<Matrix3<f64>> = (0..kinds(chain))
            .map(|kind| {
                let axes = Matrix3::from_fn(|row, k| ((7 * kind + 3 * row + 5 * k) as f64).sin());
                axes * axes.transpose() + Matrix3::identity()
            })
            .collect();
        let cost = |states: &[State]| {
            total_cost(&likelihood, &observations, &anchors, states, &precisions).unwrap()
        };
        let mut normal = Normal::new(chain.count);
        let (_, gradient, found) = linearise(
            &likelihood,
            &observations,
            &anchors,
            &states,
            &precisions,
            &mut normal,
        )
        .unwrap();
        assert!((found - cost(&states)).abs() < 1e-12 * found);
        // The second differences alone: the costs of frames do not depend on the precisions.
        let with_times = |factor: f64| {
            let scaled: Vec<Matrix3<f64>> = precisions.iter().map(|p| p * factor).collect();
            total_cost(&likelihood, &observations, &anchors, &states, &scaled).unwrap()
        };
        let frames = with_times(0.0);
        assert!((with_times(2.0) - frames - 2.0 * (found - frames)).abs() < 1e-9 * found);
        let size = gradient.iter().map(|g| g.amax()).fold(0.0, f64::max);
        for frame in 0..4 {
            for k in 0..chain.count {
                let at = |sign: f64| {
                    let mut step = vec![0.0; chain.count];
                    step[k] = sign * STEP;
                    let mut states = states.clone();
                    states[frame] = chain.stepped(&states[frame], &step).unwrap();
                    cost(&states)
                };
                let slope = (at(1.0) - at(-1.0)) / (2.0 * STEP);
                let found = 2.0 * gradient[frame][k];
                assert!(
                    (found - slope).abs() < 1e-6 * size,
                    "{frame} {k}: {found} {slope}"
                );
            }
        }
    }
}
