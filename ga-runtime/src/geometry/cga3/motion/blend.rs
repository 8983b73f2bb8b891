//! Weighted sums of motors, normalised.

use super::alignment::aligned;
use crate::cga3::{DualQuaternion, Motor, Rotor};
use crate::geometry::FitError;
use crate::geometry::cga3::weight::checked;
use crate::scalar::Real;

impl<S: Real<Mask = bool>> Motor<S> {
    /// The weighted sum of motors, normalised to a motor: `Σ wᵢ ±Mᵢ / |Σ wᵢ ±Mᵢ|`. The norm has a
    /// scalar part and a part of grade 4, and the sum is divided by both.
    ///
    /// This is the blend of dual quaternion skinning (Kavan, Collins, Žára and O'Sullivan,
    /// Geometric skinning with approximate dual quaternion blending, ACM Transactions on Graphics
    /// 27, 2008). Each motor is added with the sign that brings it nearer to the motor of the
    /// largest weight (the first of several), and the result has the sign of that motor. So the sum
    /// cannot vanish. Only the ratios of the weights matter. The blend of two motors with equal
    /// weights is the middle of the screw from one to the other; in general it is close to
    /// [`Motor::mean`] and needs no logarithm. [`Motor::blend_influences`] computes it without
    /// checks for any list of influences.
    ///
    /// # Errors
    /// No motors, a weight that is negative or not finite, no weight above zero, a motor that is
    /// not finite, a result beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// use ga_runtime::geometry::FitError;
    /// let translation = |x: f64| Motor::from(Translator::from_displacement([x, 0.0, 0.0]));
    /// // Three to one, and the sign of a motor makes no difference.
    /// let blend = Motor::blend(&[(3.0, translation(2.0)), (1.0, -translation(6.0))]).unwrap();
    /// assert_eq!(blend.translator().displacement(), [3.0, 0.0, 0.0]);
    /// let refused = Motor::blend(&[(1.0, translation(2.0)), (-1.0, translation(6.0))]);
    /// assert_eq!(
    ///     refused,
    ///     Err(FitError::InvalidWeight {
    ///         index: 1,
    ///         weight: -1.0
    ///     })
    /// );
    /// ```
    pub fn blend(weighted: &[(S, Self)]) -> Result<Self, FitError<S>> {
        let largest = largest_weight(weighted)?;
        Self::blend_influences(counting(weighted, largest))
            .filter(|&blend| is_finite(blend))
            .ok_or(FitError::OutOfRange)
    }

    /// The same blend, `Σ wᵢ ±Mᵢ / |Σ wᵢ ±Mᵢ|`, from an iterator: nothing is allocated, and nothing
    /// is checked beforehand. This is the inner loop of skinning.
    ///
    /// Each motor is added with the sign that brings it nearer to the motor of the largest weight
    /// (the first of several). `None` where the sum is not a multiple of a motor: there are no
    /// motors, the weights are all zero or a number is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let palette = [1.0, 5.0].map(|x| Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
    /// let influences = [(0, 0.25), (1, 0.75)];
    /// let blend = Motor::blend_influences(
    ///     influences
    ///         .iter()
    ///         .map(|&(joint, weight)| (weight, palette[joint])),
    /// );
    /// assert_eq!(blend.unwrap().translator().displacement(), [4.0, 0.0, 0.0]);
    /// ```
    #[inline]
    pub fn blend_influences<I>(weighted: I) -> Option<Self>
    where
        I: IntoIterator<Item = (S, Self), IntoIter: Clone>,
    {
        let mut sum = DualQuaternion::default();
        for (weight, motor) in aligned(weighted.into_iter())? {
            sum += motor * weight;
        }
        sum.normalize()
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The weighted sum of rotors, normalised to a rotor; see [`Motor::blend`].
    ///
    /// # Errors
    /// Those of [`Motor::blend`].
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let rotation = |angle: f64| Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).unwrap();
    /// let (axis, angle) = Rotor::blend(&[(0.5, rotation(1.0)), (0.5, rotation(2.0))])
    ///     .unwrap()
    ///     .to_axis_angle();
    /// assert!((angle - 1.5).abs() < 1e-15 && axis == [0.0, 0.0, 1.0]);
    /// ```
    pub fn blend(weighted: &[(S, Self)]) -> Result<Self, FitError<S>> {
        let motors: alloc::vec::Vec<_> = weighted
            .iter()
            .map(|&(weight, rotor)| (weight, Motor::from(rotor)))
            .collect();
        Ok(Motor::blend(&motors)?.rotor())
    }
}

/// Checks the motors and their weights, and returns the largest weight.
pub(super) fn largest_weight<S: Real<Mask = bool>>(
    weighted: &[(S, Motor<S>)],
) -> Result<S, FitError<S>> {
    let mut largest = S::zero();
    for (index, &(weight, motor)) in weighted.iter().enumerate() {
        largest = largest.max(checked(index, weight)?);
        if !is_finite(motor) {
            return Err(FitError::MotionNotFinite { index });
        }
    }
    if weighted.is_empty() {
        return Err(FitError::NoMotions);
    }
    if !S::zero().less_than(largest) {
        return Err(FitError::ZeroWeights);
    }
    Ok(largest)
}

/// The motors with weights above zero, with the weights divided by the largest.
pub(super) fn counting<S: Real<Mask = bool>>(
    weighted: &[(S, Motor<S>)],
    largest: S,
) -> impl Iterator<Item = (S, Motor<S>)> + Clone {
    weighted
        .iter()
        .filter(|(weight, _)| S::zero().less_than(*weight))
        .map(move |&(weight, motor)| (weight / largest, motor))
}

pub(super) fn is_finite<S: Real<Mask = bool>>(motor: Motor<S>) -> bool {
    [
        motor.scalar(),
        motor.e12(),
        motor.e13(),
        motor.e23(),
        motor.e1i(),
        motor.e2i(),
        motor.e3i(),
        motor.e123i(),
    ]
    .into_iter()
    .all(|x| x.is_finite())
}
