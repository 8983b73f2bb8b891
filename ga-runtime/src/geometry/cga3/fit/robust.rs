//! Fits to points of which some are gross errors.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::cloud::Cloud;
use super::consensus::{agreeing, best_of_samples};
use super::error::PrimitiveFitError;
use super::interface::{cloud_of, least};
use super::loss::{Limited, Loss, loss};
use super::place::Place;
use super::result::{Located, PrimitiveFit, fitted};
use super::shape::Shape;
use crate::scalar::Real;
use crate::vga3::Vector;

/// How primitives are searched among gross errors.
///
/// Random samples, each of as many points as determine a primitive, are rated by the sum of the
/// squared distances of all points, each cut off at the square of the threshold (Fischler and
/// Bolles, Random sample consensus, Communications of the ACM 24, 1981; Torr and Zisserman, MLESAC,
/// Computer Vision and Image Understanding 78, 2000). Each best one so far is improved by least
/// squares over the points that agree with it (Chum, Matas and Kittler, Locally optimized RANSAC,
/// DAGM 2003). Then an M-estimate over the points that agree follows, which are collected anew
/// until they stay the same.
///
/// ```
/// use ga_runtime::cga3::{Plane, Point};
/// use ga_runtime::geometry::fit::RobustSettings;
/// // Half of the points lie near the plane z = 1.
/// let points: Vec<_> = (0..20_i32)
///     .map(|k| {
///         let t = f64::from(k);
///         let z = if k % 2 == 0 { 1.0 + 0.01 * t.sin() } else { 3.0 * t.cos() };
///         Point::new(t, (2.0 * t).sin(), z)
///     })
///     .collect();
/// let found = Plane::fit_robustly(&points, &RobustSettings::new(0.05)).unwrap();
/// assert!(found.inliers.iter().filter(|index| **index % 2 == 0).count() == 10);
/// let height = found.fit.primitive.signed_distance(Point::new(0.0, 0.0, 1.0)).unwrap();
/// assert!(height.abs() < 0.02);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobustSettings<S> {
    /// Points that are nearer than this agree with a primitive; above zero.
    pub threshold: S,
    /// The probability with which a sample without gross errors is to be drawn; above 0, below 1.
    pub confidence: S,
    /// The greatest number of samples.
    pub samples: usize,
    /// Equal seeds draw equal samples on every machine.
    pub seed: u64,
    /// The loss of the M-estimate.
    pub loss: Loss,
    /// The scale of the noise, the standard deviation of a coordinate, above zero. Where it is
    /// `None`, it follows from the median of the distances of the points that agree: divided by the
    /// median of the normal distribution's absolute value, 0.6745, for surfaces, and by that of the
    /// Rayleigh distribution, √(2 ln 2), for curves.
    pub scale: Option<S>,
}

impl<S: Real> RobustSettings<S> {
    /// A threshold, with the confidence 0.999, at most 10,000 samples, the seed 1, the loss of
    /// Tukey, and the scale from the points.
    #[must_use]
    pub fn new(threshold: S) -> Self {
        Self {
            threshold,
            confidence: S::from_f64(0.999),
            samples: 10_000,
            seed: 1,
            loss: Loss::Tukey,
            scale: None,
        }
    }
}

impl<S: Real<Mask = bool>> RobustSettings<S> {
    fn check(&self) -> Result<(), PrimitiveFitError<S>> {
        let (zero, one) = (S::zero(), S::one());
        let is_length = |x: S| zero.less_than(x) && x.is_finite();
        let invalid = |name, value| Err(PrimitiveFitError::InvalidSetting { name, value });
        if !is_length(self.threshold) {
            return invalid("threshold", self.threshold);
        }
        if !(zero.less_than(self.confidence) && self.confidence.less_than(one)) {
            return invalid("confidence", self.confidence);
        }
        if self.samples == 0 {
            return invalid("samples", zero);
        }
        match self.scale {
            Some(scale) if !is_length(scale) => invalid("scale", scale),
            _ => Ok(()),
        }
    }
}

