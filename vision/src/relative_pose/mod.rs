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
mod cheirality;
mod degenerate;
mod five_point;
mod fundamental;
mod matrix;
mod rotation;
mod sampson;
mod summary;
pub(crate) mod view;

use ga_runtime::cga3::Motor;
use ga_runtime::vga3::Vector;

pub use bearing::Bearing;
pub use five_point::five_point;
pub use fundamental::{
    Fundamental, FundamentalOptions, eight_point, estimate_fundamental, seven_point,
};
pub use matrix::{EssentialMatrix, FundamentalMatrix};
pub use sampson::BearingPair;
pub use summary::MotionSummary;
pub use view::View;

use crate::feature::PixelPair;
use crate::geometry_error::ViewGeometryError;
use ga_camera::Intrinsics;
use ga_camera::frame::{LeftCamera, Pose, RightCamera};
use ga_numerics::least_squares::{self, Covariance, Minimum, minimise};
use ga_numerics::ransac::{Consensus, Search};
use sampson::{SampsonCost, across_translation};

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
    /// The covariance of a small motion that follows the result, `exp(B) M`, with the rotation
    /// vector of B in radians and then its velocity of the origin, which is across the translation;
    /// to first order, from the distances that remain. `None` where there are no more than five
    /// pairs. Pairs count as independent: where one corner was paired in several scales of the
    /// views, as [`match_views`](crate::feature::match_views) does, the variances are too small.
    pub covariance: Option<[[f64; 6]; 6]>,
}

impl RelativePose {
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
/// that agree least, over motors; several starts are refined, since that sum has local minima. Of
/// the four motions with the resulting essential matrix, that one is taken which has the points in
/// front of both cameras.
///
/// # Errors
/// [`ViewGeometryError`]: fewer than six pairs, pixels that are not finite or on one line, a
/// rotation alone explains the pairs, or too few of them agree.
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
    degenerate::check_finite(pixels)?;
    degenerate::check_lines(pixels, 0.0)?;
    let search = Search {
        threshold: options.threshold,
        confidence: options.confidence,
        least_samples: 100,
        samples: options.samples,
        seed: options.seed,
    };
    let Some(refined) = refine_best(pairs, &search) else {
        check_rotation(pairs, &search, NEEDED, f64::INFINITY)?;
        return Err(ViewGeometryError::Undetermined);
    };
    let Refined {
        minimum,
        inliers,
        selected,
    } = refined;
    if !degenerate::is_consensus(pixels, inliers.len(), options.threshold) {
        return Err(ViewGeometryError::NoConsensus {
            agreeing: inliers.len(),
            pairs: pairs.len(),
        });
    }
    let agreeing: Vec<PixelPair> = inliers.iter().map(|&k| pixels[k]).collect();
    degenerate::check_lines(&agreeing, minimum.root_mean_square())?;
    let variance = minimum.variance();
    check_rotation(
        &selected,
        &search,
        inliers.len(),
        variance.unwrap_or(f64::INFINITY),
    )?;

    let essential = EssentialMatrix::from_motor(minimum.state);
    let motors = essential.and_then(|essential| essential.motors());
    let motors = motors.ok_or(ViewGeometryError::Undetermined)?;
    let (nearest, in_front) = cheirality::most_in_front(motors, &selected);
    if 2 * in_front <= inliers.len() {
        return Err(ViewGeometryError::Behind {
            in_front,
            pairs: inliers.len(),
        });
    }
    // The same minimum, in the coordinates of the motion that was chosen.
    let problem = SampsonCost { pairs: &selected };
    let minimum = minimise(&problem, nearest, &least_squares::Options::default())
        .map_err(|_| ViewGeometryError::Undetermined)?;
    let covariance = variance.and_then(|variance| minimum.covariance(variance));
    Ok(RelativePose {
        left_to_right: Pose::new(minimum.state),
        in_front,
        root_mean_square: minimum.root_mean_square(),
        covariance: covariance.map(|covariance| of_twist(&covariance, minimum.state)),
        inliers,
    })
}

/// The least sum of squares over the pairs that agree.
struct Refined {
    minimum: Minimum<Motor<f64>>,
    inliers: Vec<usize>,
    selected: Vec<BearingPair>,
}

