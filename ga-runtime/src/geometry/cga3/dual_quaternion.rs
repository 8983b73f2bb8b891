//! Motors as unit dual quaternions, and back.
//!
//! A dual quaternion is `q + ε d` with two quaternions and ε² = 0. The element e123i commutes with
//! every motor and squares to zero, as ε does; with `i = −e23`, `j = e13`, `k = −e12` and
//! `ε = −e123i` motors are the unit dual quaternions.

use core::fmt::{Display, Formatter, Result as FormatResult};

use crate::cga3::{DualQuaternion, Motor};
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

/// The eight numbers of a dual quaternion `q + ε d`, as other libraries write them.
///
/// A motor that rotates by q and then translates by t has `d = ½ t q`, where t is the quaternion
/// `t1 i + t2 j + t3 k`; a point x goes to `q̂ (1 + ε x) q̂*`, where `q̂* = q* − ε d*` has both
/// quaternions conjugated and ε negated (Kavan et al., Geometric Skinning with Approximate Dual
/// Quaternion Blending, 2008).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DualQuaternionParts<S> {
    /// `[x, y, z]` and w of the quaternion `q = w + x i + y j + z k`.
    pub real: ([S; 3], S),
    /// `[x, y, z]` and w of the quaternion d.
    pub dual: ([S; 3], S),
}

/// The error for a dual quaternion that is not a rigid motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotUnit {
    /// A number is infinite or not a number.
    NotFinite,
    /// The real quaternion is zero, so it does not define a rotation.
    NoRotation,
    /// The quaternions are not perpendicular, `|q·d| > √ε |q| max(|q|, |d|)`: the Study condition
    /// is violated by more than rounding.
    NotPerpendicular,
}

impl Display for NotUnit {
    fn fmt(&self, f: &mut Formatter<'_>) -> FormatResult {
        f.write_str(match self {
            Self::NotFinite => "the dual quaternion is not finite",
            Self::NoRotation => "the real part of the dual quaternion is zero",
            Self::NotPerpendicular => {
                "the dual part of the dual quaternion is not perpendicular to the real part"
            }
        })
    }
}

impl core::error::Error for NotUnit {}

impl<S: Ring> DualQuaternion<S> {
    /// The same element as quaternions: `q = s − e23 i + e13 j − e12 k` by coefficients,
    /// `d = −e123i − e1i i − e2i j − e3i k`.
    #[inline]
    #[must_use]
    pub fn to_parts(self) -> DualQuaternionParts<S> {
        DualQuaternionParts {
            real: ([-self.e23, self.e13, -self.e12], self.scalar),
            dual: ([-self.e1i, -self.e2i, -self.e3i], -self.e123i),
        }
    }

    /// The element of two quaternions, without a check.
    #[inline]
    #[must_use]
    pub fn from_parts(parts: DualQuaternionParts<S>) -> Self {
        let ([x, y, z], w) = parts.real;
        let ([dx, dy, dz], dw) = parts.dual;
        Self::new(w, -z, y, -x, -dx, -dy, -dz, -dw)
    }
}

impl<S: Ring> Motor<S> {
    /// The unit dual quaternion of this motion.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let motor = Motor::from(Translator::from_displacement([2.0, 4.0, 6.0]));
    /// let parts = motor.to_dual_quaternion();
    /// assert_eq!(parts.real, ([0.0; 3], 1.0));
    /// // Half the displacement, with plus signs.
    /// assert_eq!(parts.dual, ([1.0, 2.0, 3.0], 0.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn to_dual_quaternion(self) -> DualQuaternionParts<S> {
        DualQuaternion::from(self).to_parts()
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The motor of a dual quaternion, which need not have length 1; a small component of d along
    /// q, due to rounding, is removed.
    ///
    /// # Errors
    ///
    /// Those of [`NotUnit`].
    ///
    /// ```
    /// use ga_runtime::cga3::Motor;
    /// use ga_runtime::geometry::{DualQuaternionParts, NotUnit};
    /// let parts = DualQuaternionParts {
    ///     real: ([0.0, 0.0, 0.0], 2.0),
    ///     dual: ([2.0, 4.0, 6.0], 0.0),
    /// };
    /// let motor: Motor<f64> = Motor::from_dual_quaternion(parts).unwrap();
    /// assert_eq!(motor.translator().displacement(), [2.0, 4.0, 6.0]);
    /// let skew = DualQuaternionParts {
    ///     dual: ([2.0, 4.0, 6.0], 1.0),
    ///     ..parts
    /// };
    /// assert_eq!(
    ///     Motor::from_dual_quaternion(skew),
    ///     Err(NotUnit::NotPerpendicular)
    /// );
    /// ```
    pub fn from_dual_quaternion(parts: DualQuaternionParts<S>) -> Result<Self, NotUnit> {
        let ((real, w), (dual, dw)) = (parts.real, parts.dual);
        let numbers = [real, dual, [w, dw, S::zero()]];
        if !numbers.iter().flatten().all(|number| number.is_finite()) {
            return Err(NotUnit::NotFinite);
        }
        // Both are scaled to size 1, so that no square is beyond the range of the scalar.
        let (size, dual_size) = (size(real, w), size(dual, dw));
        if !S::zero().less_than(size) {
            return Err(NotUnit::NoRotation);
        }
        if S::zero().less_than(dual_size) {
            let (q, d) = (real.map(|x| x / size), dual.map(|x| x / dual_size));
            let along = Vector::from(q).dot(d.into()) + (w / size) * (dw / dual_size);
            let weight = (dual_size / size).min(S::one());
            if S::epsilon().sqrt().less_than(along.abs() * weight) {
                return Err(NotUnit::NotPerpendicular);
            }
        }
        let sum = DualQuaternion::from_parts(DualQuaternionParts {
            real: (real.map(|x| x / size), w / size),
            dual: (dual.map(|x| x / size), dw / size),
        });
        Self::normalize(sum).ok_or(NotUnit::NotFinite)
    }
}

/// The length of a quaternion.
fn size<S: Real<Mask = bool>>(vector: [S; 3], scalar: S) -> S {
    Vector::new(Vector::from(vector).length(), scalar, S::zero()).length()
}
