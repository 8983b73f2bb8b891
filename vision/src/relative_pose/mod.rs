//! How two views are related: the epipolar geometry of pairs of pixels.
//!
//! Rays are lines of conformal geometric algebra. For calibrated cameras, [`estimate`] finds the
//! motor M from the left camera's frame to the right one's for which the rays of paired pixels
//! meet, `M l ~M ∨ r = 0`: the translation up to its length, which two views do not show. For
//! cameras that are not calibrated, [`estimate_fundamental`] finds the fundamental matrix.
//!
//! - [`Bearing`]: the direction in which a camera sees a pixel, its ray and its derivatives.
//! - [`BearingPair`]: the epipolar condition, and its first-order distance in pixels.
//! - [`five_point`], [`seven_point`], [`eight_point`]: matrices of few pairs.

mod bearing;
mod candidate;
mod cheirality;
mod degenerate;
mod deviation;
mod five_point;
mod fundamental;
mod matrix;
mod planar;
mod rotation;
mod sampson;
mod summary;
pub(crate) mod view;

pub use bearing::Bearing;
pub use five_point::five_point;
pub use fundamental::{
    Fundamental, FundamentalOptions, eight_point, estimate_fundamental, seven_point,
};
pub use matrix::{EssentialMatrix, FundamentalMatrix};
pub use sampson::BearingPair;
pub use summary::{AlternativeMotion, MotionSummary};
pub use view::View;

use crate::feature::PixelPair;
use crate::geometry_error::ViewGeometryError;
use crate::rival::{is_rival, is_same};
use candidate::{Candidate, Settled, angles_between, candidates};
use ga_camera::Intrinsics;
use ga_camera::frame::{LeftCamera, Pose, RightCamera};
use ga_numerics::least_squares::{self, minimise};
use ga_numerics::ransac::Search;
use sampson::SampsonCost;

/// How a relative pose is searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Pairs with a smaller Sampson distance agree with a motion, in pixels.
    pub threshold: f64,
    /// The probability with which a sample without wrong pairs is to be drawn.
    pub confidence: f64,
    /// The greatest number of samples.
    pub samples: usize,
    /// The seed of the random samples. Equal seeds give equal results.
    pub seed: u64,
}

impl Default for Options {
    /// 1 px, 0.9999, 5000 samples, seed 1.
    fn default() -> Self {
        Self {
            threshold: 1.0,
            confidence: 0.9999,
            samples: 5000,
            seed: 1,
        }
    }
}

/// The motion between two cameras, with a translation of length 1.
#[derive(Clone, Debug, PartialEq)]
pub struct RelativePose {
    /// The motor that takes the left camera's frame to the right one's. Its translation has length
    /// 1, since two views do not show the scale of a scene.
    pub left_to_right: Pose<LeftCamera, RightCamera>,
    /// The indices of the pairs that agree, rising.
    pub inliers: Vec<usize>,
    /// How many of these are in front of both cameras.
    pub in_front: usize,
    /// The root mean square of the Sampson distances of the pairs that agree, in pixels.
    pub root_mean_square: f64,
    /// The covariance C of a small motion that follows the result, `exp(B) M`, with the rotation
    /// vector of B in radians and then its velocity of the origin, which is across the translation;
    /// to second order, from the distances that remain. It is so much larger for few pairs
    /// ([`region_factor`](ga_numerics::least_squares::region_factor)) that in the five coordinates
    /// of a motion, three of the rotation and two across the translation, the step b to the true
    /// motion satisfies `bᵀ C⁻¹ b ≤ 11.07`, the 95 % quantile of the χ² distribution with 5 degrees
    /// of freedom, with the probability 95 %. `None` for up to seven pairs, and where the threshold
    /// is too small against the noise for the pairs to show it. The errors of neighbouring pairs
    /// may be alike, as those of a corner that [`match_views`](crate::feature::match_views) finds
    /// in several scales: it is greater by as much as their distances are.
    pub covariance: Option<[[f64; 6]; 6]>,
    /// Other motions that explain the pairs as well, within noise, with points in front of both
    /// cameras: the best first, and each without alternatives of its own. Two views of a plane
    /// often have two motions.
    pub alternatives: Vec<RelativePose>,
}

impl RelativePose {
    /// Whether other motions explain the pairs as well.
    #[must_use]
    pub fn is_ambiguous(&self) -> bool {
        !self.alternatives.is_empty()
    }

    /// The standard deviation of the rotation in radians: the root of the sum of the variances
    /// about three axes.
    #[must_use]
    pub fn rotation_deviation(&self) -> Option<f64> {
        self.deviation(0)
    }

    /// The standard deviation of the direction of the translation in radians: the root of the sum
    /// of the variances across it.
    #[must_use]
    pub fn direction_deviation(&self) -> Option<f64> {
        self.deviation(3)
    }

