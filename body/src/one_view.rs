//! The poses of a clip that one camera sees.
//!
//! One view leaves several poses open for each frame: a bone that points towards the camera is seen
//! almost as one that points away from it. So each frame has many candidates, the minima of its
//! cost that are found from rest, from one another with bones mirrored, and from those of the
//! frames before and after. Of these the best one is taken, which is rarely found from one frame
//! alone. What motions between frames cost hardly helps to choose: a body that is seen in a wrong
//! pose often moves less than the true one.

use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::chain::State;
use super::descent::{Found, Search, descend};
use super::fit::BodyFit;
use super::start::mirrored;
use super::{BodyError, Observation};

/// The time in seconds between frames whose poses are searched from rest and by mirrored bones.
const SEARCHED: f64 = 0.1;
/// The greatest number of candidates of a frame.
const KEPT: usize = 24;
/// How many of the best candidates of a frame that is searched have their bones mirrored.
const MIRRORED: usize = 8;
/// Candidates are the same whose points are nowhere farther apart, in metres.
const SAME: f64 = 0.03;
/// From a mirrored bone, or from the frame before, to a minimum.
const NEAR: Search = Search {
    steps: 20,
    tolerance: 1e-2,
};

/// A pose that a frame may have.
#[derive(Clone, Debug)]
struct Candidate {
    state: State,
    cost: f64,
    points: Vec<Vector<f64>>,
}

/// The candidates of the first frame of a part that has any, or why the first one has none.
type Searched = Result<(usize, Vec<Candidate>), Option<BodyError>>;

/// The likeliest states of the frames of a clip, of those that are found in any of them.
///
/// # Errors
/// [`BodyError::Frame`] with the first frame, where none by itself has a pose.
pub(super) fn states(
    fit: &BodyFit<'_>,
    observations: &[Observation],
    frames_per_second: f64,
) -> Result<Vec<State>, BodyError> {
    let every = ((SEARCHED * frames_per_second) as usize).max(1);
    let parts = observations.par_chunks(every).enumerate();
    let searched = parts.map(|(part, observations)| {
        let mut error = None;
        for (frame, observation) in (part * every..).zip(observations) {
            match searched(fit, observation) {
                Ok(found) => return Ok((frame, found)),
                Err(found) => error = error.or(Some(found.of_frame(frame))),
            }
        }
        Err(error)
    });
    let searched: Vec<Searched> = searched.collect();
    let mut candidates = vec![Vec::new(); observations.len()];
    let mut error = None;
    for found in searched {
        match found {
            Ok((frame, found)) => candidates[frame] = found,
            Err(found) => error = error.or(found),
        }
    }
    if candidates.iter().all(Vec::is_empty) {
        return error.map_or(Ok(Vec::new()), Err);
    }
    let count = observations.len();
    for frame in 1..count {
        carry(fit, observations, &mut candidates, frame - 1, frame);
    }
    for frame in (1..count).rev() {
        carry(fit, observations, &mut candidates, frame, frame - 1);
    }
    let best = candidates.into_iter().map(|own| own.into_iter().next());
    let best: Vec<Option<State>> = best.map(|own| own.map(|own| own.state)).collect();
    let Some(first) = best.iter().flatten().next().cloned() else {
        return Ok(Vec::new());
    };
    // A frame without a state of its own has that of the one before.
    let filled = best.into_iter().scan(first, |last, state| {
        *last = state.unwrap_or_else(|| last.clone());
        Some(last.clone())
    });
    Ok(filled.collect())
}

/// The minima of the cost of a frame that are found from rest and with bones mirrored.
fn searched(fit: &BodyFit<'_>, observation: &Observation) -> Result<Vec<Candidate>, BodyError> {
    let likelihood = fit.likelihood();
    let (chain, camera) = (&likelihood.chain, &likelihood.cameras[0]);
    let normal = &mut fit.normal();
    let mut all = Vec::new();
    for found in fit.minima(observation, 0, normal)?.0 {
        add(&mut all, candidate(fit, found.found));
    }
    let mut done: Vec<Vec<Vector<f64>>> = Vec::new();
    while let Some(next) = all
        .iter()
        .take(MIRRORED)
        .find(|own: &&Candidate| !done.iter().any(|done| is_same(done, &own.points)))
        .filter(|_| done.len() < MIRRORED)
    {
        let points = next.points.clone();
        for start in mirrored(chain, fit.links(), camera, &points) {
            let near = fit.descend_from(&start, observation, normal);
            let found =
                near.and_then(|near| descend(&fit.observed(observation), near.state, NEAR, normal));
            if let Some(found) = found {
                add(&mut all, candidate(fit, found));
            }
        }
        done.push(points);
    }
    Ok(all)
}

/// Adds the candidates of a frame to those of the next one, as they are there.
fn carry(
    fit: &BodyFit<'_>,
    observations: &[Observation],
    candidates: &mut [Vec<Candidate>],
    from: usize,
    to: usize,
) {
    let observation = &observations[to];
    let is_seen = observation.views.iter().flatten().any(Option::is_some);
    let carried = candidates[from].par_iter().map_init(
        || fit.normal(),
        |normal, own| {
            if !is_seen {
                return Some(own.clone());
            }
            let found = descend(&fit.observed(observation), own.state.clone(), NEAR, normal)?;
            Some(candidate(fit, found))
        },
    );
    let carried: Vec<Option<Candidate>> = carried.collect();
    for own in carried.into_iter().flatten() {
        add(&mut candidates[to], own);
    }
    if candidates[to].is_empty() {
        candidates[to] = candidates[from].clone();
    }
}

fn candidate(fit: &BodyFit<'_>, found: Found) -> Candidate {
    Candidate {
        points: fit.likelihood().chain.places(&found.state).points,
        cost: found.cost,
        state: found.state,
    }
}

/// Adds a candidate to others in the order of their costs, where it is among the best and is not
/// one of them.
fn add(all: &mut Vec<Candidate>, own: Candidate) {
    if let Some(index) = all
        .iter()
        .position(|other| is_same(&other.points, &own.points))
    {
        if all[index].cost <= own.cost {
            return;
        }
        all.remove(index);
    }
    let index = all.partition_point(|other| other.cost <= own.cost);
    all.insert(index, own);
    all.truncate(KEPT);
}

fn is_same(a: &[Vector<f64>], b: &[Vector<f64>]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.distance(*b) < SAME)
}
