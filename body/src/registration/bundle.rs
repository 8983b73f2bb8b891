//! Small rotations, displacements and offsets of all views, with free points.

use ga_camera::Camera;
use ga_camera::triangulation::triangulate_views;
use ga_numerics::least_squares::{Columns, Equations, Loss, Options, Problem, minimise};
use ga_runtime::vga3::Vector;
use nalgebra_035::DMatrix;

use super::motion::{Motion, OFFSET, SIZE, UNKNOWN, all_moved};
use super::options::RegistrationOptions;
use crate::Observation;

/// How many points are used at most, spread over all frames.
const POINTS: usize = 2000;
/// What is farther off than this, in standard deviations, counts less.
const LOSS: f64 = 2.0;
/// The search begins with a loss that is wider by these factors.
const WIDER: [f64; 3] = [8.0, 3.0, 1.0];
/// Over how many frames before and after velocities are taken.
const REACH: usize = 2;
/// Places that may not move: a deviation in metres that is none.
const EXACT: f64 = 1e-6;
/// How much less it counts what the calibration says than what points do, in the search.
const FREE: f64 = 0.1;

/// A pixel with its velocity in pixels a frame.
#[derive(Clone, Copy)]
struct Sight {
    view: usize,
    pixel: [f64; 2],
    velocity: [f64; 2],
    deviation: f64,
}

#[derive(Clone)]
pub(super) struct State {
    motions: Vec<Motion>,
    points: Vec<Vector<f64>>,
}

/// Views, and the points that they show.
#[derive(Clone)]
pub(super) struct Bundle<'a> {
    cameras: &'a [Camera],
    options: &'a RegistrationOptions,
    start: State,
    /// For each point where it is seen.
    sights: Vec<Vec<Sight>>,
    /// For each point which joint it is.
    joints: Vec<usize>,
    /// From the middle of all cameras to each.
    ways: Vec<Vector<f64>>,
}

impl<'a> Bundle<'a> {
    /// Views with motions that are near.
    pub(super) fn new(
        cameras: &'a [Camera],
        motions: &[Motion],
        observations: &[Observation],
        options: &'a RegistrationOptions,
        deviation: f64,
    ) -> Self {
        let placed = all_moved(cameras, motions);
        let (mut joints, mut sights, mut points) = (Vec::new(), Vec::new(), Vec::new());
        for (joint, own, place) in seen_points(&placed, observations, deviation) {
            joints.push(joint);
            sights.push(own);
            points.push(place);
        }
        let middle = cameras.iter().fold(Vector::default(), |sum, camera| {
            sum + Vector::from(camera.centre()) / cameras.len() as f64
        });
        let ways = cameras
            .iter()
            .map(|camera| Vector::from(camera.centre()) - middle);
        Self {
            start: State {
                motions: motions.to_vec(),
                points,
            },
            ways: ways.collect(),
            cameras,
            options,
            sights,
            joints,
        }
    }

    /// The joints that are seen.
    pub(super) fn joints(&self) -> Vec<usize> {
        let mut joints = self.joints.clone();
        joints.sort_unstable();
        joints.dedup();
        joints
    }

    /// The same from other motions, without some joints.
    pub(super) fn without(&self, motions: &[Motion], joints: &[usize]) -> Self {
        let kept = |point: &usize| !joints.contains(&self.joints[*point]);
        let kept: Vec<usize> = (0..self.joints.len()).filter(kept).collect();
        Self {
            start: State {
                motions: motions.to_vec(),
                points: kept.iter().map(|&point| self.start.points[point]).collect(),
            },
            sights: kept
                .iter()
                .map(|&point| self.sights[point].clone())
                .collect(),
            joints: kept.iter().map(|&point| self.joints[point]).collect(),
            ..self.clone()
        }
    }

    /// The most likely motions, from where the search begins or from farther away. `None` where too
    /// few points are seen.
    pub(super) fn adjusted(&self, is_near: bool) -> Option<Vec<Motion>> {
        let mut state = self.start.clone();
        let skipped = if is_near { WIDER.len() - 1 } else { 0 };
        for &wider in &WIDER[skipped..] {
            state = minimise(self, state, &options(wider)).ok()?.state;
        }
        Some(state.motions)
    }

    /// The most likely motions from where the search begins, and the covariance of all their
    /// coordinates for errors that are independent.
    pub(super) fn adjusted_near(&self) -> Option<(Vec<Motion>, DMatrix<f64>)> {
        let found = minimise(self, self.start.clone(), &options(1.0)).ok()?;
        let covariance = found.covariance(1.0)?;
        let count = SIZE * self.cameras.len();
        let covariance = DMatrix::from_fn(count, count, |i, j| covariance.shared(i, j));
        Some((found.state.motions, covariance))
    }
}

fn options(wider: f64) -> Options {
    Options {
        steps: 200,
        relative_tolerance: 1e-3,
        absolute_tolerance: 1e-4,
        loss: Loss::Cauchy(wider * LOSS),
    }
}

