//! Weighted sums of motors, normalised.

use core::fmt::{Debug, Display, Formatter, Result as FmtResult};

use super::weight::{WeightError, checked};
use crate::cga3::{DualQuaternion, Motor, Rotor};
use crate::scalar::Real;

/// Motions that have no blend.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BlendError<S> {
    /// There is nothing to blend.
    Empty,
    /// The weights make no average.
    Weight(WeightError<S>),
    /// A coefficient of a motion is not finite.
    NotFinite {
        /// Which of the motions, from 0.
        index: usize,
    },
    /// The displacements are so large that the result is beyond the range of the scalar.
    OutOfRange,
}

impl<S: Debug> Display for BlendError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FmtResult {
        match self {
            Self::Empty => f.write_str("there are no motions"),
            Self::Weight(error) => Display::fmt(error, f),
            Self::NotFinite { index } => write!(f, "motion {index} is not finite"),
            Self::OutOfRange => f.write_str("the result is beyond the range of the scalar"),
        }
    }
}

impl<S: Debug> core::error::Error for BlendError<S> {}

impl<S> From<WeightError<S>> for BlendError<S> {
    fn from(error: WeightError<S>) -> Self {
        Self::Weight(error)
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The weighted sum of motors, made a motor again: `Σ wᵢ ±Mᵢ / |Σ wᵢ ±Mᵢ|`, the norm in every
    /// grade.
    ///
    /// This is the blend of dual quaternion skinning (Kavan, Collins, Žára and O'Sullivan,
    /// Geometric skinning with approximate dual quaternion blending, ACM Transactions on Graphics
    /// 27, 2008). Each motor enters with the sign that is nearer to the one of the largest weight,
    /// of equal ones the first, and the result has that one's sign. So the sum cannot vanish.
    /// Weights count by their ratios. Of two motors with equal weights it is the middle of the
    /// screw from one to the other; elsewhere it is close to [`Motor::mean`] and costs no
    /// logarithm.
    ///
    /// # Errors
    /// No motors, a weight that is negative or not finite, no weight above zero, a motor that is
    /// not finite, a result beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// use ga_runtime::geometry::motion::{BlendError, WeightError};
    /// let shift = |x: f64| Motor::from(Translator::from_displacement([x, 0.0, 0.0]));
    /// // Three to one, and the sign of a motor makes no difference.
    /// let blend = Motor::blend(&[(3.0, shift(2.0)), (1.0, -shift(6.0))]).unwrap();
    /// assert_eq!(blend.translator().displacement(), [3.0, 0.0, 0.0]);
    /// let refused = Motor::blend(&[(1.0, shift(2.0)), (-1.0, shift(6.0))]);
    /// assert_eq!(
    ///     refused,
    ///     Err(BlendError::Weight(WeightError::Invalid {
    ///         index: 1,
    ///         weight: -1.0
    ///     }))
    /// );
    /// ```
    pub fn blend(weighted: &[(S, Self)]) -> Result<Self, BlendError<S>> {
        let strongest = strongest(weighted)?;
        let sum = aligned(weighted, strongest).fold(
            DualQuaternion::default(),
            |mut sum, (weight, motor)| {
                sum += motor * weight;
                sum
            },
        );
        let blend = sum.normalize().ok_or(BlendError::OutOfRange)?;
        is_finite(blend)
            .then_some(blend)
            .ok_or(BlendError::OutOfRange)
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The weighted sum of rotors, made a rotor again; see [`Motor::blend`].
    ///
    /// # Errors
    /// Those of [`Motor::blend`].
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let turn = |angle: f64| Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).unwrap();
    /// let (axis, angle) = Rotor::blend(&[(0.5, turn(1.0)), (0.5, turn(2.0))])
    ///     .unwrap()
    ///     .to_axis_angle();
    /// assert!((angle - 1.5).abs() < 1e-15 && axis == [0.0, 0.0, 1.0]);
    /// ```
    pub fn blend(weighted: &[(S, Self)]) -> Result<Self, BlendError<S>> {
        let motors: alloc::vec::Vec<_> = weighted
            .iter()
            .map(|&(weight, rotor)| (weight, Motor::from(rotor)))
            .collect();
        Ok(Motor::blend(&motors)?.rotor())
    }
}

/// Which motor has the largest weight, of equal ones the first.
pub(super) fn strongest<S: Real<Mask = bool>>(
    weighted: &[(S, Motor<S>)],
) -> Result<usize, BlendError<S>> {
    let mut best = 0;
    for (index, &(weight, motor)) in weighted.iter().enumerate() {
        checked(index, weight)?;
        if !is_finite(motor) {
            return Err(BlendError::NotFinite { index });
        }
        if weighted[best].0.less_than(weight) {
            best = index;
        }
    }
    let &(largest, _) = weighted.get(best).ok_or(BlendError::Empty)?;
    if !S::zero().less_than(largest) {
        return Err(WeightError::AllZero.into());
    }
    Ok(best)
}

/// The motors of weights above zero, with the sign nearer to that of the strongest, whose weight
/// becomes 1. What is half a turn away from that one, as far as can be told, takes the sign nearer
/// to the sum of the others.
pub(super) fn aligned<S: Real<Mask = bool>>(
    weighted: &[(S, Motor<S>)],
    strongest: usize,
) -> impl Iterator<Item = (S, Motor<S>)> {
    let (largest, guide) = weighted[strongest];
    let guide = coordinates(guide);
    let counting = || {
        weighted
            .iter()
            .filter(|(weight, _)| S::zero().less_than(*weight))
            .map(move |&(weight, motor)| {
                (
                    weight / largest,
                    motor,
                    rotor_product(guide, coordinates(motor)),
                )
            })
    };
    let doubtful = S::epsilon() * S::from_integer(64);
    let others = counting()
        .filter(|(_, _, product)| doubtful.less_than(product.abs()))
        .fold([S::zero(); 4], |sum, (weight, motor, product)| {
            let weight = S::select(product.less_than(S::zero()), -weight, weight);
            let rotor = coordinates(motor);
            core::array::from_fn(|k| rotor[k].mul_add(weight, sum[k]))
        });
    counting().map(move |(weight, motor, product)| {
        let product = if doubtful.less_than(product.abs()) {
            product
        } else {
            rotor_product(others, coordinates(motor))
        };
        let is_turned_back = product.less_than(S::zero());
        (weight, if is_turned_back { -motor } else { motor })
    })
}

/// The coefficients of the turn: a unit quaternion, but for the signs of its basis.
pub(super) fn coordinates<S: Real>(motor: Motor<S>) -> [S; 4] {
    [motor.scalar(), motor.e12(), motor.e13(), motor.e23()]
}

/// For two rotors the cosine of half the angle between them.
fn rotor_product<S: Real>(a: [S; 4], b: [S; 4]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
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