/// Refines the best essential matrices of random samples, and then the best results with all pairs
/// that agree.
fn refine_best(pairs: &[BearingPair], search: &Search) -> Option<Refined> {
    /// Starts for a first refinement.
    const STARTS: usize = 16;
    /// Pairs that take part in a first refinement.
    const FEW: usize = 300;
    /// Results of it that are refined with all pairs that agree.
    const FINALISTS: usize = 3;
    /// How often the pairs that agree are collected anew.
    const ROUNDS: usize = 10;

    let problem = Bearings(pairs);
    let options = least_squares::Options::default();
    let rate = |motor: Motor<f64>| {
        let essential = EssentialMatrix::from_motor(motor)?;
        let candidate = search.rate(&problem, essential, f64::INFINITY)?;
        Some((candidate.cost, motor))
    };
    let starts = search
        .run(&problem, STARTS)
        .into_iter()
        .filter_map(|candidate| {
            let agreeing = search.inliers(&problem, &candidate.model);
            let stride = agreeing.len().div_ceil(FEW).max(1);
            let few: Vec<_> = agreeing.iter().step_by(stride).map(|&k| pairs[k]).collect();
            let start = candidate.model.motors()?[0];
            let refined = minimise(&SampsonCost { pairs: &few }, start, &options);
            rate(refined.map_or(start, |minimum| minimum.state))
        });
    let mut starts: Vec<_> = starts.collect();
    // The sort is stable, so that equal costs keep the order of the samples.
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    starts.truncate(FINALISTS);

    let mut best: Option<(f64, Refined)> = None;
    for (_, mut motor) in starts {
        let mut last = Vec::new();
        for _ in 0..ROUNDS {
            let Some(essential) = EssentialMatrix::from_motor(motor) else {
                break;
            };
            let inliers = search.inliers(&problem, &essential);
            if inliers == last {
                break;
            }
            let selected: Vec<_> = inliers.iter().map(|&k| pairs[k]).collect();
            last.clone_from(&inliers);
            let Ok(minimum) = minimise(&SampsonCost { pairs: &selected }, motor, &options) else {
                break;
            };
            motor = minimum.state;
            let Some((cost, _)) = rate(motor) else { break };
            let refined = Refined {
                minimum,
                inliers,
                selected,
            };
            if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                best = Some((cost, refined));
            }
        }
    }
    best.map(|(_, refined)| refined)
}

/// Refuses pairs that a rotation explains about as well as a motion with a translation.
fn check_rotation(
    pairs: &[BearingPair],
    search: &Search,
    agreeing: usize,
    variance: f64,
) -> Result<(), ViewGeometryError> {
    /// The part of the pairs that must agree with the rotation.
    const PART: f64 = 0.9;
    /// Variances whose quotient is below this are about equal.
    const RATIO: f64 = 2.0;
    /// The standard deviation, in pixels, that rounding may cause.
    const ROUNDING: f64 = 1e-7;
    let Some(fit) = rotation::fit_rotation(pairs, search) else {
        return Ok(());
    };
    let explains_most = fit.inliers as f64 >= PART * agreeing as f64;
    if explains_most && fit.variance < RATIO * variance.max(ROUNDING * ROUNDING) {
        return Err(ViewGeometryError::PureRotation {
            rotation_rms: fit.variance.sqrt(),
            motion_rms: variance.sqrt(),
        });
    }
    Ok(())
}

/// The covariance of a twist, from that of a rotation and two coordinates across the translation.
fn of_twist(covariance: &Covariance, motor: Motor<f64>) -> [[f64; 6]; 6] {
    let [a, b] = across_translation(motor);
    let axes = [Vector::X, Vector::Y, Vector::Z].map(Vector::coordinates);
    let (a, b) = (a.coordinates(), b.coordinates());
    // The rows of the linear map from the five coordinates to the six of the twist.
    let map: [[f64; 5]; 6] = std::array::from_fn(|row| match row {
        0..3 => {
            let [x, y, z] = axes[row];
            [x, y, z, 0.0, 0.0]
        }
        _ => [0.0, 0.0, 0.0, a[row - 3], b[row - 3]],
    });
    let product = |row: usize, column: usize| -> f64 {
        let terms = (0..25).map(|k| {
            let (i, j) = (k / 5, k % 5);
            map[row][i] * covariance.shared(i, j) * map[column][j]
        });
        terms.sum()
    };
    std::array::from_fn(|row| std::array::from_fn(|column| product(row, column)))
}

struct Bearings<'a>(&'a [BearingPair]);

impl Consensus for Bearings<'_> {
    type Model = EssentialMatrix;

    const SAMPLE: usize = 5;

    fn count(&self) -> usize {
        self.0.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<EssentialMatrix>) {
        let directions = |k: usize| {
            let BearingPair { left, right } = &self.0[sample[k]];
            [left.direction, right.direction]
        };
        models.extend(five_point(&std::array::from_fn(directions)));
    }

    fn squared_error(&self, model: &EssentialMatrix, observation: usize) -> f64 {
        self.0[observation].sampson_distance_by(model).powi(2)
    }
}
