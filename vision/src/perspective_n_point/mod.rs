//! Where a camera is that sees known points.
//!
//! [`estimate`] finds the pose with the least sum of squared distances between the pixels of known
//! points and the pixels at which the camera would see them, [`three_points`] the poses of a
//! minimal sample. The points may be in one plane, but not on one line.

mod three_points;

use ga_runtime::cga3::{DualQuaternion, Line, Motor, MotorGenerator, Plane, Point};
use ga_runtime::geometry::FitError;
use ga_runtime::vga3::Vector;

pub use three_points::three_points;

use crate::geometry_error::ViewGeometryError;
use crate::rival::{is_rival, is_same};
use ga_camera::{Camera, Intrinsics};
use ga_numerics::least_squares::{
    self, Columns, Covariance, Equations, Minimum, Problem, Region, minimise,
};
pub use ga_numerics::ransac::PoseOptions as Options;
use ga_numerics::ransac::{Consensus, Search, SelectedNoise};

/// Three points have up to four poses; a fourth selects one of them.
const NEEDED: usize = 4;

/// Where a camera is.
#[derive(Clone, Debug, PartialEq)]
pub struct PerspectivePose {
    /// The motor that takes the world into the camera's frame.
    pub world_to_camera: Motor<f64>,
    /// The indices of the points that agree, rising.
    pub inliers: Vec<usize>,
    /// The root mean square of the distances of their pixels from those of the pose, in pixels.
    pub root_mean_square: f64,
    /// The covariance C of a small motion that follows the pose, `exp(B) M`, with the rotation
    /// vector of B in radians and then its velocity of the origin in the unit of the points; to
    /// second order, from the distances that remain. It is so much larger for few points
    /// ([`region_factor`](least_squares::region_factor)) that the motion b to the true pose
    /// satisfies `bᵀ C⁻¹ b ≤ 12.59`, the 95 % quantile of the χ² distribution with 6 degrees of
    /// freedom, with the probability 95 %. `None` for four points, and where the points that agree
    /// do not show their noise.
    pub covariance: Option<[[f64; 6]; 6]>,
    /// Other poses that explain the pixels as well, within noise: the best first, and each without
    /// alternatives of its own. A plane that is small against its distance is seen almost alike
    /// from two places, which are nearly mirror images of each other.
    pub alternatives: Vec<PerspectivePose>,
}

impl PerspectivePose {
    /// Whether other poses explain the pixels as well.
    #[must_use]
    pub fn is_ambiguous(&self) -> bool {
        !self.alternatives.is_empty()
    }

    /// The standard deviation of the rotation in radians: the root of the sum of the variances
    /// about three axes.
    #[must_use]
    pub fn rotation_deviation(&self) -> Option<f64> {
        let covariance = self.covariance?;
        let sum: f64 = (0..3).map(|k| covariance[k][k]).sum();
        Some(sum.max(0.0).sqrt())
    }

    /// Whether another pose is within the deviations of this one, and so the same.
    fn is_near(&self, other: &Self) -> bool {
        let [a, b] = [self, other].map(|pose| pose.world_to_camera.rotor());
        let (_, angle) = (a * b.reverse()).canonical().to_axis_angle();
        is_same([(angle, self.rotation_deviation())])
    }
}

