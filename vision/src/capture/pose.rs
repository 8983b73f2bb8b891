//! The rigid motion that takes points at rest to where they are seen.

use ga_runtime::cga3::{Motor, Point};
use ga_runtime::geometry::FitError;
use ga_runtime::vga3::Vector;

use super::error::{NEEDED, PointSet};
use crate::capture::CaptureError;
pub use ga_numerics::ransac::PoseOptions;
use ga_numerics::ransac::{Consensus, Search};

/// Where a rigid body is.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPose {
    /// The motor M that takes the points at rest to those seen, `y = M x ~M`.
    pub motor: Motor<f64>,
    /// The indices of the points that agree, rising.
    pub inliers: Vec<usize>,
    /// The root mean square of their distances from where the motor takes them, in the unit of the
    /// points.
    pub root_mean_square: f64,
}

/// The pose of a rigid body from three or more of its points, which are known at rest: the motor M
/// for which
///
/// ```text
/// Σ |yᵢ − M xᵢ ~M|²
/// ```
///
/// is least, over all points or, with a [threshold](PoseOptions::threshold) in the unit of the
/// points, over those that agree.
/// The points that agree are found by random samples of three points
/// ([`ransac`](ga_numerics::ransac)), and the motor is fitted to all of them
/// ([`Motor::from_point_pairs`]) until they do not change any more.
///
/// Three points that are not on one line determine the motion: their distances from each other show
/// whether they are right. Points on one line do not: a rotation about it moves none of them.
///
/// # Errors
/// [`CaptureError`]: fewer than three points, unequal numbers of them, numbers that are not finite,
/// all points in one place or on one line, points that several rotations fit equally well, a
/// threshold that is not positive, and fewer than three points that agree with any one pose.
///
/// ```
/// use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
/// use ga_vision::capture::{PoseOptions, rigid_pose};
///
/// // Both temples, the bridge of the nose and the forehead, in metres; then one gross error.
/// let mut rest = vec![[-0.07, 0.0, 0.0], [0.07, 0.0, 0.0], [0.0, 0.01, 0.09], [0.0, 0.06, 0.08]];
/// rest.push([0.0, -0.04, 0.09]);
/// let rest: Vec<_> = rest.into_iter().map(Point::from).collect();
/// let rotor = Rotor::from_axis_angle([0.0, 1.0, 0.0], 0.5).ok_or("an axis")?;
/// let truth: Motor<f64> = Translator::from_displacement([0.1, 1.6, 0.0]) * rotor;
/// let mut seen: Vec<_> = rest.iter().map(|&point| truth.transform(point)).collect();
/// seen[4] = Point::new(0.0, 0.0, 0.0);
///
/// let options = PoseOptions { threshold: Some(0.002), ..PoseOptions::default() };
/// let found = rigid_pose(&rest, &seen, &options)?;
/// assert_eq!(found.inliers, [0, 1, 2, 3]);
/// assert!(found.motor.transform(rest[0]).distance(seen[0]) < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rigid_pose(
    rest: &[Point<f64>],
    seen: &[Point<f64>],
    options: &PoseOptions,
) -> Result<RigidPose, CaptureError> {
    if rest.len() != seen.len() {
        return Err(CaptureError::Counts {
            rest: rest.len(),
            seen: seen.len(),
        });
    }
    let is_finite = |point: Point<f64>| Vector::from(point).is_finite();
    let pairs: Vec<_> = rest.iter().copied().zip(seen.iter().copied()).collect();
    let wrong = pairs
        .iter()
        .position(|&(x, y)| !is_finite(x) || !is_finite(y));
    if let Some(point) = wrong {
        return Err(CaptureError::NotFinite { point });
    }
    check(rest)?;
    let problem = Pairs(&pairs);
    match options.threshold {
        None => {
            let all = (0..pairs.len()).collect();
            problem
                .fitted(all)
                .map_err(|error| CaptureError::from_fit(error, PointSet::Seen))
        }
        Some(threshold) if threshold.is_finite() && threshold > 0.0 => {
            problem.agreed(threshold, options)
        }
        Some(threshold) => Err(CaptureError::Threshold(threshold)),
    }
}

/// Refuses points at rest that determine no motion.
pub(super) fn check(rest: &[Point<f64>]) -> Result<(), CaptureError> {
    if rest.len() < NEEDED {
        return Err(CaptureError::TooFew {
            found: rest.len(),
            needed: NEEDED,
        });
    }
    // The points are fitted to themselves, by the identity.
    let pairs: Vec<_> = rest.iter().map(|&point| (point, point)).collect();
    match Motor::from_point_pairs(&pairs) {
        Ok(_) => Ok(()),
        Err(error) => Err(CaptureError::from_fit(error, PointSet::Rest)),
    }
}

/// Points at rest, and where they are seen.
struct Pairs<'a>(&'a [(Point<f64>, Point<f64>)]);

impl Pairs<'_> {
    /// The best motor for some of the points.
    fn fitted(&self, inliers: Vec<usize>) -> Result<RigidPose, FitError<f64>> {
        let chosen: Vec<_> = inliers.iter().map(|&k| self.0[k]).collect();
        let fit = Motor::from_point_pairs(&chosen)?;
        Ok(RigidPose {
            motor: fit.motion,
            inliers,
            root_mean_square: fit.residual(&chosen),
        })
    }

    /// The best motor for the points that agree with it.
    fn agreed(&self, threshold: f64, options: &PoseOptions) -> Result<RigidPose, CaptureError> {
        /// Motors that are refined.
        const STARTS: usize = 8;
        /// How often the points that agree are collected anew.
        const ROUNDS: usize = 10;
        let search = Search {
            threshold,
            confidence: 0.9999,
            least_samples: 50,
            samples: options.samples,
            seed: options.seed,
        };
        let mut best: Option<(f64, RigidPose)> = None;
        let mut agreeing = 0;
        for start in search.run(self, STARTS) {
            agreeing = agreeing.max(start.inliers);
            let mut motor = start.model;
            let mut last = Vec::new();
            for _ in 0..ROUNDS {
                let inliers = search.inliers(self, &motor);
                if inliers == last || inliers.len() < NEEDED {
                    break;
                }
                last.clone_from(&inliers);
                let Ok(pose) = self.fitted(inliers) else {
                    break;
                };
                motor = pose.motor;
                let Some(rated) = search.rate(self, motor, f64::INFINITY) else {
                    break;
                };
                if best.as_ref().is_none_or(|(least, _)| rated.cost < *least) {
                    best = Some((rated.cost, pose));
                }
            }
        }
        let pose = best.map(|(_, pose)| pose);
        pose.ok_or(CaptureError::NoConsensus {
            agreeing,
            points: self.0.len(),
            needed: NEEDED,
        })
    }
}

impl Consensus for Pairs<'_> {
    type Model = Motor<f64>;

    const SAMPLE: usize = 3;

    fn count(&self) -> usize {
        self.0.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<Motor<f64>>) {
        let chosen: [_; 3] = std::array::from_fn(|k| self.0[sample[k]]);
        models.extend(Motor::from_point_pairs(&chosen).map(|fit| fit.motion));
    }

    fn squared_error(&self, motor: &Motor<f64>, observation: usize) -> f64 {
        let (rest, seen) = self.0[observation];
        motor.transform(rest).distance_squared(seen)
    }
}
