//! Fits to points of which some are gross errors.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::cloud::Cloud;
use super::consensus::{agreeing, best_of_samples};
use super::place::Place;
use super::result::{Located, PrimitiveFit, fitted};
use super::search::{cloud_of, least};
use super::settings::RobustSettings;
use super::shape::Shape;
use crate::geometry::FitError;
use crate::scalar::Real;
use crate::vga3::Vector;

/// A primitive fitted to those points that agree with it.
#[derive(Clone, Debug, PartialEq)]
pub struct RobustFit<P, S, const N: usize> {
    /// The M-estimate of the inliers. Its root mean square and its covariance are theirs.
    pub fit: PrimitiveFit<P, S, N>,
    /// The indices of the points that agree, rising.
    pub inliers: Vec<usize>,
    /// The scale of the noise that the M-estimate used.
    pub scale: S,
    /// How many samples were drawn.
    pub samples: usize,
}

pub(super) fn fit<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: Vec<Vector<S>>,
    settings: &RobustSettings<S>,
) -> Result<RobustFit<P, S, N>, FitError<S>> {
    /// How often the points that agree are collected.
    const ROUNDS: usize = 20;
    settings.check()?;
    if let Some(index) = points.iter().position(|place| !place.is_finite()) {
        return Err(FitError::PointNotFinite { index });
    }
    let (mut located, samples) = best_of_samples::<P, S, N>(&points, settings)?;
    let mut inliers = agreeing::<P, S, N>(&points, &located, settings.threshold);
    for round in 1.. {
        let found = inliers.len();
        let needed = P::NEEDED;
        if found < needed {
            return Err(FitError::NoConsensus { found, needed });
        }
        let cloud = cloud_of::<P, S, N>(inliers.iter().map(|&k| (S::one(), points[k])))?;
        let scale = scale::<P, S, N>(&cloud, located.seen_from(&cloud), settings.scale);
        let limit = scale * settings.loss.constant() / cloud.unit;
        let limited = Some((settings.loss, limit));
        let place = least::<P, S, N>(&cloud, &[located.seen_from(&cloud)], limited)?;
        located = Located::new(&cloud, place);
        let next = agreeing::<P, S, N>(&points, &located, settings.threshold);
        if next == inliers || round == ROUNDS {
            return Ok(RobustFit {
                fit: fitted(&cloud, place, limited)?,
                inliers,
                scale,
                samples,
            });
        }
        inliers = next;
    }
    Err(FitError::NotConverged)
}

/// The given scale of the noise, or that of the distances from a place, but at least their
/// rounding.
fn scale<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    cloud: &Cloud<S>,
    place: Place<S>,
    given: Option<S>,
) -> S {
    let located = Located::new(cloud, place);
    let least = cloud.unit * S::epsilon() * S::from_integer(64);
    let estimated = || {
        let mut distances: Vec<S> = cloud
            .points
            .iter()
            .map(|&(_, point)| {
                let inside = Located {
                    centroid: Vector::default(),
                    unit: S::one(),
                    place,
                };
                inside.residual::<P, N>(point).abs() * located.unit
            })
            .collect();
        distances.sort_unstable_by(|a, b| match (a.less_than(*b), b.less_than(*a)) {
            (true, _) => Ordering::Less,
            (_, true) => Ordering::Greater,
            _ => Ordering::Equal,
        });
        let middle = distances.len() / 2;
        let median = if distances.len() % 2 == 1 {
            distances[middle]
        } else {
            (distances[middle - 1] + distances[middle]) * S::from_ratio(1, 2)
        };
        let per_deviation = if P::COMPONENTS == 1 {
            0.674_489_750_196_081_7
        } else {
            1.177_410_022_515_474_7
        };
        median / S::from_f64(per_deviation)
    };
    given.unwrap_or_else(estimated).max(least)
}
