//! The two rotations to the same orientation: the shorter and the longer one.

use crate::cga3::{Motor, Rotor};
use crate::scalar::Real;

/// The two ways of rotating to the same orientation: by an angle of at most a half turn, or the
/// other way round by the rest of a full turn.
///
/// A rotor and its negative represent the same rotation, and the sign distinguishes the two ways
/// (Cui, eqs. 23 and 24, corrected): with I the unit bivector of the plane,
///
/// ```text
/// R  = cos ½θ − sin ½θ I = exp(−½ θ I)    by θ ≤ π, scalar part ≥ 0
/// −R = exp(½ (2π − θ) I)                  by 2π − θ the other way round, scalar part ≤ 0
/// ```
///
/// The same holds for a motor: the screws of both ways have the same axis and the same translation
/// along it.
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
    /// 1 or −1: the factor of a versor with this scalar part for which it takes this path.
    pub(super) fn sign<S: Real>(self, scalar: S) -> S {
        let (plus, minus) = match self {
            Self::Short => (S::one(), -S::one()),
            Self::Long => (-S::one(), S::one()),
        };
        S::select(scalar.less_than(S::zero()), minus, plus)
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The path of the rotation. For a half turn both are equally long, and the path is short.
    #[inline]
    #[must_use]
    pub fn path(self) -> RotationPath {
        path(self.scalar())
    }

    /// The shortest rotation from one direction to another, or the longer one, which goes the other
    /// way round in the same plane (Cui, eqs. 23 and 24). `None` as for [`between`](Self::between).
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
    /// The rotor of the same rotation that takes a given path: itself or its negative. For a half
    /// turn, the short path is the rotor itself and the long path its negative.
    #[inline]
    #[must_use]
    pub fn along(self, path: RotationPath) -> Self {
        let sign = path.sign(self.scalar());
        let [e12, e13, e23] = [self.e12(), self.e13(), self.e23()].map(|x| x * sign);
        Self::new_unchecked(self.scalar() * sign, e12, e13, e23)
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The path of the motion's rotation. For a half turn both are equally long, and the path is
    /// short.
    #[inline]
    #[must_use]
    pub fn path(self) -> RotationPath {
        path(self.scalar())
    }
}

impl<S: Real> Motor<S> {
    /// The motor of the same motion that takes a given path: itself or its negative. For a half
    /// turn, the short path is the motor itself and the long path its negative.
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
