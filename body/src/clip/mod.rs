//! The most likely motion of a clip.

mod covariances;
mod differences;
pub(super) mod tracks;
mod window;

use rayon::prelude::*;

use super::Observation;
use super::chain::State;
use super::ground::Anchor;
use super::likelihood::Likelihood;

/// How many frames a stretch of a long clip contributes…
const CORE: usize = 192;
/// …and how many more it has on either side, which the frames of the core hardly depend on.
const MARGIN: usize = 48;

/// The most likely states of all frames from states that are near, and from those of the frames by
/// themselves, which show the accelerations beside errors that are independent. Where there are
/// `anchors`, points are held in the frames that have any. Stretches of the
/// clip are computed independently of each other.
pub(super) fn smooth(
    likelihood: &Likelihood<'_>,
    observations: &[Observation],
    states: Vec<State>,
    single: &[State],
    frames_per_second: f64,
    anchors: &[Vec<Anchor>],
) -> Vec<State> {
    let count = states.len();
    let cores: Vec<(usize, usize)> = (0..count)
        .step_by(CORE)
        .map(|first| (first, (first + CORE).min(count)))
        .collect();
    let smoothed = cores.into_par_iter().map(|(first, end)| {
        let (from, to) = (first.saturating_sub(MARGIN), (end + MARGIN).min(count));
        let mut found = window::fit(
            likelihood,
            &observations[from..to],
            states[from..to].to_vec(),
            &single[from..to],
            frames_per_second,
            anchors.get(from..to).unwrap_or_default(),
        );
        found.truncate(end - from);
        found.drain(..first - from);
        found
    });
    smoothed.flatten_iter().collect()
}