/// The pose of a camera that sees known points at given pixels. The threshold of the options is in
/// pixels.
///
/// Random samples of three points give poses ([`three_points`]). From the best of them Levenberg
/// and Marquardt's method makes the sum of the squared distances in the picture least, over motors.
/// Several starts are refined, and the mirror image of the best pose, since points near a plane may
/// have two local minima (G. Schweighofer and A. Pinz, "Robust pose estimation from a planar
/// target", IEEE Transactions on Pattern Analysis and Machine Intelligence 28, 2006). Where another
/// pose explains the pixels as well, it is among the
/// [alternatives](PerspectivePose::alternatives).
///
/// # Errors
/// [`ViewGeometryError`]: fewer than four points, numbers that are not finite, points on a line, a
/// threshold that is not positive, pixels that no pose explains.
///
/// ```
/// use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
/// use ga_camera::{Camera, Intrinsics};
/// use ga_vision::perspective_n_point::{Options, estimate};
///
/// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
/// let rotor = Rotor::from_axis_angle([1.0, 2.0, 0.0], 0.4).unwrap();
/// let world_to_camera: Motor<f64> = Translator::from_displacement([0.1, -0.2, 3.0]) * rotor;
/// let camera = Camera { intrinsics, world_to_camera };
/// // The corners of a sheet of paper.
/// let points = [[0.0, 0.0, 0.0], [0.21, 0.0, 0.0], [0.21, 0.297, 0.0], [0.0, 0.297, 0.0]];
/// let points = points.map(Point::from);
/// let pixels = camera.project_all(&points).map_err(|(_, error)| error)?;
/// let found = estimate(&points, &pixels, &intrinsics, &Options::default())?;
/// let [x, y, z] = found.world_to_camera.translator().displacement();
/// assert!((x - 0.1).abs() < 1e-9 && (y + 0.2).abs() < 1e-9 && (z - 3.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn estimate(
    points: &[Point<f64>],
    pixels: &[[f64; 2]],
    intrinsics: &Intrinsics,
    options: &Options,
) -> Result<PerspectivePose, ViewGeometryError> {
    if let Some(threshold) = options.threshold
        && !(threshold.is_finite() && threshold > 0.0)
    {
        return Err(ViewGeometryError::PointThreshold(threshold));
    }
    let observations = observations(points, pixels, intrinsics)?;
    let problem = Observed {
        observations: &observations,
        intrinsics,
    };
    let search = Search {
        // Squares of this, added up for all points, are finite, and greater than any distance.
        threshold: options.threshold.unwrap_or(1e12),
        confidence: 0.9999,
        least_samples: 100,
        samples: options.samples,
        seed: options.seed,
    };
    let minima = minima(&problem, &search);
    let best = minima.first().ok_or(ViewGeometryError::PoseUndetermined)?;
    let needed = match options.threshold {
        Some(_) => NEEDED + 1,
        None => points.len(),
    };
    if best.inliers.len() < needed.min(points.len()) {
        return Err(ViewGeometryError::NoPointConsensus {
            agreeing: best.inliers.len(),
            points: points.len(),
        });
    }
    let agreeing: Vec<_> = best.inliers.iter().map(|&k| points[k]).collect();
    check_line(&agreeing)?;
    let mut found = best.pose(&problem, options.threshold);
    let variance = best.minimum.variance().unwrap_or(f64::INFINITY);
    let squares = |one: &Refined| problem.squares(one.minimum.state, search.threshold);
    let best_squares = squares(best);
    for rival in &minima[1..] {
        if is_rival([&best_squares, &squares(rival)], variance, 2, 1.0) {
            let rival = rival.pose(&problem, options.threshold);
            let is_known =
                found.is_near(&rival) || found.alternatives.iter().any(|one| one.is_near(&rival));
            if !is_known {
                found.alternatives.push(rival);
            }
        }
    }
    Ok(found)
}

/// A known point, the pixel at which it is seen, and the unit direction of that.
#[derive(Clone, Copy)]
struct Observation {
    point: Point<f64>,
    pixel: [f64; 2],
    direction: Vector<f64>,
}