    fn deviation(&self, first: usize) -> Option<f64> {
        let covariance = self.covariance?;
        let sum: f64 = (first..first + 3).map(|k| covariance[k][k]).sum();
        Some(sum.max(0.0).sqrt())
    }
}

/// Leaves out pairs with a pixel that has no direction, as near the corners of a view, where the
/// distortion of a wide lens may not be invertible. Returns how many they were.
pub fn retain_in_field(pairs: &mut Vec<PixelPair>, left: &Intrinsics, right: &Intrinsics) -> usize {
    let before = pairs.len();
    pairs.retain(|pair| left.direction(pair.left).is_ok() && right.direction(pair.right).is_ok());
    before - pairs.len()
}

/// The motion between two calibrated cameras from pairs of pixels, of which some may be wrong.
///
/// Random samples of five pairs give essential matrices ([`five_point`]). From the best of them
/// Levenberg and Marquardt's method makes the sum of the squared Sampson distances of the pairs
/// that agree least, over motors; several starts are refined, since that sum has local minima. Two
/// more starts are the motions of the [homography](crate::homography::Homography::motions) with
/// which most of these pairs agree. Of the four motions with each of the essential matrices, that
/// one is taken which explains the pairs best with points in front of both cameras. Where others
/// explain them as well, they are its [alternatives](RelativePose::alternatives).
///
/// # Errors
/// [`ViewGeometryError`]: fewer than six pairs, a threshold that is not positive and finite, pixels
/// that are not finite, on one line or near one place, a rotation alone explains the pairs, too few
/// of them agree, or the motion is not determined to half a radian.
///
/// ```
/// use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
/// use ga_camera::{Camera, Intrinsics};
/// use ga_vision::feature::PixelPair;
/// use ga_vision::relative_pose::{Options, estimate};
///
/// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
/// let rotor = Rotor::from_axis_angle([0.0, 1.0, 0.0], 0.1).unwrap();
/// let motion: Motor<f64> = Translator::from_displacement([-0.6, 0.0, 0.8]) * rotor;
/// let left = Camera { intrinsics, world_to_camera: Motor::default() };
/// let right = Camera { intrinsics, world_to_camera: motion };
///
/// let mut pairs = Vec::new();
/// for k in 0..20 {
///     let k = f64::from(k);
///     let point = Point::new((7.0 * k).sin(), (5.0 * k).cos(), 6.0 + (3.0 * k).sin());
///     pairs.push(PixelPair { left: left.project(point)?, right: right.project(point)? });
/// }
/// let found = estimate(&pairs, &intrinsics, &intrinsics, &Options::default())?;
/// let [x, y, z] = found.left_to_right.motor.translator().displacement();
/// assert!((x + 0.6).abs() < 1e-9 && y.abs() < 1e-9 && (z - 0.8).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn estimate(
    pairs: &[PixelPair],
    left: &Intrinsics,
    right: &Intrinsics,
    options: &Options,
) -> Result<RelativePose, ViewGeometryError> {
    degenerate::check_finite(pairs)?;
    let bearings: Result<Vec<_>, ViewGeometryError> = pairs
        .iter()
        .enumerate()
        .map(|(pair, pixels)| {
            let error = |view| move |error| ViewGeometryError::Camera { pair, view, error };
            Ok(BearingPair {
                left: Bearing::of_pixel(left, pixels.left).map_err(error(View::Left))?,
                right: Bearing::of_pixel(right, pixels.right).map_err(error(View::Right))?,
            })
        })
        .collect();
    estimate_from_bearings(pairs, &bearings?, options)
}

