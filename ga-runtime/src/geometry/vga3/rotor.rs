//! Rotors of vga3, which are those of cga3, and quaternions.

use crate::cga3;
use crate::scalar::{Maybe, Real, Ring};
use crate::vga3::{Bivector, Quaternion, Rotor, Vector};

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotation by an angle in radians about an axis, right-handed:
    /// `R = cos ½θ − sin ½θ (n1 e23 − n2 e13 + n3 e12)`. The axis need not have length 1; `None`
    /// where it is zero or not finite, or the angle is not finite.
    #[must_use]
    pub fn from_axis_angle(axis: Vector<S>, angle: S) -> Option<Self> {
        cga3::Rotor::from_axis_angle(axis.into(), angle).map(Self::from)
    }

    /// The axis of length 1 and the angle in [0, 2π] of the rotation; the axis is e3 where the
    /// angle is 0 or 2π. A rotor and its negative rotate to the same orientation the opposite way
    /// round: their angles add to 2π.
    #[must_use]
    pub fn to_axis_angle(self) -> (Vector<S>, S) {
        let (axis, angle) = cga3::Rotor::from(self).to_axis_angle();
        (axis.into(), angle)
    }

    /// The shortest rotation from the direction of one vector to that of another; for opposite
    /// directions a half turn about some axis perpendicular to them. `None` where one is zero or
    /// not finite.
    #[must_use]
    pub fn between(from: Vector<S>, to: Vector<S>) -> Option<Self> {
        cga3::Rotor::between(from.into(), to.into()).map(Self::from)
    }

    /// The rotor of the rotation of a quaternion `w + x i + y j + z k`, given as `[x, y, z]` and w:
    /// `w − x e23 + y e13 − z e12`. The quaternion need not have length 1; `None` where it is zero
    /// or not finite.
    ///
    /// ```
    /// use ga_runtime::vga3::{Rotor, Vector};
    /// // k rotates by 180° about z.
    /// let rotor = Rotor::from_quaternion([0.0, 0.0, 1.0], 0.0).unwrap();
    /// assert_eq!(rotor.e12(), -1.0);
    /// assert_eq!(rotor.transform(Vector::new(1.0, 2.0, 3.0)), Vector::new(-1.0, -2.0, 3.0));
    /// ```
    #[must_use]
    pub fn from_quaternion(vector: [S; 3], scalar: S) -> Option<Self> {
        cga3::Rotor::from_quaternion(vector, scalar).map(Self::from)
    }

    /// The unit quaternion of the same rotation, `[x, y, z]` and w.
    #[inline]
    #[must_use]
    pub fn to_quaternion(self) -> ([S; 3], S) {
        cga3::Rotor::from(self).to_quaternion()
    }

    /// The rotor of a rotation matrix given by rows; `None` where the matrix is not a rotation
    /// within √ε.
    #[must_use]
    pub fn from_matrix(rows: [[S; 3]; 3]) -> Option<Self> {
        cga3::Rotor::from_matrix(rows).map(Self::from)
    }

    /// The rotation matrix by rows: `x' = matrix · x`.
    #[must_use]
    pub fn to_matrix(self) -> [[S; 3]; 3] {
        cga3::Rotor::from(self).to_matrix()
    }

    /// The bivector B with `exp(B) = R` and `|B|` in [0, π], so that `exp(B)` restores the sign of
    /// R too: `−½θb` for a rotation by θ in the plane of the unit bivector b. The logarithm of −1
    /// is `π e12`. NaN stays NaN.
    #[must_use]
    pub fn log(self) -> Bivector<S> {
        let vector = Vector::new(self.e12(), self.e13(), self.e23());
        let (sine, cosine) = (vector.length(), self.scalar());
        let angle = sine.atan2(cosine);
        let plane = match vector.normalized() {
            Some(plane) => plane,
            None if S::zero().less_than(angle) => Vector::new(S::one(), S::zero(), S::zero()),
            // Zero, or NaN where the rotor is NaN.
            None => vector,
        };
        let [x, y, z] = (plane * angle).coordinates();
        Bivector::new(x, y, z)
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1 with constant angular velocity
    /// and by the shorter rotation, `R exp(t log(~R S))`: spherical linear interpolation (Shoemake,
    /// Animating Rotation with Quaternion Curves, 1985).
    ///
    /// ```
    /// use ga_runtime::vga3::{Rotor, Vector};
    /// let quarter =
    ///     Rotor::between(Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0)).unwrap();
    /// let (_, angle) = Rotor::default().interpolate(quarter, 0.5).to_axis_angle();
    /// assert!((angle - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        let mut between = self.reverse() * other;
        if between.scalar().less_than(S::zero()) {
            between = -between;
        }
        self * (between.log() * t).exp()
    }
}

impl<S: Real> Quaternion<S> {
    /// The rotor nearest to a sum of rotors; see [`Rotor::normalize`].
    #[inline]
    #[must_use]
    pub fn normalize(self) -> Maybe<Rotor<S>, S> {
        Rotor::normalize(self)
    }
}

/// The same rotor, coefficient by coefficient.
impl<S: Ring> From<cga3::Rotor<S>> for Rotor<S> {
    #[inline]
    fn from(rotor: cga3::Rotor<S>) -> Self {
        Self::new_unchecked(rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23())
    }
}

/// The same rotor, coefficient by coefficient.
impl<S: Ring> From<Rotor<S>> for cga3::Rotor<S> {
    #[inline]
    fn from(rotor: Rotor<S>) -> Self {
        Self::new_unchecked(rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23())
    }
}
