//! How likely a pose is for what the views show, and the normal equations of a step.

use crate::BodyError;
use crate::normal::{Normal, PointError};
use ga_runtime::vga3::Vector;

use super::chain::{Chain, State};
use super::descent::Cost;
use super::{JointPixel, Observation};
use ga_camera::Camera;
use ga_numerics::least_squares::Loss;

/// The distance from its pixel, in standard deviations, from which on a point counts less. One in
/// ninety is as far away by Gaussian noise.
pub const OUTLIER: f64 = 3.0;

/// The likelihood of the poses of a body in front of cameras.
#[derive(Clone, Debug)]
pub(super) struct Likelihood<'a> {
    pub(super) chain: Chain<'a>,
    pub(super) cameras: &'a [Camera],
    pub(super) loss: Loss,
    /// How much it counts that joints are near the means of their rotations.
    pub(super) rest: f64,
}

impl Likelihood<'_> {
    /// The cost of a state; `None` where a camera does not see a point that it observes.
    pub(super) fn cost(&self, state: &State, observation: &Observation) -> Option<f64> {
        let places = self.chain.places(state);
        let mut cost = self.prior_cost(state);
        for (camera, pixels) in self.cameras.iter().zip(&observation.views) {
            for (place, pixel) in places.points.iter().zip(pixels) {
                let Some(pixel) = pixel else { continue };
                let found = camera.project((*place).into()).ok()?;
                cost += self.loss.of(squared(error_of(found, pixel))).0;
            }
        }
        cost.is_finite().then_some(cost)
    }

    /// The equations of a step from a state; `None` where [`cost`](Self::cost) is.
    pub(super) fn linearise(
        &self,
        state: &State,
        observation: &Observation,
        normal: &mut Normal,
    ) -> Option<()> {
        normal.cost = self.prior_cost(state);
        normal.matrix.fill(0.0);
        normal.gradient.fill(0.0);
        let places = self.chain.places(state);
        for (point, place) in places.points.iter().enumerate() {
            let mut error = PointError::default();
            let mut is_seen = false;
            for (camera, pixels) in self.cameras.iter().zip(&observation.views) {
                let Some(pixel) = &pixels[point] else {
                    continue;
                };
                is_seen = true;
                let seen = camera.project_with_derivatives((*place).into()).ok()?;
                let residual = error_of(seen.pixel, pixel);
                let (loss, weight) = self.loss.of(squared(residual));
                normal.cost += loss;
                for (row, value) in seen.by_point.iter().zip(residual) {
                    let row = Vector::from(*row) / pixel.deviation;
                    error.gradient += row * (weight * value);
                    for (line, part) in error.matrix.iter_mut().zip(row.coordinates()) {
                        *line += row * (weight * part);
                    }
                }
            }
            if is_seen {
                normal.add(&places, &self.chain, point, &error);
            }
        }
        self.add_prior(state, normal);
        normal.cost.is_finite().then_some(())
    }

    /// Which camera does not see a point that it observes, in a state without a cost.
    pub(super) fn unseen(&self, state: &State, observation: &Observation) -> BodyError {
        let places = self.chain.places(state);
        for (view, (camera, pixels)) in self.cameras.iter().zip(&observation.views).enumerate() {
            let points = self.chain.model.points().iter().zip(&places.points);
            for ((point, place), _) in points.zip(pixels).filter(|(_, pixel)| pixel.is_some()) {
                if let Err(error) = camera.project((*place).into()) {
                    return BodyError::of_point(view, &point.name, error);
                }
            }
        }
        BodyError::NoPose
    }

    /// The residuals of joints from the means of their rotations, each with its column and its
    /// derivative.
    pub(super) fn rest_residuals(&self, state: &State, mut add: impl FnMut(usize, f64, f64)) {
        for joint in self.chain.rotating() {
            let slope = self.rest.sqrt() / self.chain.deviations[joint];
            let vector = self.chain.deviation(state, joint);
            let columns = &self.chain.columns[joint];
            for k in 0..columns.count {
                let residual = vector.dot(columns.direction(k)) * slope;
                add(columns.first + k, residual, slope);
            }
        }
    }

    fn prior_cost(&self, state: &State) -> f64 {
        self.rest * self.chain.unusual(state)
    }

    /// Rotations of joints are near their means. That of the whole body is not.
    fn add_prior(&self, state: &State, normal: &mut Normal) {
        // A rotation vector is an eigenvector of its derivatives by rotations.
        self.rest_residuals(state, |row, residual, slope| {
            normal.matrix[(row, row)] += slope * slope;
            normal.gradient[row] += residual * slope;
        });
    }
}

/// The cost of states for an observation.
pub(super) struct Observed<'l, 'a> {
    pub(super) likelihood: &'l Likelihood<'a>,
    pub(super) observation: &'l Observation,
}

