//! Where a fit begins: at points that are triangulated one by one, or in the usual
//! posture in front of a camera.

use ga_numerics::order_statistics::median;
use ga_runtime::cga3::{Direction, Point, Rotor};
use ga_runtime::vga3::Vector;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

mod assembly;
mod candidates;
mod depths;
mod links;
mod mirrored;

use depths::{Depths, Places};
pub(super) use links::{Link, Links};
pub(super) use mirrored::mirrored;

use super::Observation;
use super::chain::{Chain, State, rotated};
use crate::BodyError;
use ga_camera::Camera;
use ga_camera::triangulation::{TriangulationError, triangulate_views};

/// How many points a pose needs.
const NEEDED: usize = 3;
/// How many of the starts in front of one camera are followed.
const FOLLOWED: usize = 6;
/// How many places are drawn for each one from which a fit begins.
const DRAWN: usize = 8;
/// The seed of the places that are drawn: equal pixels give equal poses.
const SEED: u64 = 0;

/// The cost of a view that is wrong about a point: that of an error of six standard deviations.
pub(super) const WRONG: f64 = 36.0;

/// A state from which a fit begins.
pub(super) struct Start {
    pub(super) state: State,
    /// Where the points should be, as far as that is known, and which views are wrong.
    pub(super) places: Option<Places>,
}

/// The states from which a fit begins.
///
/// # Errors
/// [`BodyError::TooFewPoints`], [`BodyError::Behind`].
pub(super) fn starts(
    chain: &Chain<'_>,
    links: &Links,
    cameras: &[Camera],
    observation: &Observation,
    samples: usize,
) -> Result<Vec<Start>, BodyError> {
    let seen = distinct_seen(chain, observation);
    if seen < NEEDED {
        let needed = NEEDED;
        return Err(BodyError::TooFewPoints { seen, needed });
    }
    let targets = triangulated(chain, cameras, observation)?;
    let count = targets.iter().filter(|target| target.weight > 0.0).count();
    if count >= NEEDED {
        let places = targets
            .iter()
            .map(|target| (target.weight > 0.0).then(|| target.position.into()));
        let places: Vec<Option<Vector<f64>>> = places.collect();
        let depths = Depths::new(links, cameras, observation, &places, WRONG);
        let start = |places: Places| {
            let state = assembly::assemble(chain, links, &places.points)?;
            Some(Start {
                state,
                places: Some(places),
            })
        };
        let mut starts: Vec<Start> = start(depths.best()).into_iter().collect();
        if samples > 0 {
            let random = &mut ChaCha8Rng::seed_from_u64(SEED);
            let drawn = depths.samples(DRAWN * samples, random);
            let drawn = drawn.into_iter().filter_map(start).collect();
            starts.extend(resampled(chain, drawn, samples, random));
        }
        if !starts.is_empty() {
            return Ok(starts);
        }
    }
    let states = in_front(chain, cameras, observation).into_iter();
    let starts = states.map(|state| Start {
        state,
        places: None,
    });
    Ok(starts.collect())
}

/// Some of several starts, drawn without replacement by how likely the rotations of their joints
/// are: the places were drawn without regard to these (D. Rubin, "The calculation of posterior
/// distributions by data augmentation: comment", Journal of the American Statistical Association
/// 82, 1987). Those are drawn first whose exponential variables, with weights as rates, are least
/// (P. Efraimidis, P. Spirakis, "Weighted random sampling with a reservoir", 2006).
fn resampled(
    chain: &Chain<'_>,
    starts: Vec<Start>,
    count: usize,
    random: &mut ChaCha8Rng,
) -> impl Iterator<Item = Start> {
    let with_logarithms = starts.into_iter().map(|start| {
        let uniform = (f64::from(random.next_u32()) + 0.5) / 2.0_f64.powi(32);
        let rate = -0.5 * chain.unusual(&start.state);
        ((-uniform.ln()).ln() - rate, start)
    });
    let mut all: Vec<(f64, Start)> = with_logarithms.collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().take(count).map(|(_, start)| start)
}

/// How many places at rest are seen in some view.
fn distinct_seen(chain: &Chain<'_>, observation: &Observation) -> usize {
    let points = chain.model.points();
    let is_seen = |point: usize| observation.views.iter().any(|view| view[point].is_some());
    let is_first = |&point: &usize| {
        let is_same = |other: usize| points[other].at_rest == points[point].at_rest;
        is_seen(point) && !(0..point).any(|other| is_seen(other) && is_same(other))
    };
    (0..points.len()).filter(is_first).count()
}

/// A triangulated point.
#[derive(Clone, Copy, Debug)]
struct Target {
    position: Point<f64>,
    weight: f64,
}

