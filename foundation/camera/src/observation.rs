//! Simulated observations: the pixels of known points, exact or with noise.

use ga_runtime::cga3::Point;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal};

use crate::Camera;
use crate::triangulation::TriangulationError;

/// The pixels at which a camera sees points, each coordinate with independent Gaussian noise of the
/// given standard deviation in pixels. Equal seeds give equal noise on every machine.
///
/// # Errors
/// [`TriangulationError`] for the first point that the camera does not see, or for noise that is
/// negative or not finite.
pub fn observe(
    camera: &Camera,
    points: &[Point<f64>],
    noise: f64,
    seed: u64,
) -> Result<Vec<[f64; 2]>, TriangulationError> {
    if !noise.is_finite() || noise < 0.0 {
        return Err(TriangulationError::Noise(noise));
    }
    let normal = Normal::new(0.0, noise).map_err(|_| TriangulationError::Noise(noise))?;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let exact = camera
        .project_all(points)
        .map_err(|(point, error)| TriangulationError::Unseen { point, error })?;
    let noisy = |pixel: [f64; 2]| pixel.map(|u| u + normal.sample(&mut random));
    Ok(exact.into_iter().map(noisy).collect())
}
