//! How much joints and body accelerate, and in which directions, from poses that were fitted one
//! by one.
//!
//! The second difference over m frames, `x(t + m) − 2 x(t) + x(t − m)`, of a motion whose second
//! differences over one frame are independent with the covariance V, has the covariance
//!
//! ```text
//! V Σ (m − |i|)² = V m (2m² + 1) / 3,   i from −m to m
//! ```
//!
//! Independent errors of the frames add the same to it for every m. So V follows from the moments
//! over m frames and over one. The least m is taken for which the motion exceeds the errors: at
//! this scale smoothing separates them. (The moment as a function of the distance in time is a
//! variogram: G. Matheron, "Principles of geostatistics", 1963.)
//!
//! A knee swings about one axis, and the errors of two cameras side by side are greatest in depth:
//! both differ by direction. So V is a matrix in the axes in which the differences are: those of
//! the world for the translation, and those of the parent for a joint, which show in which
//! directions it rotates. Along each direction the part of the motion is bounded from below by a
//! part of the errors along it; the generalised eigenvectors of both are these directions, so that
//! the result does not depend on how the axes are turned.
//!
//! Few independent differences show a matrix less well than its mean along all directions. The
//! matrix is the mean of both, the second one with the weight of [`PRIOR`] differences: what is
//! expected after n Gaussian vectors under an inverse Wishart distribution (A. Gelman et al.,
//! Bayesian Data Analysis, 2013, section 3.6).

use nalgebra_035::{Cholesky, Matrix3, SymmetricEigen};

use super::super::chain::{Chain, State};
use super::differences::{components, difference, kinds};

/// The part of the errors that a motion too small to be seen may have.
const UNSEEN: f64 = 0.1;
/// The least variance beside squares of metres and radians, so that its inverse is finite.
const LEAST: f64 = 1e-14;
/// How many differences it counts that all directions are alike: as many as there are directions.
const PRIOR: f64 = 3.0;

/// Accelerations of a human who moves without haste, in m/s² and in rad/s², for clips that are too
/// short to show their own.
const TRANSLATION: f64 = 5.0;
const ROTATION: f64 = 20.0;

/// The inverse covariances of the second differences over one frame: that of the translation, and
/// that of each joint; 0 for a joint that does not rotate.
pub(super) fn precisions(
    chain: &Chain<'_>,
    states: &[State],
    frames_per_second: f64,
) -> Vec<Matrix3<f64>> {
    let usual = |kind| {
        let acceleration = if kind == 0 { TRANSLATION } else { ROTATION };
        Matrix3::identity() * (acceleration / frames_per_second.powi(2)).powi(2)
    };
    let kinds = (0..kinds(chain)).map(|kind| match components(chain, kind) {
        0 => Matrix3::zeros(),
        _ => {
            let found = covariance(chain, states, kind).unwrap_or(usual(kind));
            let inverse = Cholesky::new(found).map(|factor| factor.inverse());
            inverse.unwrap_or_else(|| Matrix3::identity() / found.trace().max(LEAST))
        }
    });
    kinds.collect()
}

/// The covariance of second differences over one frame; that of a hinge is the same along all
/// directions. `None` where there are too few frames.
fn covariance(chain: &Chain<'_>, states: &[State], kind: usize) -> Option<Matrix3<f64>> {
    let errors = moment(chain, states, kind, 1)?;
    let (mut found, mut lag) = (None, 2);
    while let Some(square) = moment(chain, states, kind, lag) {
        let growth = gain(lag);
        let independent = states.len() as f64 / lag as f64;
        let excess = (square - errors) / (growth - 1.0);
        found = Some((excess, errors * (UNSEEN / growth), independent));
        if square.trace() >= 2.0 * errors.trace() {
            break;
        }
        lag += lag.div_ceil(2);
    }
    let (excess, least, independent) = found?;
    let components = components(chain, kind) as f64;
    let variance = excess.trace().max(least.trace()) / components;
    let alike = Matrix3::identity() * variance.max(LEAST);
    let least = least + Matrix3::identity() * LEAST;
    match bounded(&excess, &least).filter(|_| components > 1.0) {
        Some(own) => Some((own * independent + alike * PRIOR) / (independent + PRIOR)),
        None => Some(alike),
    }
}

/// A symmetric matrix, with a part along each direction that is at least that of another one, which
/// is positive definite. `None` where that is not so in floating point.
fn bounded(matrix: &Matrix3<f64>, least: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let lower = Cholesky::new(*least)?.unpack();
    let inverse = lower.try_inverse()?;
    let relative = inverse * matrix * inverse.transpose();
    let mut eigen = SymmetricEigen::new(relative);
    eigen.eigenvalues.apply(|value| *value = value.max(1.0));
    Some(lower * eigen.recompose() * lower.transpose())
}

/// `Σ (m − |i|)²`.
fn gain(lag: usize) -> f64 {
    let m = lag as f64;
    m * (2.0 * m * m + 1.0) / 3.0
}

/// The mean outer product of second differences over `lag` frames. `None` where there are not
/// enough frames to say.
fn moment(chain: &Chain<'_>, states: &[State], kind: usize, lag: usize) -> Option<Matrix3<f64>> {
    let few = lag > 1 && states.len() < 4 * lag;
    let triples = (lag..states.len().saturating_sub(lag)).filter_map(|t| {
        let states = [&states[t - lag], &states[t], &states[t + lag]];
        let value = difference(chain, states, kind)?.value;
        Some(value * value.transpose())
    });
    let (sum, count) = triples.fold((Matrix3::zeros(), 0), |(sum, count), product| {
        (sum + product, count + 1)
    });
    (!few && count > 0).then(|| sum / f64::from(count))
}

