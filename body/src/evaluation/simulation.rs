//! What cameras would show of a known motion.

use ga_camera::Camera;
use ga_camera::observation::observe;
use ga_camera::triangulation::triangulate_views;
use ga_runtime::cga3::Point;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::{BodyError, JointPixel, Observation};

/// What is wrong with the pixels of cameras that observe a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disturbance {
    /// The standard deviation of Gaussian noise in each coordinate, in pixels.
    pub noise_px: f64,
    /// The probability that a view does not show a joint, from 0 to 1.
    pub missing: f64,
    /// Equal seeds give equal noise on every machine.
    pub seed: u64,
}

/// The deviation of pixels without noise: that of rounding, far below any real one.
const LEAST_DEVIATION: f64 = 0.05;

/// What cameras show of the points of a body in each frame of a motion, with noise and missing
/// joints. Each pixel has the deviation of the noise.
///
/// # Errors
/// [`BodyError`] for the first point that a camera does not see, for noise that is negative,
/// and a probability that is not from 0 to 1.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_body::evaluation::{Disturbance, simulate};
/// use ga_camera::{Camera, Intrinsics};
///
/// let intrinsics = Intrinsics::new([1000.0, 1000.0], [0.0, 0.0])?;
/// let camera = Camera { intrinsics, world_to_camera: Default::default() };
/// let motion = vec![vec![Point::new(0.4, 0.0, 4.0); 500]; 2];
/// let disturbance = Disturbance { noise_px: 2.0, missing: 0.2, seed: 1 };
/// let seen = simulate(&[camera], &motion, &disturbance)?;
/// let there = seen[1].views[0].iter().flatten().count();
/// assert!((370..430).contains(&there));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate(
    cameras: &[Camera],
    motion: &[Vec<Point<f64>>],
    disturbance: &Disturbance,
) -> Result<Vec<Observation>, BodyError> {
    let missing = disturbance.missing;
    if !(0.0..=1.0).contains(&missing) {
        return Err(BodyError::Missing(missing));
    }
    let deviation = disturbance.noise_px.max(LEAST_DEVIATION);
    let mut seeds = ChaCha8Rng::seed_from_u64(disturbance.seed);
    let frames = motion.iter().enumerate().map(|(frame, points)| {
        let views = cameras.iter().enumerate().map(|(view, camera)| {
            let pixels = observe(camera, points, disturbance.noise_px, seeds.next_u64());
            let pixels = pixels.map_err(|error| BodyError::Observation {
                frame,
                view,
                error: Box::new(error),
            })?;
            let mut random = ChaCha8Rng::seed_from_u64(seeds.next_u64());
            let pixels = pixels.into_iter().map(|position| {
                // 53 random bits as a number from 0 to below 1.
                let chance = (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
                (chance >= missing).then_some(JointPixel {
                    position,
                    deviation,
                })
            });
            Ok(pixels.collect())
        });
        let views = views.collect::<Result<_, BodyError>>()?;
        Ok(Observation { views })
    });
    frames.collect()
}

/// The points of a frame that two views or more show, each triangulated by itself; `None` for the
/// others, and where the rays determine no point.
#[must_use]
pub fn triangulated_points(
    cameras: &[Camera],
    observation: &Observation,
) -> Vec<Option<Point<f64>>> {
    let count = observation.views.first().map_or(0, Vec::len);
    let point = |index: usize| {
        let seen = cameras.iter().zip(&observation.views);
        let seen = seen.filter_map(|(camera, view)| {
            let pixel = (*view.get(index)?)?;
            Some((*camera, pixel.position))
        });
        let (cameras, pixels): (Vec<Camera>, Vec<[f64; 2]>) = seen.unzip();
        let found = triangulate_views(&cameras, &pixels).ok()?;
        Some(found.position)
    };
    (0..count).map(point).collect()
}
