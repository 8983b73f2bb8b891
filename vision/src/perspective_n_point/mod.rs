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
use ga_camera::{Camera, Intrinsics};
use ga_numerics::least_squares::{
    self, Columns, Covariance, Equations, Minimum, Problem, minimise,
};
pub use ga_numerics::ransac::PoseOptions as Options;
use ga_numerics::ransac::{Consensus, Search};

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
    /// The covariance of a small motion that follows the pose, `exp(B) M`, with the rotation vector
    /// of B in radians and then its velocity of the origin in the unit of the points; to first
    /// order, from the distances that remain.
    pub covariance: Option<[[f64; 6]; 6]>,
}

/// The pose of a camera that sees known points at given pixels. The threshold of the options is in
/// pixels.
///
/// Random samples of three points give poses ([`three_points`]). From the best of them Levenberg
/// and Marquardt's method makes the sum of the squared distances in the picture least, over motors;
/// several starts are refined, since points near a plane may have two local minima.
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
    let refined = refine_best(&problem, &search).ok_or(ViewGeometryError::PoseUndetermined)?;
    let Refined { minimum, inliers } = refined;
    let needed = match options.threshold {
        Some(_) => NEEDED + 1,
        None => points.len(),
    };
    if inliers.len() < needed.min(points.len()) {
        return Err(ViewGeometryError::NoPointConsensus {
            agreeing: inliers.len(),
            points: points.len(),
        });
    }
    let agreeing: Vec<_> = inliers.iter().map(|&k| points[k]).collect();
    check_line(&agreeing)?;
    let covariance = minimum
        .variance()
        .and_then(|variance| minimum.covariance(variance));
    let entry = |covariance: Covariance| {
        std::array::from_fn(|row| std::array::from_fn(|column| covariance.shared(row, column)))
    };
    Ok(PerspectivePose {
        world_to_camera: minimum.state,
        root_mean_square: (minimum.cost / inliers.len() as f64).sqrt(),
        inliers,
        covariance: covariance.map(entry),
    })
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
    minimum: Minimum<Motor<f64>>,
    inliers: Vec<usize>,
}

/// Refines the best poses of random samples with all points that agree.
fn refine_best(problem: &Observed<'_>, search: &Search) -> Option<Refined> {
    /// Poses that are refined.
    const STARTS: usize = 12;
    /// How often the points that agree are collected anew.
    const ROUNDS: usize = 10;
    let mut best: Option<(f64, Refined)> = None;
    for start in search.run(problem, STARTS) {
        let mut motor = start.model;
        let mut last = Vec::new();
        for _ in 0..ROUNDS {
            let inliers = search.inliers(problem, &motor);
            if inliers == last || inliers.len() < NEEDED {
                break;
            }
            last.clone_from(&inliers);
            let selected: Vec<_> = inliers.iter().map(|&k| problem.observations[k]).collect();
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
            if best.as_ref().is_none_or(|(least, _)| rated.cost < *least) {
                best = Some((rated.cost, Refined { minimum, inliers }));
            }
        }
    }
    best.map(|(_, refined)| refined)
}

/// Known points and their pixels in one camera.
struct Observed<'a> {
    observations: &'a [Observation],
    intrinsics: &'a Intrinsics,
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
