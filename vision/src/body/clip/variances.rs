//! How much joints and body accelerate, from poses that were fitted one by one.
//!
//! The second difference over m frames, `x(t + m) − 2 x(t) + x(t − m)`, of a motion whose second
//! differences over one frame are independent with the variance v, has the variance
//!
//! ```text
//! v Σ (m − |i|)² = v m (2m² + 1) / 3,   i from −m to m
//! ```
//!
//! Independent errors of the frames add the same to it for every m. So v follows from the mean
//! squares over m frames and over one. The least m is taken for which the motion exceeds the
//! errors: at this scale smoothing separates them. (The mean square as a function of the distance
//! in time is a variogram: G. Matheron, "Principles of geostatistics", 1963.)

use super::super::chain::{Chain, State};
use super::differences::{components, difference, kinds};

/// The part of the errors that a motion too small to be seen may have.
const UNSEEN: f64 = 0.1;
/// The least variance beside squares of metres and radians, so that its inverse is finite.
const LEAST: f64 = 1e-14;

/// Accelerations of a human who moves without haste, in m/s² and in rad/s², for clips that are too
/// short to show their own.
const TRANSLATION: f64 = 5.0;
const ROTATION: f64 = 20.0;

/// The variance of each component of the second differences over one frame: that of the
/// translation, and that of each joint; 0 for a joint that does not rotate.
pub(super) fn variances(chain: &Chain<'_>, states: &[State], frames_per_second: f64) -> Vec<f64> {
    let usual = |kind| {
        let acceleration = if kind == 0 { TRANSLATION } else { ROTATION };
        (acceleration / frames_per_second.powi(2)).powi(2)
    };
    (0..kinds(chain))
        .map(|kind| match components(chain, kind) {
            0 => 0.0,
            _ => variance(chain, states, kind)
                .unwrap_or(usual(kind))
                .max(LEAST),
        })
        .collect()
}

/// `None` where there are too few frames.
fn variance(chain: &Chain<'_>, states: &[State], kind: usize) -> Option<f64> {
    let errors = mean_square(chain, states, kind, 1)?;
    let (mut found, mut lag) = (None, 2);
    while let Some(square) = mean_square(chain, states, kind, lag) {
        let growth = gain(lag);
        found = Some(((square - errors) / (growth - 1.0)).max(UNSEEN * errors / growth));
        if square >= 2.0 * errors {
            break;
        }
        lag += lag.div_ceil(2);
    }
    found
}

/// `Σ (m − |i|)²`.
fn gain(lag: usize) -> f64 {
    let m = lag as f64;
    m * (2.0 * m * m + 1.0) / 3.0
}

/// The mean square of a component of second differences over so many frames. `None` where there are
/// not enough frames to say.
fn mean_square(chain: &Chain<'_>, states: &[State], kind: usize, lag: usize) -> Option<f64> {
    let few = lag > 1 && states.len() < 4 * lag;
    let triples = (lag..states.len().saturating_sub(lag)).filter_map(|t| {
        let states = [&states[t - lag], &states[t], &states[t + lag]];
        Some(difference(chain, states, kind)?.squared())
    });
    let (sum, count) = triples.fold((0.0, 0), |(sum, count), square| (sum + square, count + 1));
    let components = components(chain, kind) * count;
    (!few && components > 0).then(|| sum / components as f64)
}