/// The same for any cameras, from the directions in which they see the pixels.
///
/// # Errors
/// As [`estimate`], and where there are not as many directions as pairs of pixels.
pub fn estimate_from_bearings(
    pixels: &[PixelPair],
    pairs: &[BearingPair],
    options: &Options,
) -> Result<RelativePose, ViewGeometryError> {
    /// Five pairs have up to ten solutions; a sixth selects one of them.
    const NEEDED: usize = 6;
    /// Standard deviations in radians above which a motion is not determined.
    const UNCERTAIN: f64 = 0.5;
    if pixels.len() != pairs.len() {
        return Err(ViewGeometryError::Counts {
            pixels: pixels.len(),
            directions: pairs.len(),
        });
    }
    if pairs.len() < NEEDED {
        return Err(ViewGeometryError::TooFew {
            found: pairs.len(),
            needed: NEEDED,
        });
    }
    if !(options.threshold.is_finite() && options.threshold > 0.0) {
        return Err(ViewGeometryError::MatchThreshold(options.threshold));
    }
    degenerate::check_finite(pixels)?;
    degenerate::check_lines(pixels, 0.0)?;
    let search = Search {
        threshold: options.threshold,
        confidence: options.confidence,
        least_samples: 100,
        samples: options.samples,
        seed: options.seed,
    };
    let (minima, candidates) = candidates(pairs, &search);
    let Some(best) = candidates.first() else {
        rotation::check(pairs, &search, NEEDED, f64::INFINITY)?;
        return Err(ViewGeometryError::Undetermined);
    };
    let Settled {
        minimum,
        inliers,
        selected,
        ..
    } = &minima[best.settled];
    if !degenerate::is_consensus(pixels, inliers.len(), options.threshold) {
        return Err(ViewGeometryError::NoConsensus {
            agreeing: inliers.len(),
            pairs: pairs.len(),
        });
    }
    let agreeing: Vec<PixelPair> = inliers.iter().map(|&k| pixels[k]).collect();
    degenerate::check_lines(&agreeing, minimum.root_mean_square())?;
    let variance = minimum.variance().unwrap_or(f64::INFINITY);
    rotation::check(selected, &search, inliers.len(), variance)?;
    if 2 * best.in_front <= inliers.len() {
        return Err(ViewGeometryError::Behind {
            in_front: best.in_front,
            pairs: inliers.len(),
        });
    }
    let mut found = RelativePose::new(best, &minima[best.settled], pixels, options)?;
    found.alternatives = alternatives(&found, &minima, &candidates, pixels, options)?;
    // Between motions of which one is not determined, the others claim too much.
    let poses = std::iter::once(&found).chain(&found.alternatives);
    let deviations = poses.flat_map(|pose| [pose.rotation_deviation(), pose.direction_deviation()]);
    let deviation = deviations.flatten().fold(0.0, f64::max);
    match deviation > UNCERTAIN {
        true => Err(ViewGeometryError::Uncertain {
            degrees: deviation.to_degrees(),
        }),
        false => Ok(found),
    }
}

/// The candidates that explain the pairs as well as the first one, in another way.
fn alternatives(
    found: &RelativePose,
    minima: &[Settled],
    candidates: &[Candidate],
    pixels: &[PixelPair],
    options: &Options,
) -> Result<Vec<RelativePose>, ViewGeometryError> {
    let mut alternatives: Vec<RelativePose> = Vec::new();
    let [best, others @ ..] = candidates else {
        return Ok(alternatives);
    };
    let first = &minima[best.settled];
    let variance = first.minimum.variance().unwrap_or(0.0);
    let agreeing: Vec<PixelPair> = first.inliers.iter().map(|&k| pixels[k]).collect();
    let problem = SampsonCost {
        pairs: &first.selected,
    };
    let correlation = deviation::correlation(&problem, first.minimum.state, &agreeing);
    for other in others {
        let settled = &minima[other.settled];
        let part = other.in_front as f64 / settled.inliers.len() as f64;
        let squares: [&[f64]; 2] = [&best.squares, &other.squares];
        if part <= 0.5 || !is_rival(squares, variance, 1, correlation) {
            continue;
        }
        let pose = RelativePose::new(other, settled, pixels, options)?;
        if !found.is_near(&pose) && !alternatives.iter().any(|known| known.is_near(&pose)) {
            alternatives.push(pose);
        }
    }
    Ok(alternatives)
}

impl RelativePose {
    /// The motion of a candidate, which explains the same as the minimum that it belongs to.
    fn new(
        candidate: &Candidate,
        settled: &Settled,
        pixels: &[PixelPair],
        options: &Options,
    ) -> Result<Self, ViewGeometryError> {
        let problem = SampsonCost {
            pairs: &settled.selected,
        };
        // The same minimum, in the coordinates of the motion that was chosen.
        let minimum = minimise(
            &problem,
            candidate.motor,
            &least_squares::Options::default(),
        );
        let minimum = minimum.map_err(|_| ViewGeometryError::Undetermined)?;
        let agreeing: Vec<PixelPair> = settled.inliers.iter().map(|&k| pixels[k]).collect();
        Ok(Self {
            left_to_right: Pose::new(minimum.state),
            in_front: candidate.in_front,
            root_mean_square: minimum.root_mean_square(),
            covariance: deviation::covariance(&problem, &minimum, &agreeing, options.threshold)?,
            inliers: settled.inliers.clone(),
            alternatives: Vec::new(),
        })
    }

    /// Whether another motion is within the deviations of this one, and so the same.
    fn is_near(&self, other: &Self) -> bool {
        let motors = [self, other].map(|pose| pose.left_to_right.motor);
        let deviations = [self.rotation_deviation(), self.direction_deviation()];
        is_same(
            angles_between(motors[0], motors[1])
                .into_iter()
                .zip(deviations),
        )
    }
}