/// The points that two views or more show, as far as rays meet in front of all.
fn seen_points(
    cameras: &[Camera],
    observations: &[Observation],
    deviation: f64,
) -> Vec<(usize, Vec<Sight>, Vector<f64>)> {
    let joints = observations.first().map_or(0, |first| {
        first.views.iter().map(Vec::len).max().unwrap_or(0)
    });
    let every = (joints * observations.len()).div_ceil(POINTS).max(1);
    let mut points = Vec::new();
    for (frame, observation) in observations.iter().enumerate() {
        // Each joint in turn.
        for joint in (0..joints).filter(|joint| (joint + frame) % every == 0) {
            let own: Vec<Sight> = (0..cameras.len())
                .filter_map(|view| sight(observations, observation, frame, view, joint, deviation))
                .collect();
            let seen: Vec<Camera> = own.iter().map(|sight| cameras[sight.view]).collect();
            let pixels: Vec<[f64; 2]> = own.iter().map(|sight| sight.pixel).collect();
            if let Ok(found) = triangulate_views(&seen, &pixels) {
                points.push((joint, own, found.position.into()));
            }
        }
    }
    points
}

fn sight(
    observations: &[Observation],
    observation: &Observation,
    frame: usize,
    view: usize,
    joint: usize,
    deviation: f64,
) -> Option<Sight> {
    let pixel = observation.views[view][joint]?;
    let near = |frame: usize| Some(observations.get(frame)?.views[view][joint]?.position);
    let ends = (1..=REACH).rev().find_map(|reach| {
        let before = near(frame.checked_sub(reach)?)?;
        Some((before, near(frame + reach)?, 2.0 * reach as f64))
    });
    let velocity =
        ends.map(|(before, after, frames)| [0, 1].map(|k| (after[k] - before[k]) / frames));
    Some(Sight {
        view,
        pixel: pixel.position,
        // Where it is not known, the joint says nothing about times.
        velocity: velocity.unwrap_or_default(),
        deviation: deviation.max(pixel.deviation),
    })
}

impl Problem for Bundle<'_> {
    type State = State;

    fn columns(&self) -> Columns {
        Columns::grouped(SIZE * self.cameras.len(), self.sights.len(), 3)
    }

    fn evaluate(&self, state: &State, equations: &mut Equations) -> Option<()> {
        let cameras = all_moved(self.cameras, &state.motions);
        let shared = SIZE * self.cameras.len();
        for (group, (point, sights)) in state.points.iter().zip(&self.sights).enumerate() {
            for sight in sights {
                let seen = cameras[sight.view]
                    .project_with_derivatives((*point).into())
                    .ok()?;
                let offset = state.motions[sight.view][OFFSET];
                let slope = 1.0 / sight.deviation;
                let residual = [0, 1]
                    .map(|k| (seen.pixel[k] - sight.pixel[k] - offset * sight.velocity[k]) * slope);
                let first = SIZE * sight.view;
                let mut derivatives: Vec<(usize, [f64; 2])> = Vec::with_capacity(SIZE + 3);
                for k in 0..6 {
                    derivatives.push((first + k, [0, 1].map(|i| seen.by_twist[i][k] * slope)));
                }
                derivatives.push((first + OFFSET, sight.velocity.map(|v| -v * slope)));
                for k in 0..3 {
                    let column = shared + 3 * group + k;
                    derivatives.push((column, [0, 1].map(|i| seen.by_point[i][k] * slope)));
                }
                equations.add(residual, &derivatives);
            }
        }
        self.add_prior(state, &cameras, equations);
        Some(())
    }

    fn stepped(&self, state: &State, step: &[f64]) -> Option<State> {
        let mut next = state.clone();
        let (shared, points) = step.split_at(SIZE * self.cameras.len());
        for (motion, step) in next.motions.iter_mut().zip(shared.chunks_exact(SIZE)) {
            for (own, step) in motion.iter_mut().zip(step) {
                *own += step;
            }
        }
        for (point, step) in next.points.iter_mut().zip(points.chunks_exact(3)) {
            *point += Vector::new(step[0], step[1], step[2]);
        }
        Some(next)
    }
}

impl Bundle<'_> {
    /// What the calibration says of the unknowns of a view counts with these slopes in the search.
    fn prior_slopes(&self, view: usize) -> Motion {
        self.deviations(view)
            .map(|deviation| FREE / deviation.max(EXACT))
    }

    /// The standard deviations of the unknowns of a view by what is known beside points. What is
    /// exact has the deviation 0.
    pub(super) fn deviations(&self, view: usize) -> Motion {
        let RegistrationOptions {
            rotation,
            position,
            most_frames,
        } = *self.options;
        let offset = if view > 0 && most_frames > 0 {
            UNKNOWN
        } else {
            0.0
        };
        [
            rotation, rotation, rotation, position, position, position, offset,
        ]
    }

    /// What the calibration says, and that the first view has the right time.
    fn add_prior(&self, state: &State, cameras: &[Camera], equations: &mut Equations) {
        for (view, motion) in state.motions.iter().enumerate() {
            for (k, (value, slope)) in motion.iter().zip(self.prior_slopes(view)).enumerate() {
                equations.add([value * slope], &[(SIZE * view + k, [slope])]);
            }
        }
        // The rig keeps its size: the sum of displacements along the ways from its middle is 0.
        let (mut sum, mut derivatives) = (0.0, Vec::new());
        for (view, (camera, way)) in cameras.iter().zip(&self.ways).enumerate() {
            let to_world = camera.world_to_camera.reverse().rotor();
            for k in 0..3 {
                let axis = Vector::from([0, 1, 2].map(|i| f64::from(u8::from(i == k))));
                let along = -crate::chain::rotated(to_world, axis).dot(*way) / EXACT;
                sum += along * state.motions[view][3 + k];
                derivatives.push((SIZE * view + 3 + k, [along]));
            }
        }
        equations.add([sum], &derivatives);
    }
}
