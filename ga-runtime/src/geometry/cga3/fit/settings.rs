//! How primitives are searched among gross errors.

use super::loss::Loss;
use crate::geometry::FitError;
use crate::scalar::Real;

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
    pub(super) fn check(&self) -> Result<(), FitError<S>> {
        let (zero, one) = (S::zero(), S::one());
        let is_length = |x: S| zero.less_than(x) && x.is_finite();
        let invalid = |name, value| Err(FitError::InvalidSetting { name, value });
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