fn observations(
    points: &[Point<f64>],
    pixels: &[[f64; 2]],
    intrinsics: &Intrinsics,
) -> Result<Vec<Observation>, ViewGeometryError> {
    if points.len() != pixels.len() {
        return Err(ViewGeometryError::PointCounts {
            points: points.len(),
            pixels: pixels.len(),
        });
    }
    if points.len() < NEEDED {
        return Err(ViewGeometryError::TooFewPoints {
            found: points.len(),
            needed: NEEDED,
        });
    }
    if let Some(index) = points
        .iter()
        .position(|point| !Vector::from(*point).is_finite())
    {
        return Err(ViewGeometryError::PointNotFinite(index));
    }
    check_line(points)?;
    let pairs = points.iter().zip(pixels).enumerate();
    let observations = pairs.map(|(index, (&point, &pixel))| {
        let direction = intrinsics.direction(pixel);
        let direction = direction.map_err(|error| ViewGeometryError::PointCamera {
            point: index,
            error,
        })?;
        Ok(Observation {
            point,
            pixel,
            direction: direction.into(),
        })
    });
    observations.collect()
}

/// Refuses points on one line.
fn check_line(points: &[Point<f64>]) -> Result<(), ViewGeometryError> {
    match Plane::fit(points) {
        Err(FitError::Collinear | FitError::Coincident) => {
            Err(ViewGeometryError::PointsCollinear {
                distance: Line::fit(points).map_or(0.0, |fit| fit.rms()),
            })
        }
        _ => Ok(()),
    }
}

/// The least sum of squares over the points that agree.
struct Refined {
    /// The cost to random samples.
    cost: f64,
    minimum: Minimum<Motor<f64>>,
    inliers: Vec<usize>,
}

impl Refined {
    /// The variance of a coordinate of a pixel, for the covariance of the pose.
    fn variance(&self, threshold: Option<f64>) -> Option<f64> {
        let Minimum {
            cost,
            residuals,
            unknowns,
            ..
        } = self.minimum;
        let threshold = threshold.unwrap_or(f64::INFINITY);
        SelectedNoise::new(cost, [residuals, unknowns], threshold, 2)?.of_region(unknowns)
    }

    fn pose(&self, problem: &Observed<'_>, threshold: Option<f64>) -> PerspectivePose {
        let selected = problem.selected(&self.inliers);
        let part = Observed {
            observations: &selected,
            ..*problem
        };
        let covariance = self.variance(threshold).and_then(|variance| {
            self.minimum
                .curved_covariance(&part, variance, Region::Ellipsoid)
        });
        let entries = |covariance: Covariance| {
            std::array::from_fn(|row| std::array::from_fn(|column| covariance.shared(row, column)))
        };
        PerspectivePose {
            world_to_camera: self.minimum.state,
            root_mean_square: (self.minimum.cost / self.inliers.len() as f64).sqrt(),
            inliers: self.inliers.clone(),
            covariance: covariance.map(entries),
            alternatives: Vec::new(),
        }
    }
}

/// The local minima that the best poses of random samples lead to, and the mirror image of the best
/// one: the best first, and any several times.
fn minima(problem: &Observed<'_>, search: &Search) -> Vec<Refined> {
    /// Poses that are refined.
    const STARTS: usize = 12;
    let starts = search.run(problem, STARTS).into_iter();
    let mut found: Vec<Refined> = starts
        .filter_map(|start| refine(problem, search, start.model))
        .collect();
    // The sort is stable, so that equal costs keep the order of the samples.
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let mirrored = found
        .first()
        .and_then(|best| mirrored(problem, best))
        .and_then(|start| refine(problem, search, start));
    found.extend(mirrored);
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found
}

/// The pose that looks most alike: the points reflected in the plane through their middle across
/// the line of sight. Points of one plane, reflected, are a rotated plane.
fn mirrored(problem: &Observed<'_>, best: &Refined) -> Option<Motor<f64>> {
    let world_to_camera = best.minimum.state;
    let seen = problem.selected(&best.inliers);
    let placed = seen
        .iter()
        .map(|one| (one.point, world_to_camera.transform(one.point)));
    let placed: Vec<(Point<f64>, Point<f64>)> = placed.collect();
    let sum = placed
        .iter()
        .fold(Vector::ZERO, |sum, (_, place)| sum + Vector::from(*place));
    let middle = sum / placed.len() as f64;
    let across = Plane::from_point_normal(middle.into(), middle.coordinates());
    let pairs = placed
        .into_iter()
        .map(|(point, place)| Some((point, place.reflect_in(across)?)));
    let pairs: Option<Vec<_>> = pairs.collect();
    Some(Motor::from_point_pairs(&pairs?).ok()?.motion)
}

