//! The search for the primitive of the least distances.

use super::cloud::{Cloud, Weighted};
use super::loss::Limited;
use super::place::Place;
use super::refinement::refine;
use super::shape::Shape;
use crate::geometry::FitError;
use crate::scalar::Real;

/// The most steps of a search. Points near a primitive take fewer than ten, the worst some dozens.
const MOST_STEPS: usize = 300;

/// The most steps from each of several starts, before the best is continued.
const FIRST_STEPS: usize = 20;

/// Points that spread as the primitive requires.
pub(super) fn cloud_of<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: impl ExactSizeIterator<Item = Weighted<S>>,
) -> Result<Cloud<S>, FitError<S>> {
    let cloud = Cloud::of(points, P::NEEDED)?;
    cloud.require(P::DIMENSION)?;
    Ok(cloud)
}

/// The place of the least distances or losses that is reached from some places.
pub(super) fn least<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    cloud: &Cloud<S>,
    starts: &[Place<S>],
    limited: Limited<S>,
) -> Result<Place<S>, FitError<S>> {
    let search =
        |start, steps| refine::<P, S, N>(&cloud.points, cloud.total, start, limited, steps);
    let steps = if starts.len() > 1 {
        FIRST_STEPS
    } else {
        MOST_STEPS
    };
    let best = starts
        .iter()
        .map(|&start| search(start, steps))
        .filter(|found| found.cost.is_finite())
        .reduce(|best, next| {
            if next.cost.less_than(best.cost) {
                next
            } else {
                best
            }
        });
    let best = match best {
        Some(found) if !found.has_converged && steps < MOST_STEPS => {
            search(found.place, MOST_STEPS)
        }
        Some(found) => found,
        None => return Err(FitError::OutOfRange),
    };
    if !best.has_converged {
        return Err(FitError::NotConverged);
    }
    Ok(best.place)
}
