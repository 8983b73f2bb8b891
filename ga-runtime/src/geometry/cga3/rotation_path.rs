//! The two ways round to one orientation.

use crate::cga3::{Motor, Rotor};
use crate::scalar::Real;

/// The two ways of turning to the same place: by an angle of at most a half turn, or the other way
/// round by the rest of a full turn.
///
/// A rotor and its negative move alike, and the sign says which way was taken (the paper's eqs 23
/// and 24, as corrected): with I the unit bivector of the plane,
///
/// ```text
/// R = cos ½θ − sin ½θ I = exp(−½ θ I)          by θ ≤ π, the scalar part is not negative
/// −R = exp(½ (2π − θ) I)                       by 2π − θ the other way round, it is not positive
/// ```
///
/// The same holds for a motor, whose screw has the same axis and translation along it by either
/// way.
///
/// ```
/// use ga_runtime::cga3::Rotor;
/// use ga_runtime::geometry::RotationPath;
/// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
/// assert_eq!(quarter.path(), RotationPath::Short);
/// let round = quarter.along(RotationPath::Long);
/// assert_eq!(round, -quarter);
/// // Three quarters about the opposite axis.
/// let (axis, angle) = round.to_axis_angle();
/// assert_eq!(axis, [0.0, 0.0, -1.0]);
/// assert!((angle - 1.5 * std::f64::consts::PI).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RotationPath {
    /// By at most a half turn.
    #[default]
    Short,
    /// By at least a half turn.
    Long,
}

impl RotationPath {
    /// 1 or −1: what a versor with this scalar part is multiplied by to go this way.
    pub(super) fn sign<S: Real>(self, scalar: S) -> S {
        let (plus, minus) = match self {
            Self::Short => (S::one(), -S::one()),
            Self::Long => (-S::one(), S::one()),
        };
        S::select(scalar.less_than(S::zero()), minus, plus)
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The way that the rotation takes. A half turn, whose ways are equally long, counts as short.
    #[inline]
    #[must_use]
    pub fn path(self) -> RotationPath {
        path(self.scalar())
    }

    /// The rotation by the shortest way from one direction to another, or by the longest, which
    /// goes the other way round in the same plane: the paper's eqs 23 and 24. `None` as for
    /// [`between`](Self::between).
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// use ga_runtime::geometry::RotationPath;
    /// let long =
    ///     Rotor::between_along([1.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0], RotationPath::Long).unwrap();
    /// let (axis, angle) = long.to_axis_angle();
    /// assert!(axis[2] < -0.9 && (angle - 1.5 * std::f64::consts::PI).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn between_along(from: [S; 3], to: [S; 3], path: RotationPath) -> Option<Self> {
        Some(Self::between(from, to)?.along(path))
    }
}

impl<S: Real> Rotor<S> {
    /// The rotor of the same rotation that takes a given way: itself or its negative. A half turn
    /// is itself by the short way and its negative by the long way.
    #[inline]
    #[must_use]
    pub fn along(self, path: RotationPath) -> Self {
        let sign = path.sign(self.scalar());
        let [e12, e13, e23] = [self.e12(), self.e13(), self.e23()].map(|x| x * sign);
        Self::new_unchecked(self.scalar() * sign, e12, e13, e23)
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The way that the rotation of the motion takes. A half turn, whose ways are equally long,
    /// counts as short.
    #[inline]
    #[must_use]
    pub fn path(self) -> RotationPath {
        path(self.scalar())
    }
}

impl<S: Real> Motor<S> {
    /// The motor of the same motion that takes a given way round: itself or its negative. A half
    /// turn is itself by the short way and its negative by the long way.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Rotor};
    /// use ga_runtime::geometry::RotationPath;
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
    /// let motor = Motor::from(quarter);
    /// assert_eq!(motor.along(RotationPath::Short), motor);
    /// assert_eq!(motor.along(RotationPath::Long), -motor);
    /// ```
    #[inline]
    #[must_use]
    pub fn along(self, path: RotationPath) -> Self {
        let sign = path.sign(self.scalar());
        let [e12, e13, e23] = [self.e12(), self.e13(), self.e23()].map(|x| x * sign);
        let [e1i, e2i, e3i] = [self.e1i(), self.e2i(), self.e3i()].map(|x| x * sign);
        let (scalar, e123i) = (self.scalar() * sign, self.e123i() * sign);
        Self::new_unchecked(scalar, e12, e13, e23, e1i, e2i, e3i, e123i)
    }
}

fn path<S: Real<Mask = bool>>(scalar: S) -> RotationPath {
    if scalar.less_than(S::zero()) {
        RotationPath::Long
    } else {
        RotationPath::Short
    }
}
