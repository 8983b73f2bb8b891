//! Simulated observations: the pixels of known points, exact or with noise.

use ga_runtime::cga3::Point;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal};

use crate::{Camera, CameraError};

/// Why points cannot be observed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ObservationError {
    /// The camera does not see a point.
    #[error("point {point}: {error}")]
    Camera {
        /// Which point, from 0.
        point: usize,
        /// What is wrong with it.
        error: CameraError,
    },
    /// The noise is negative or not finite.
    #[error("{0} px is not a standard deviation")]
    Noise(f64),
}

/// The pixels at which a camera sees points, each coordinate with independent Gaussian noise of the
/// given standard deviation in pixels. Equal seeds give equal noise on every machine.
///
/// # Errors
/// [`ObservationError`] for the first point that the camera does not see, or for noise that is
/// negative or not finite.
pub fn observe(
    camera: &Camera,
    points: &[Point<f64>],
    noise: f64,
    seed: u64,
) -> Result<Vec<[f64; 2]>, ObservationError> {
    if !noise.is_finite() || noise < 0.0 {
        return Err(ObservationError::Noise(noise));
    }
    let normal = Normal::new(0.0, noise).map_err(|_| ObservationError::Noise(noise))?;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let exact = camera
        .project_all(points)
        .map_err(|(point, error)| ObservationError::Camera { point, error })?;
    let noisy = |pixel: [f64; 2]| pixel.map(|u| u + normal.sample(&mut random));
    Ok(exact.into_iter().map(noisy).collect())
}