#[cfg(test)]
mod tests {
    use ga_runtime::cga3::Rotor;
    use ga_runtime::vga3::Vector;
    use nalgebra_035::Vector3;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    use super::*;
    use crate::example;

    /// Frames with a translation, and with a rotation of the first joint below the root.
    fn moved(
        chain: &Chain<'_>,
        frames: impl Iterator<Item = (Vector3<f64>, Vector3<f64>)>,
    ) -> Vec<State> {
        let frame = |(translation, rotation): (Vector3<f64>, Vector3<f64>)| {
            let mut rotors = vec![Rotor::default(); chain.columns.len()];
            rotors[1] = Rotor::from_rotation_vector(rotation.into()).expect("finite");
            let translation = Vector::from(<[f64; 3]>::from(translation));
            State {
                translation,
                rotors,
            }
        };
        frames.map(frame).collect()
    }

    /// A body that accelerates by the same amount in each frame, and whose first joint rotates
    /// about one axis likewise.
    fn accelerated(chain: &Chain<'_>, count: usize) -> Vec<State> {
        let frames = (0..count).map(|t| 0.5 * (t * t) as f64);
        let frames = frames.map(|half| (TRANSLATED * half, Vector3::y() * (0.004 * half)));
        moved(chain, frames)
    }

    const TRANSLATED: Vector3<f64> = Vector3::new(0.02, -0.01, 0.03);

    #[test]
    fn second_differences_of_an_acceleration_grow_with_the_square_of_the_time() {
        let model = example::model();
        let chain = Chain::new(&model);
        let states = accelerated(&chain, 20);
        let rotated = Vector3::y() * 0.004;
        for lag in [1, 2, 3, 5] {
            let squared = (lag as f64).powi(4);
            for (kind, vector) in [(0, TRANSLATED), (2, rotated)] {
                let found = moment(&chain, &states, kind, lag).unwrap();
                let expected = vector * vector.transpose() * squared;
                let error = (found - expected).norm();
                assert!(error < 1e-9 * expected.norm(), "{kind} {lag}: {found}");
            }
        }
        assert!(moment(&chain, &states, 0, 6).is_none());
    }

    #[test]
    fn an_acceleration_is_told_from_errors() {
        let model = example::model();
        let chain = Chain::new(&model);
        let states = accelerated(&chain, 20);
        // Over two frames the moment is 16 times that over one: (16 − 1) / (6 − 1). There are ten
        // such differences, beside three for a third of it along all directions.
        for (kind, vector) in [(0, TRANSLATED), (2, Vector3::y() * 0.004)] {
            let found = covariance(&chain, &states, kind).unwrap();
            let own = vector * vector.transpose() * 3.0;
            let expected = own * 10.0 + Matrix3::identity() * (own.trace() / 3.0 * 3.0);
            let error = (found - expected / 13.0).norm();
            assert!(error < 1e-6 * found.norm(), "{kind}: {found}");
        }
        // A joint that rests has the least variance.
        let rest = covariance(&chain, &states, 3).unwrap();
        assert!((rest - Matrix3::identity() * LEAST).norm() < 1e-6 * LEAST);
        // Two frames show no acceleration: the usual ones, 5 m/s² and 20 rad/s².
        let usual = precisions(&chain, &accelerated(&chain, 2), 10.0);
        assert!((usual[0] * 0.0025 - Matrix3::identity()).norm() < 1e-12);
        assert!((usual[2] * 0.04 - Matrix3::identity()).norm() < 1e-12);
    }

    /// Random accelerations are found with their directions beside errors, alike in all or not.
    #[test]
    fn the_covariance_of_random_accelerations_is_found() {
        const FRAMES: usize = 4000;
        let model = example::model();
        let chain = Chain::new(&model);
        let mut random = ChaCha8Rng::seed_from_u64(7);
        // Twelve uniform numbers have the variance of a normal one.
        let mut normal = || -> f64 {
            let sum: f64 = (0..12).map(|_| f64::from(random.next_u32())).sum();
            sum / f64::from(u32::MAX) - 6.0
        };
        let across = Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.8, 0.6, 0.0, -0.6, 0.8);
        let in_depth = Matrix3::from_diagonal(&Vector3::new(0.004, 0.004, 0.016));
        for deviations in [Vector3::repeat(1e-3), Vector3::new(3e-4, 1e-3, 2e-3)] {
            let axes = across * Matrix3::from_diagonal(&deviations);
            let (mut place, mut step) = (Vector3::zeros(), Vector3::zeros());
            let frames = (0..FRAMES).map(|_| {
                place += step;
                step += axes * Vector3::from_fn(|_, _| normal());
                let error = in_depth * Vector3::from_fn(|_, _| normal());
                (place + error, Vector3::zeros())
            });
            let states = moved(&chain, frames);
            let found = covariance(&chain, &states, 0).unwrap();
            let expected = axes * axes.transpose();
            let error = (found - expected).norm() / expected.norm();
            assert!(error < 0.3, "{error}: {found} {expected}");
        }
    }
}
