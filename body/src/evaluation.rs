//! How far reconstructed bodies are from true ones: the observations that cameras would make of a
//! known motion, and the errors of what is found from them.
//!
//! | score | formula for the joints p and the reconstructed q of a frame |
//! | --- | --- |
//! | mean per joint position error | mean of `\|q − p\|` |
//! | relative to the root | mean of `\|(q − q₀) − (p − p₀)\|` with the first joint as the root |
//! | aligned (Procrustes) | mean of `\|S q ~S − p\|` for the similarity S of least squares |
//! | 2-D joint error | mean of `\|π(q) − π(p)\|` over all views |
//!
//! Scores are means over frames, in metres and in pixels. The joints that were not found are left
//! out, so scores of methods that find other joints are to be read with the part that each found.

use ga_runtime::cga3::Point;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::{JointPixel, Observation};
use crate::BodyError;
use crate::pose_error::{mean_per_joint_position_error, procrustes_aligned, root_aligned_error};
use ga_camera::Camera;
use ga_camera::observation::observe;
use ga_camera::triangulation::triangulate_views;

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

/// Mean errors over the frames of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scores {
    /// The mean per joint position error in metres.
    pub position_error: f64,
    /// The same relative to the root, in metres, over the frames that have it.
    pub root_relative_error: Option<f64>,
    /// The error after Procrustes alignment without reflection in metres, over the frames with
    /// three joints or more.
    pub aligned_error: Option<f64>,
    /// The mean distance in the pictures from where the joints truly are, in pixels, over all views
    /// in front of whose cameras both are.
    pub joint_error_px: f64,
    /// The part of all joints that was found.
    pub found: f64,
}

/// The scores of reconstructed joints, `None` for those that were not found. The first joint is the
/// root.
///
/// # Errors
/// [`BodyError`] for other numbers of frames or joints than the true motion has, for joints
/// that are not finite, and where no joint was found.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_body::evaluation::score;
/// use ga_camera::{Camera, Intrinsics};
///
/// let intrinsics = Intrinsics::new([1000.0, 1000.0], [0.0, 0.0])?;
/// let camera = Camera { intrinsics, world_to_camera: Default::default() };
/// let truth = vec![[[0.0, 0.0, 4.0], [1.0, 0.0, 4.0], [0.0, 1.0, 4.0]].map(Point::from).to_vec()];
/// let mut found = vec![truth[0].iter().copied().map(Some).collect::<Vec<_>>()];
/// found[0][1] = Some(Point::new(1.0, 0.0, 4.3));
/// found[0][2] = None;
/// let scores = score(&[camera], &truth, &found)?;
/// assert!((scores.position_error - 0.15).abs() < 1e-12);
/// assert_eq!(scores.aligned_error, None);
/// // 1 m to the side is at 250 px from 4 m, and at 232.6 px from 4.3 m.
/// assert!((scores.joint_error_px - 0.5 * (250.0 - 1000.0 / 4.3)).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn score(
    cameras: &[Camera],
    truth: &[Vec<Point<f64>>],
    found: &[Vec<Option<Point<f64>>>],
) -> Result<Scores, BodyError> {
    if truth.len() != found.len() {
        return Err(BodyError::JointCounts {
            expected: truth.len(),
            found: found.len(),
        });
    }
    let [
        mut position,
        mut relative,
        mut aligned,
        mut pixels,
        mut part,
    ] = [Mean::default(); 5];
    for (truth, found) in truth.iter().zip(found) {
        if truth.len() != found.len() {
            return Err(BodyError::JointCounts {
                expected: truth.len(),
                found: found.len(),
            });
        }
        let pairs = truth.iter().zip(found);
        let pairs = pairs.filter_map(|(&truth, &found)| Some((truth, found?)));
        let (truths, founds): (Vec<_>, Vec<_>) = pairs.unzip();
        part.add(truths.len() as f64 / truth.len().max(1) as f64);
        if truths.is_empty() {
            continue;
        }
        position.add(mean_per_joint_position_error(&truths, &founds)?);
        if found[0].is_some() {
            relative.add(root_aligned_error(&truths, &founds, 0)?);
        }
        if let Ok(fit) = procrustes_aligned(&truths, &founds) {
            aligned.add(fit.mean_error);
        }
        for camera in cameras {
            for (truth, found) in truths.iter().zip(&founds) {
                if let (Ok([u, v]), Ok(there)) = (camera.project(*truth), camera.project(*found)) {
                    pixels.add((there[0] - u).hypot(there[1] - v));
                }
            }
        }
    }
    Ok(Scores {
        position_error: position.value().ok_or(BodyError::NoJoints)?,
        root_relative_error: relative.value(),
        aligned_error: aligned.value(),
        joint_error_px: pixels.value().unwrap_or(0.0),
        found: part.value().unwrap_or(0.0),
    })
}

#[derive(Clone, Copy, Default)]
struct Mean {
    sum: f64,
    count: usize,
}

impl Mean {
    fn add(&mut self, value: f64) {
        self.sum += value;
        self.count += 1;
    }

    fn value(self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }
}
