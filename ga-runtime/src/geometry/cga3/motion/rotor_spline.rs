//! Splines of rotations through keys.

use alloc::vec::Vec;

use super::spline::{MotorSpline, SplineError};
use super::spline_end::SplineEnd;
use crate::cga3::{Motor, Rotor};
use crate::scalar::Real;

/// A motion of rotations through key rotors at given times, with a continuous angular velocity: a
/// [`MotorSpline`] without displacement.
///
/// ```
/// use ga_runtime::cga3::Rotor;
/// use ga_runtime::geometry::motion::RotorSpline;
/// let rotation = |angle: f64| Rotor::from_axis_angle([1.0, 0.0, 0.0], angle).unwrap();
/// let spline = RotorSpline::through(&[
///     (0.0, rotation(0.0)),
///     (2.0, rotation(1.0)),
///     (3.0, -rotation(1.5)),
/// ])
/// .unwrap();
/// let (_, angle) = spline.evaluate(1.0).unwrap().to_axis_angle();
/// assert!((angle - 0.5).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RotorSpline<S>(MotorSpline<S>);

impl<S: Real<Mask = bool>> RotorSpline<S> {
    /// The spline through two or more keys, each a time and a rotor; see [`MotorSpline::through`].
    ///
    /// # Errors
    /// Those of [`MotorSpline::through`].
    pub fn through(keys: &[(S, Rotor<S>)]) -> Result<Self, SplineError<S>> {
        let keys: Vec<_> = keys
            .iter()
            .map(|&(time, rotor)| (time, Motor::from(rotor)))
            .collect();
        MotorSpline::through(&keys).map(Self)
    }

    /// The spline through two or more keys whose angular acceleration is continuous too; see
    /// [`MotorSpline::smooth`]. A velocity given at an end should be that of a rotation.
    ///
    /// The `RotationSpline` of scipy satisfies the same conditions with other curves from key to
    /// key, exponentials of cubic polynomials, and at the ends has the velocities of the rotations
    /// to the adjacent keys. Where all keys rotate about one axis and those velocities are given
    /// here, both are the cubic spline of the angle.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// use ga_runtime::geometry::motion::{RotorSpline, SplineEnd};
    /// // Eight rotations by 170° about axes in turn.
    /// let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let mut at = Rotor::default();
    /// let keys: Vec<_> = (0..8)
    ///     .map(|k| {
    ///         at *= Rotor::from_axis_angle(axes[k % 3], 170_f64.to_radians()).unwrap();
    ///         (k as f64, at)
    ///     })
    ///     .collect();
    /// let spline = RotorSpline::smooth(&keys, [SplineEnd::Natural; 2]).unwrap();
    /// for (time, key) in keys {
    ///     let found = spline.evaluate(time).unwrap();
    ///     assert!((found.reverse() * key).scalar().abs() > 1.0 - 1e-15);
    /// }
    /// ```
    ///
    /// # Errors
    /// Those of [`MotorSpline::smooth`].
    pub fn smooth(keys: &[(S, Rotor<S>)], ends: [SplineEnd<S>; 2]) -> Result<Self, SplineError<S>> {
        let keys: Vec<_> = keys
            .iter()
            .map(|&(time, rotor)| (time, Motor::from(rotor)))
            .collect();
        MotorSpline::smooth(&keys, ends).map(Self)
    }

    /// The time of the first key.
    #[must_use]
    pub fn start(&self) -> S {
        self.0.start()
    }

    /// The time of the last key.
    #[must_use]
    pub fn end(&self) -> S {
        self.0.end()
    }

    /// The rotor at a time; see [`MotorSpline::evaluate`].
    #[must_use]
    pub fn evaluate(&self, time: S) -> Option<Rotor<S>> {
        self.0.evaluate(time).map(Motor::rotor)
    }

    /// The angular velocity ω at a time in the frame of the moved body, in radians per unit of
    /// time; see [`MotorSpline::velocity`].
    #[must_use]
    pub fn angular_velocity(&self, time: S) -> Option<[S; 3]> {
        Some(self.0.velocity(time)?.angular_velocity().vector())
    }

    /// The angular acceleration ω' at a time in the frame of the moved body, in radians per squared
    /// unit of time; see [`MotorSpline::acceleration`].
    #[must_use]
    pub fn angular_acceleration(&self, time: S) -> Option<[S; 3]> {
        Some(self.0.acceleration(time)?.angular_velocity().vector())
    }
}
