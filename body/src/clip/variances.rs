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

/// The mean square of a component of second differences over `lag` frames. `None` where there are
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

#[cfg(test)]
mod tests {
    use ga_runtime::cga3::Rotor;
    use ga_runtime::vga3::Vector;

    use super::*;
    use crate::example;

    /// A body that accelerates by the same amount in each frame, and whose first joint rotates
    /// about one axis likewise.
    fn accelerated(chain: &Chain<'_>, count: usize) -> Vec<State> {
        let frame = |t: usize| {
            let half = 0.5 * (t * t) as f64;
            let mut state = chain.usual();
            state.translation = Vector::new(0.02, -0.01, 0.03) * half;
            state.rotors[1] =
                Rotor::from_rotation_vector([0.0, 0.004 * half, 0.0]).expect("finite");
            state
        };
        (0..count).map(frame).collect()
    }

    #[test]
    fn second_differences_of_an_acceleration_grow_with_the_square_of_the_time() {
        let model = example::model();
        let chain = Chain::new(&model);
        let states = accelerated(&chain, 20);
        for lag in [1, 2, 3, 5] {
            let squared = (lag as f64).powi(4);
            for (kind, sum) in [(0, 14e-4), (2, 16e-6)] {
                let found = mean_square(&chain, &states, kind, lag).unwrap();
                let expected = sum * squared / 3.0;
                assert!((found - expected).abs() < 1e-9 * expected, "{kind} {lag}");
            }
        }
        assert!(mean_square(&chain, &states, 0, 6).is_none());
    }

    #[test]
    fn an_acceleration_is_told_from_errors() {
        let model = example::model();
        let chain = Chain::new(&model);
        // Over two frames the mean square is 16 times that over one: (16 − 1) / (6 − 1).
        let found = variances(&chain, &accelerated(&chain, 20), 30.0);
        assert!((found[0] - 3.0 * 14e-4 / 3.0).abs() < 1e-12);
        assert!((found[2] - 3.0 * 16e-6 / 3.0).abs() < 1e-12);
        // A joint that rests has the least variance.
        assert_eq!(found[3], LEAST);
        // Two frames show no acceleration: the usual ones, 5 m/s² and 20 rad/s².
        let usual = variances(&chain, &accelerated(&chain, 2), 10.0);
        assert!((usual[0] - 0.0025).abs() < 1e-15 && (usual[2] - 0.04).abs() < 1e-15);
    }
}