impl Cost for Observed<'_, '_> {
    fn chain(&self) -> &Chain<'_> {
        &self.likelihood.chain
    }

    fn cost(&self, state: &State) -> Option<f64> {
        self.likelihood.cost(state, self.observation)
    }

    fn linearise(&self, state: &State, normal: &mut Normal) -> Option<()> {
        self.likelihood.linearise(state, self.observation, normal)
    }
}

/// The squared distances of points from given places in units of `DISTANCE`, beside the rotations
/// of joints from their means.
pub(super) struct Near<'l, 'a> {
    pub(super) likelihood: &'l Likelihood<'a>,
    pub(super) places: &'l [Option<Vector<f64>>],
}

/// A distance in metres that counts as much as a rotation from its mean by a standard deviation.
const DISTANCE: f64 = 1e-3;

impl Cost for Near<'_, '_> {
    fn chain(&self) -> &Chain<'_> {
        &self.likelihood.chain
    }

    fn cost(&self, state: &State) -> Option<f64> {
        let found = self.chain().places(state);
        let pairs = found.points.iter().zip(self.places);
        let squares =
            pairs.filter_map(|(found, place)| Some((*found - (*place)?).length_squared()));
        let cost = squares.sum::<f64>() / (DISTANCE * DISTANCE) + self.likelihood.prior_cost(state);
        cost.is_finite().then_some(cost)
    }

    fn linearise(&self, state: &State, normal: &mut Normal) -> Option<()> {
        normal.cost = self.cost(state)?;
        normal.matrix.fill(0.0);
        normal.gradient.fill(0.0);
        let weight = 1.0 / (DISTANCE * DISTANCE);
        let found = self.chain().places(state);
        for (point, (place, goal)) in found.points.iter().zip(self.places).enumerate() {
            let Some(goal) = goal else { continue };
            let error = PointError::of_distance(*place - *goal, weight);
            normal.add(&found, self.chain(), point, &error);
        }
        self.likelihood.add_prior(state, normal);
        Some(())
    }
}

fn error_of(found: [f64; 2], pixel: &JointPixel) -> [f64; 2] {
    [0, 1].map(|k| (found[k] - pixel.position[k]) / pixel.deviation)
}

fn squared([u, v]: [f64; 2]) -> f64 {
    u * u + v * v
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example;

    /// The cost along each unknown, by central differences.
    fn slopes(cost: &impl Cost, state: &State) -> Vec<f64> {
        const STEP: f64 = 1e-5;
        let chain = cost.chain();
        let at = |k: usize, sign: f64| {
            let mut step = vec![0.0; chain.count];
            step[k] = sign * STEP;
            cost.cost(&chain.stepped(state, &step).unwrap()).unwrap()
        };
        (0..chain.count)
            .map(|k| (at(k, 1.0) - at(k, -1.0)) / (2.0 * STEP))
            .collect()
    }

    fn check(cost: &impl Cost, state: &State) {
        let mut normal = Normal::new(cost.chain().count);
        cost.linearise(state, &mut normal).unwrap();
        let found = cost.cost(state).unwrap();
        assert!((normal.cost - found).abs() < 1e-12 * found);
        let expected = slopes(cost, state);
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (k, expected) in expected.iter().enumerate() {
            let found = 2.0 * normal.gradient[k];
            assert!(
                (found - expected).abs() < 1e-6 * size,
                "{k}: {found} {expected}"
            );
        }
    }

    #[test]
    fn gradients_are_the_slopes_of_the_costs() {
        let model = example::model();
        let cameras = [example::camera(0.0)];
        for loss in [Loss::Squares, Loss::Huber(3.0), Loss::GemanMcClure(40.0)] {
            let likelihood = Likelihood {
                chain: Chain::new(&model),
                cameras: &cameras,
                loss,
                rest: 0.5,
            };
            let state = example::state(&likelihood.chain, 0);
            let places = likelihood.chain.places(&state).points;
            let pixels = places.iter().enumerate().map(|(k, place)| {
                let seen = cameras[0].project((*place).into()).unwrap();
                // One point is not seen, and one is seen far from where it is.
                (k != 2).then(|| JointPixel {
                    position: [seen[0] + 1.5, seen[1] - if k == 3 { 60.0 } else { 0.5 }],
                    deviation: 1.0 + 0.5 * k as f64,
                })
            });
            let observation = Observation {
                views: vec![pixels.collect()],
            };
            let observed = Observed {
                likelihood: &likelihood,
                observation: &observation,
            };
            check(&observed, &state);
            let goals: Vec<_> = places
                .iter()
                .enumerate()
                .map(|(k, place)| (k != 1).then(|| *place + Vector::new(0.01, -0.02, 0.03)))
                .collect();
            let near = Near {
                likelihood: &likelihood,
                places: &goals,
            };
            check(&near, &state);
        }
    }
}
