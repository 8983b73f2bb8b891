//! How long errors of a detector last.
//!
//! A detector that takes a shoulder for one that is 2 cm lower does so in the next frame too. The
//! errors of n frames then tell as much as those of n/τ independent ones, with the integrated time
//! of their autocorrelation ρ,
//!
//! ```text
//! τ = 1 + 2 Σ ρ(k) (1 − k/n)   over the lags k from 1 on in frames
//! ```
//!
//! (A. Sokal, "Monte Carlo methods in statistical mechanics: foundations and new algorithms",
//! 1996).

use ga_camera::Camera;
use ga_camera::triangulation::triangulate_views;
use ga_runtime::cga3::Point;

use crate::Observation;

/// Errors that are longer count as if they had this length, in standard deviations.
const LONGEST: f64 = 3.0;
/// A correlation that does not matter.
const NONE: f64 = 0.05;

/// The integrated time of the errors that remain where rays of all views meet, in frames; at least
/// 1.
pub(super) fn time(cameras: &[Camera], observations: &[Observation], deviation: f64) -> f64 {
    let joints = observations
        .first()
        .map_or(0, |first| first.views.first().map_or(0, Vec::len));
    // For each joint and view its errors in all frames.
    let mut tracks: Vec<Vec<Option<[f64; 2]>>> = Vec::new();
    for joint in 0..joints {
        let mut of_views = vec![vec![None; observations.len()]; cameras.len()];
        for (frame, observation) in observations.iter().enumerate() {
            let Some(place) = place(cameras, observation, joint) else {
                continue;
            };
            for (view, camera) in cameras.iter().enumerate() {
                let error = observation.views[view][joint].and_then(|pixel| {
                    let at = camera.project(place).ok()?;
                    let error = [0, 1].map(|k| pixel.position[k] - at[k]);
                    let length = error[0].hypot(error[1]);
                    let longest = (LONGEST * deviation / length.max(f64::MIN_POSITIVE)).min(1.0);
                    Some(error.map(|x| x * longest))
                });
                of_views[view][frame] = error;
            }
        }
        tracks.extend(of_views);
    }
    let mean_product = |lag: usize| {
        let (mut sum, mut count) = (0.0, 0_u32);
        for track in &tracks {
            for (one, other) in track.iter().zip(track.iter().skip(lag)) {
                if let (Some(a), Some(b)) = (one, other) {
                    sum += a[0] * b[0] + a[1] * b[1];
                    count += 1;
                }
            }
        }
        sum / f64::from(count.max(1))
    };
    let frames = observations.len();
    let square = mean_product(0);
    let mut time = 1.0;
    let mut lag = 1;
    while lag < frames {
        let correlation = mean_product(lag) / square.max(f64::MIN_POSITIVE);
        if correlation < NONE {
            break;
        }
        // Long lags stand for those around them.
        let step = (lag / 16).max(1);
        time += 2.0 * correlation * (1.0 - lag as f64 / frames as f64) * step as f64;
        lag += step;
    }
    time
}

fn place(cameras: &[Camera], observation: &Observation, joint: usize) -> Option<Point<f64>> {
    let views = cameras.iter().zip(&observation.views);
    let seen = views.filter_map(|(camera, pixels)| Some((*camera, pixels[joint]?.position)));
    let (cameras, pixels): (Vec<Camera>, Vec<[f64; 2]>) = seen.unzip();
    triangulate_views(&cameras, &pixels)
        .ok()
        .map(|found| found.position)
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    use super::*;
    use crate::{JointPixel, example};

    /// Pixels of points that rest, with errors that keep a part of what they were in the frame
    /// before.
    fn seen(cameras: &[Camera], part: f64) -> Vec<Observation> {
        let random = &mut ChaCha8Rng::seed_from_u64(1);
        let mut normal = || {
            let sum: f64 = (0..12)
                .map(|_| f64::from(random.next_u32()) / 2.0_f64.powi(32))
                .sum();
            sum - 6.0
        };
        let mut errors = [[[0.0; 2]; 6]; 2];
        let frame = |_| {
            let views = cameras.iter().zip(&mut errors).map(|(camera, errors)| {
                let pixels = errors.iter_mut().enumerate().map(|(point, error)| {
                    let place = Point::new(0.1 * point as f64 - 0.3, 0.05 * point as f64, 3.0);
                    let at = camera.project(place).unwrap();
                    *error = error.map(|e| part * e + (1.0 - part * part).sqrt() * normal());
                    Some(JointPixel {
                        position: [at[0] + error[0], at[1] + error[1]],
                        deviation: 1.0,
                    })
                });
                pixels.collect()
            });
            Observation {
                views: views.collect(),
            }
        };
        (0..4000).map(frame).collect()
    }

    #[test]
    fn errors_that_last_have_the_time_of_their_autoregression() {
        let cameras = [example::camera(0.0), example::camera(1.0)];
        for part in [0.0, 0.5, 0.9] {
            let found = time(&cameras, &seen(&cameras, part), 1.0);
            let expected = (1.0 + part) / (1.0 - part);
            assert!((found - expected).abs() < 0.2 * expected, "{part}: {found}");
        }
    }
}
