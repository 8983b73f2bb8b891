//! By how many whole frames views are late.

use ga_camera::Camera;
use ga_numerics::least_squares::Loss;
use ga_runtime::geometry::ray::Ray;
use rayon::prelude::*;

use crate::Observation;
use crate::gap::{gap_in_pixels, pairs_of_views};

/// How many frames are compared at most, spread over all.
const FRAMES: usize = 100;
/// How often all views are moved one after the other.
const ROUNDS: usize = 4;
/// Rays that miss each other by more, in standard deviations, are of wrong joints.
const LOSS: Loss = Loss::GemanMcClure(3.0);
/// Views begin together unless another offset lowers the cost at least by this part.
const GAIN: f64 = 0.03;

/// What it costs that a view is later than another, for the pair and each number of frames.
struct Costs {
    views: (usize, usize),
    most: i64,
    of_lags: Vec<f64>,
}

impl Costs {
    fn at(&self, lag: i64) -> f64 {
        let index = usize::try_from(lag + 2 * self.most).ok();
        index
            .and_then(|index| self.of_lags.get(index))
            .copied()
            .unwrap_or(f64::INFINITY)
    }
}

/// How far is searched in clips with so many frames: at least half of these are seen together.
pub(super) fn limit(frames: usize, most: usize) -> i64 {
    most.min(frames / 4) as i64
}

/// For each view the number of its frame that shows what frame 0 of the first view shows.
pub(super) fn whole(
    cameras: &[Camera],
    observations: &[Observation],
    most: usize,
    scale: f64,
) -> Vec<i64> {
    let mut offsets = vec![0_i64; cameras.len()];
    let most = limit(observations.len(), most);
    if most == 0 {
        return offsets;
    }
    let rays = rays(cameras, observations);
    let pairs: Vec<(usize, usize)> = pairs_of_views(cameras.len()).collect();
    let costs: Vec<Costs> = pairs
        .par_iter()
        .map(|&views| of_pair(cameras, &rays, views, most, scale))
        .collect();
    // Views that never show a joint together say nothing.
    let is_seen = |costs: &Costs| costs.of_lags.iter().any(|cost| cost.is_finite());
    let costs: Vec<Costs> = costs.into_iter().filter(is_seen).collect();
    let total = |offsets: &[i64]| -> f64 {
        let pairs = costs.iter().map(|costs| {
            let (a, b) = costs.views;
            costs.at(offsets[b] - offsets[a])
        });
        pairs.sum()
    };
    let together = total(&offsets);
    // Views come one after the other to those before, and then to all.
    for round in 0..ROUNDS {
        for view in 1..cameras.len() {
            let among = if round == 0 { view } else { cameras.len() - 1 };
            let cost = |offset: i64| {
                let own = costs.iter().filter(|costs| {
                    let (a, b) = costs.views;
                    (a == view || b == view) && a.max(b) <= among.max(view)
                });
                let own = own.map(|costs| {
                    let mut offsets = offsets.clone();
                    offsets[view] = offset;
                    costs.at(offsets[costs.views.1] - offsets[costs.views.0])
                });
                own.sum::<f64>()
            };
            // Of equal ones the least offset.
            let all = (0..=most).flat_map(|offset| [offset, -offset]);
            let best = all.min_by(|&a, &b| cost(a).total_cmp(&cost(b)));
            offsets[view] = best.unwrap_or(0);
        }
    }
    match total(&offsets) < (1.0 - GAIN) * together {
        true => offsets,
        false => vec![0; cameras.len()],
    }
}

/// For each view, frame and point the ray of its pixel.
fn rays(cameras: &[Camera], observations: &[Observation]) -> Vec<Vec<Vec<Option<Ray<f64>>>>> {
    let of_view = |(view, camera): (usize, &Camera)| {
        let frames = observations.iter().map(|observation| {
            let pixels = observation.views[view].iter();
            pixels
                .map(|pixel| camera.ray((*pixel)?.position).ok())
                .collect()
        });
        frames.collect()
    };
    cameras.iter().enumerate().map(of_view).collect()
}

fn of_pair(
    cameras: &[Camera],
    rays: &[Vec<Vec<Option<Ray<f64>>>>],
    (a, b): (usize, usize),
    most: i64,
    scale: f64,
) -> Costs {
    let count = rays[a].len();
    let of_lag = |lag: i64| {
        let (mut sum, mut seen) = (0.0, 0_u32);
        for frame in (0..count).step_by(count.div_ceil(FRAMES).max(1)) {
            let Some(other) = usize::try_from(frame as i64 + lag)
                .ok()
                .filter(|f| *f < count)
            else {
                continue;
            };
            for (one, other) in rays[a][frame].iter().zip(&rays[b][other]) {
                let (Some(one), Some(other)) = (one, other) else {
                    continue;
                };
                let gap = gap_in_pixels([&cameras[a], &cameras[b]], [*one, *other]);
                sum += LOSS.of((gap / scale).powi(2).min(f64::MAX)).0;
                seen += 1;
            }
        }
        match seen {
            0 => f64::INFINITY,
            seen => sum / f64::from(seen),
        }
    };
    Costs {
        views: (a, b),
        most,
        of_lags: (-2 * most..=2 * most).map(of_lag).collect(),
    }
}
