//! The pixels of a clip, smoothed over time: what begins the search for its poses.
//!
//! Around each frame a point moves along a parabola in the picture, fitted to its pixels by least
//! squares (A. Savitzky, M. Golay, "Smoothing and differentiation of data by simplified least
//! squares procedures", 1964), over as many frames as the errors of pixels explain what remains.
//! This leaves far fewer poses open than a frame by itself does, and shows points in frames where
//! they are missing.

use nalgebra_035::{Matrix3, Matrix3x2, RowVector2, Vector3};

use super::super::{JointPixel, Observation};
use ga_numerics::least_squares::Loss;

/// How many frames before and after are used at most; half of it where a parabola does not fit, and
/// so on.
const REACH: usize = 16;
/// How many pixels a parabola needs.
const NEEDED: usize = 5;
/// The mean squared error in variances up to which a parabola fits. Over many frames it is rarely
/// more by chance.
const FITS: f64 = 1.5;
/// Pixels farther from the parabola in standard deviations hardly count.
const OUTLIER: f64 = 6.0;
const ROUNDS: usize = 3;

/// What all views show, smoothed.
pub(crate) fn smoothed(observations: &[Observation]) -> Vec<Observation> {
    let of_frame = |frame: usize| {
        let views = observations[frame].views.iter().enumerate();
        let views = views.map(|(view, pixels)| {
            let of_point = |point: usize| {
                let at = |frame: usize| observations[frame].views[view][point];
                pixel(at, frame, observations.len())
            };
            (0..pixels.len()).map(of_point).collect()
        });
        Observation {
            views: views.collect(),
        }
    };
    (0..observations.len()).map(of_frame).collect()
}

/// A point of a view in a frame.
fn pixel(
    at: impl Fn(usize) -> Option<JointPixel>,
    frame: usize,
    count: usize,
) -> Option<JointPixel> {
    let mut reach = REACH;
    while reach > 0 {
        let (from, to) = (frame.saturating_sub(reach), (frame + reach).min(count - 1));
        let around = (from..=to).filter_map(|other| {
            let time = (other as f64 - frame as f64) / reach as f64;
            Some((time, at(other)?))
        });
        if let Some(found) = parabola(around.collect()) {
            return Some(found);
        }
        reach /= 2;
    }
    at(frame)
}

/// The pixel at the time 0. `None` where pixels are too few or do not lie around it, or where no
/// parabola explains them.
fn parabola(pixels: Vec<(f64, JointPixel)>) -> Option<JointPixel> {
    let (first, last) = (pixels.first()?, pixels.last()?);
    if pixels.len() < NEEDED || first.0 > 0.0 || last.0 < 0.0 {
        return None;
    }
    let mut weights = vec![1.0; pixels.len()];
    for round in 0..ROUNDS {
        let (mut normal, mut right) = (Matrix3::zeros(), Matrix3x2::zeros());
        for ((time, pixel), weight) in pixels.iter().zip(&weights) {
            let powers = Vector3::new(1.0, *time, time * time);
            let weighted = powers * (weight / pixel.deviation.powi(2));
            normal += weighted * powers.transpose();
            right += weighted * RowVector2::from(pixel.position);
        }
        let inverse = normal.try_inverse()?;
        let found = inverse * right;
        let (mut sum, mut total) = (0.0, 0.0);
        for ((time, pixel), weight) in pixels.iter().zip(&mut weights) {
            let place = found.row(0) + found.row(1) * *time + found.row(2) * (time * time);
            let error = (place - RowVector2::from(pixel.position)) / pixel.deviation;
            sum += *weight * error.norm_squared();
            total += *weight;
            *weight = Loss::GemanMcClure(OUTLIER).of(error.norm_squared()).1;
        }
        if round + 1 == ROUNDS {
            // Three unknowns in each coordinate.
            let mean = sum / (2.0 * (total - 3.0)).max(1.0);
            let deviation = inverse[(0, 0)].sqrt();
            let position = [found[(0, 0)], found[(0, 1)]];
            let is_finite = deviation > 0.0 && position.iter().all(|x| x.is_finite());
            return (mean <= FITS && is_finite).then_some(JointPixel {
                position,
                deviation,
            });
        }
    }
    None
}