/// Refines a pose with all points that agree, which are collected anew after each search.
fn refine(problem: &Observed<'_>, search: &Search, start: Motor<f64>) -> Option<Refined> {
    /// How often the points that agree are collected anew.
    const ROUNDS: usize = 10;
    let mut best: Option<Refined> = None;
    let mut motor = start;
    let mut last = Vec::new();
    for _ in 0..ROUNDS {
        let inliers = search.inliers(problem, &motor);
        if inliers == last || inliers.len() < NEEDED {
            break;
        }
        last.clone_from(&inliers);
        let selected = problem.selected(&inliers);
        let part = Observed {
            observations: &selected,
            ..*problem
        };
        let Ok(minimum) = minimise(&part, motor, &least_squares::Options::default()) else {
            break;
        };
        motor = minimum.state;
        let Some(rated) = search.rate(problem, motor, f64::INFINITY) else {
            break;
        };
        if best.as_ref().is_none_or(|best| rated.cost < best.cost) {
            best = Some(Refined {
                cost: rated.cost,
                minimum,
                inliers,
            });
        }
    }
    best
}

/// Known points and their pixels in one camera.
struct Observed<'a> {
    observations: &'a [Observation],
    intrinsics: &'a Intrinsics,
}

impl Observed<'_> {
    fn selected(&self, chosen: &[usize]) -> Vec<Observation> {
        chosen.iter().map(|&k| self.observations[k]).collect()
    }

    /// The squared distances in the picture, at most the square of the threshold.
    fn squares(&self, motor: Motor<f64>, threshold: f64) -> Vec<f64> {
        let greatest = threshold * threshold;
        let square = |index| greatest.min(self.squared_error(&motor, index));
        (0..self.observations.len()).map(square).collect()
    }
}

impl Consensus for Observed<'_> {
    type Model = Motor<f64>;

    const SAMPLE: usize = 3;

    fn count(&self) -> usize {
        self.observations.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<Motor<f64>>) {
        let chosen: [Observation; 3] = std::array::from_fn(|k| self.observations[sample[k]]);
        models.extend(three_points(
            chosen.map(|one| one.point),
            chosen.map(|one| one.direction),
        ));
    }

    fn squared_error(&self, motor: &Motor<f64>, observation: usize) -> f64 {
        let Observation { point, pixel, .. } = self.observations[observation];
        match self.intrinsics.project(motor.transform(point)) {
            Ok([u, v]) => (u - pixel[0]).powi(2) + (v - pixel[1]).powi(2),
            Err(_) => f64::INFINITY,
        }
    }
}

impl Problem for Observed<'_> {
    type State = Motor<f64>;

    fn columns(&self) -> Columns {
        Columns::dense(6)
    }

    fn evaluate(&self, motor: &Motor<f64>, equations: &mut Equations) -> Option<()> {
        let camera = Camera {
            intrinsics: *self.intrinsics,
            world_to_camera: *motor,
        };
        for Observation { point, pixel, .. } in self.observations {
            let seen = camera.project_with_derivatives(*point).ok()?;
            let residual = [seen.pixel[0] - pixel[0], seen.pixel[1] - pixel[1]];
            let columns: [_; 6] = std::array::from_fn(|k| (k, seen.by_twist.map(|row| row[k])));
            equations.add(residual, &columns);
        }
        Some(())
    }

    fn stepped(&self, motor: &Motor<f64>, step: &[f64]) -> Option<Motor<f64>> {
        let rotation = Vector::new(step[0], step[1], step[2]);
        let velocity = Vector::new(step[3], step[4], step[5]);
        let change = MotorGenerator::from_velocities(rotation.into(), velocity.into());
        DualQuaternion::from(change.exp() * *motor).normalize()
    }
}