/// A primitive fitted to those points that agree with it.
#[derive(Clone, Debug, PartialEq)]
pub struct RobustFit<P, S, const N: usize> {
    /// The M-estimate of the inliers. Its root mean square and its covariance are theirs.
    pub fit: PrimitiveFit<P, S, N>,
    /// The indices of the points that agree, rising.
    pub inliers: Vec<usize>,
    /// The scale of the noise that the M-estimate used.
    pub scale: S,
    /// How many samples were drawn.
    pub samples: usize,
}

pub(super) fn fit<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    points: Vec<Vector<S>>,
    settings: &RobustSettings<S>,
) -> Result<RobustFit<P, S, N>, PrimitiveFitError<S>> {
    /// How often the points that agree are collected.
    const ROUNDS: usize = 20;
    settings.check()?;
    if let Some(index) = points.iter().position(|place| !place.is_finite()) {
        return Err(PrimitiveFitError::NotFinite { index });
    }
    let (mut located, samples) = best_of_samples::<P, S, N>(&points, settings)?;
    let mut inliers = agreeing::<P, S, N>(&points, &located, settings.threshold);
    for round in 1.. {
        let found = inliers.len();
        let needed = P::NEEDED;
        if found < needed {
            return Err(PrimitiveFitError::NoConsensus { found, needed });
        }
        let cloud = cloud_of::<P, S, N>(inliers.iter().map(|&k| (S::one(), points[k])))?;
        let scale = scale::<P, S, N>(&cloud, located.seen_from(&cloud), settings.scale);
        let limit = scale * settings.loss.constant() / cloud.unit;
        let limited = Some((settings.loss, limit));
        let place = least::<P, S, N>(&cloud, &[located.seen_from(&cloud)], limited)?;
        located = Located::new(&cloud, place);
        let next = agreeing::<P, S, N>(&points, &located, settings.threshold);
        if next == inliers || round == ROUNDS {
            return Ok(RobustFit {
                fit: fitted(&cloud, place, limited)?,
                inliers,
                scale,
                samples,
            });
        }
        inliers = next;
    }
    Err(PrimitiveFitError::NotConverged)
}

/// The given scale of the noise, or that of the distances from a place, but at least their
/// rounding.
fn scale<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    cloud: &Cloud<S>,
    place: Place<S>,
    given: Option<S>,
) -> S {
    let located = Located::new(cloud, place);
    let least = cloud.unit * S::epsilon() * S::from_integer(64);
    let estimated = || {
        let mut distances: Vec<S> = cloud
            .points
            .iter()
            .map(|&(_, point)| {
                let inside = Located {
                    centroid: Vector::default(),
                    unit: S::one(),
                    place,
                };
                inside.residual::<P, N>(point).abs() * located.unit
            })
            .collect();
        distances.sort_unstable_by(|a, b| match (a.less_than(*b), b.less_than(*a)) {
            (true, _) => Ordering::Less,
            (_, true) => Ordering::Greater,
            _ => Ordering::Equal,
        });
        let middle = distances.len() / 2;
        let median = if distances.len() % 2 == 1 {
            distances[middle]
        } else {
            (distances[middle - 1] + distances[middle]) * S::from_ratio(1, 2)
        };
        let per_deviation = if P::COMPONENTS == 1 {
            0.674_489_750_196_081_7
        } else {
            1.177_410_022_515_474_7
        };
        median / S::from_f64(per_deviation)
    };
    given.unwrap_or_else(estimated).max(least)
}

/// `Σ ψ²/(mean ψ′)²` at a place, over the components of the distances.
pub(super) fn spread<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    cloud: &Cloud<S>,
    place: Place<S>,
    limited: Limited<S>,
) -> S {
    let zero = S::zero();
    let to_frame = place.motor.reverse();
    let (mut squares, mut slopes) = (zero, zero);
    for &(_, point) in &cloud.points {
        let (distances, _) = P::rows(Place::local(to_frame, point), place.curvature);
        let square = distances[..P::COMPONENTS]
            .iter()
            .fold(zero, |sum, &r| r.mul_add(r, sum));
        let [_, factor, slope] = loss(limited, square);
        squares += factor * factor * square;
        // Of two components, the one across the distance has the slope ψ/r.
        slopes += if P::COMPONENTS == 1 {
            slope
        } else {
            (slope + factor) * S::from_ratio(1, 2)
        };
    }
    let mean = slopes / S::from_integer(cloud.points.len() as i64);
    squares / (mean * mean)
}