/// The points that two views or more determine, with weights by their precision; weight 0 for all
/// others.
///
/// # Errors
/// [`BodyError::Behind`] where most points are behind a camera that sees them.
fn triangulated(
    chain: &Chain<'_>,
    cameras: &[Camera],
    observation: &Observation,
) -> Result<Vec<Target>, BodyError> {
    let (mut in_front, mut behind) = (0, 0);
    let mut first_behind = None;
    let mut targets = Vec::with_capacity(chain.model.points().len());
    for (index, point) in chain.model.points().iter().enumerate() {
        let seen = cameras.iter().zip(&observation.views).enumerate();
        let seen =
            seen.filter_map(|(view, (camera, pixels))| Some((view, *camera, pixels[index]?)));
        let (mut views, mut cameras, mut pixels) = (Vec::new(), Vec::new(), Vec::new());
        for (view, camera, pixel) in seen {
            views.push(view);
            cameras.push(camera);
            pixels.push(pixel.position);
        }
        let mut target = Target {
            position: Point::default(),
            weight: 0.0,
        };
        match triangulate_views(&cameras, &pixels) {
            Ok(found) => {
                in_front += 1;
                let variance: f64 = (0..3).map(|k| found.covariance[k][k]).sum();
                target.position = found.position;
                // A pixel that is wrong by far leaves a large error beside the others.
                target.weight = 1.0 / (variance * (1.0 + found.error_px * found.error_px));
            }
            Err(TriangulationError::Behind { view, depth }) => {
                behind += 1;
                first_behind.get_or_insert(BodyError::Behind {
                    view: views[view],
                    point: point.name.clone(),
                    depth,
                });
            }
            Err(_) => {}
        }
        targets.push(target);
    }
    match first_behind {
        Some(error) if behind > in_front => Err(error),
        _ => Ok(targets),
    }
}

/// By how much longer bones are than at rest: the median over all frames and all bones of which two
/// views show both ends. `None` where there is none.
pub(super) fn size<'o>(
    chain: &Chain<'_>,
    cameras: &[Camera],
    observations: impl Iterator<Item = &'o Observation>,
) -> Option<f64> {
    let pairs = Links::new(chain).links;
    let mut ratios: Vec<f64> = Vec::new();
    for observation in observations {
        let Ok(targets) = triangulated(chain, cameras, observation) else {
            continue;
        };
        for &Link { points, length } in &pairs {
            let [from, to] = points.map(|point| targets[point]);
            if from.weight > 0.0 && to.weight > 0.0 {
                ratios.push(from.position.distance(to.position) / length);
            }
        }
    }
    median(&mut ratios).filter(|ratio| *ratio > 0.0)
}

/// The body in its usual posture, in the orientations and at the place that best explain the view
/// that sees most points: first those with the least error.
fn in_front(chain: &Chain<'_>, cameras: &[Camera], observation: &Observation) -> Vec<State> {
    let count = |view: &&(&Camera, &Vec<_>)| view.1.iter().flatten().count();
    let views: Vec<_> = cameras.iter().zip(&observation.views).collect();
    let Some((camera, pixels)) = views.iter().max_by_key(count) else {
        return Vec::new();
    };
    let usual = chain.places(&chain.usual()).points;
    let points = usual.into_iter().zip(pixels.iter());
    let seen = points.filter_map(|(point, pixel)| {
        let [x, y, z] = camera
            .intrinsics
            .direction(pixel.as_ref()?.position)
            .ok()?
            .vector();
        (z > 0.0).then(|| (point, Vector::new(x / z, y / z, 1.0)))
    });
    let seen: Vec<(Vector<f64>, Vector<f64>)> = seen.collect();
    let mut states: Vec<(f64, State)> = quarter_turns()
        .filter_map(|rotor| placed(chain, camera, &seen, rotor))
        .collect();
    states.sort_by(|a, b| a.0.total_cmp(&b.0));
    states.truncate(FOLLOWED);
    states.into_iter().map(|(_, state)| state).collect()
}

/// The body in its usual posture in an orientation relative to a camera: its points have the mean
/// and the extent of the directions in which they are seen. Also what remains, as a part of that
/// extent.
fn placed(
    chain: &Chain<'_>,
    camera: &Camera,
    seen: &[(Vector<f64>, Vector<f64>)],
    rotor: Rotor<f64>,
) -> Option<(f64, State)> {
    let count = seen.len() as f64;
    let sum = seen
        .iter()
        .fold([Vector::default(); 2], |[a, b], (x, y)| [a + *x, b + *y]);
    let [middle, mean] = sum.map(|sum| sum / count);
    let (mut mixed, mut own, mut total) = (0.0, 0.0, 0.0);
    for (point, direction) in seen {
        let [x, y, _] = rotated(rotor, *point - middle).coordinates();
        let [u, v, _] = (*direction - mean).coordinates();
        mixed += x * u + y * v;
        own += x * x + y * y;
        total += u * u + v * v;
    }
    let size = mixed / own;
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    let to_world = camera.world_to_camera.reverse();
    let goal: Vector<f64> = to_world.transform(Point::from(mean / size)).into();
    let rotor = to_world.rotor() * rotor;
    let mut state = chain.usual();
    let joints = chain.model.skeleton().joints();
    for (index, own) in state.rotors.iter_mut().enumerate() {
        if chain.is_root(index) {
            *own = rotor;
        }
    }
    let head = Vector::from(joints[0].head);
    state.translation = goal - head - rotated(rotor, middle - head);
    Some((1.0 - mixed * size / total, state))
}

/// The 24 rotations that take the axes to axes.
fn quarter_turns() -> impl Iterator<Item = Rotor<f64>> {
    let axes = [0, 1, 2, 3, 4, 5].map(|k: usize| {
        let sign = if k < 3 { 1.0 } else { -1.0 };
        let mut axis = [0.0; 3];
        axis[k % 3] = sign;
        Direction::from_vector(axis)
    });
    let pairs = axes.into_iter().flat_map(move |x| axes.map(|y| (x, y)));
    pairs.filter_map(|(x, y)| {
        let z = x.cross(y);
        let [x, y, z] = [x, y, z].map(Direction::vector);
        Rotor::from_matrix([0, 1, 2].map(|row| [x[row], y[row], z[row]]))
    })
}
