//! Rotors from axes, matrices and vectors, and back.

use super::logarithm::turn_exponential;
use crate::cga3::{Quaternion, Rotor};
use crate::geometry::number::is_regular;
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotation by an angle in radians about an axis through the origin, right-handed:
    /// `R = cos ½θ − sin ½θ (n1 e23 − n2 e13 + n3 e12)`. The axis need not have length 1; `None`
    /// where it is zero or not finite, or the angle is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Rotor};
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 2.0], std::f64::consts::FRAC_PI_2).unwrap();
    /// let [x, y, z] = quarter.transform(Point::new(1.0, 0.0, 5.0)).coordinates();
    /// assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 5.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn from_axis_angle(axis: [S; 3], angle: S) -> Option<Self> {
        if !angle.is_finite() {
            return None;
        }
        let unit = Vector::from(axis).normalized()?;
        let (sine, cosine) = (angle * S::from_ratio(1, 2)).sin_cos();
        Some(Self::from_quaternion_unchecked(unit * sine, cosine))
    }

    /// The angle in [0, 2π] and the axis of length 1 of the rotation; the axis is e3 where the
    /// angle is 0 or 2π. A rotor and its negative rotate to the same orientation the opposite way
    /// round: their angles add to 2π.
    #[must_use]
    pub fn to_axis_angle(self) -> ([S; 3], S) {
        let (vector, scalar) = self.to_quaternion();
        let vector = Vector::from(vector);
        let half_angle = vector.length().atan2(scalar);
        let upright = Vector::new(S::zero(), S::zero(), S::one());
        let axis = vector.normalized().unwrap_or(upright);
        (axis.into(), half_angle + half_angle)
    }

    /// Of the rotor and its negative, which rotate to the same orientation, the one that rotates by
    /// π at most: its scalar is not negative.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// use std::f64::consts::PI;
    /// let long = Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.5 * PI).unwrap();
    /// let (axis, angle) = long.canonical().to_axis_angle();
    /// assert!((angle - 0.5 * PI).abs() < 1e-15 && (axis[2] + 1.0).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn canonical(self) -> Self {
        if self.scalar().less_than(S::zero()) {
            -self
        } else {
            self
        }
    }

    /// The rotation by |v| radians about the direction of v, right-handed:
    /// `exp(−½ (v1 e23 − v2 e13 + v3 e12))`. The identity for zero; `None` where v is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let rotation = Rotor::from_rotation_vector([0.0, 0.0, 1.5_f64]).unwrap();
    /// let same = Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.5).unwrap();
    /// assert!(
    ///     (rotation.scalar() - same.scalar()).abs() < 1e-15
    ///         && (rotation.e12() - same.e12()).abs() < 1e-15
    /// );
    /// assert!((rotation.to_rotation_vector()[2] - 1.5).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn from_rotation_vector([x, y, z]: [S; 3]) -> Option<Self> {
        let half = S::from_ratio(1, 2);
        let is_finite = x.is_finite() && y.is_finite() && z.is_finite();
        is_finite.then(|| turn_exponential(Vector::new(-(half * z), half * y, -(half * x))))
    }

    /// The rotation vector: the axis of the rotation with a length of the angle in [0, 2π]. It has
    /// minus twice the coefficients of [`log`](Self::log).
    #[must_use]
    pub fn to_rotation_vector(self) -> [S; 3] {
        let turn = self.log();
        [-turn.e23, turn.e13, -turn.e12].map(|x| x * S::from_integer(2))
    }

    /// The shortest rotation from one direction to another. For opposite directions it is a half
    /// turn about some axis perpendicular to them. `None` where a direction is zero or not finite.
    ///
    /// This is Cui, eq. 23, corrected: `R = (b + a) a / (|a| |a + b|)` for unit a and b.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Rotor};
    /// let rotor = Rotor::between([1.0_f64, 0.0, 0.0], [0.0, 3.0, 0.0]).unwrap();
    /// let [x, y, _] = rotor.transform(Point::new(2.0, 0.0, 0.0)).coordinates();
    /// assert!(x.abs() < 1e-15 && (y - 2.0).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn between(from: [S; 3], to: [S; 3]) -> Option<Self> {
        let [a, b] = [from, to].map(Vector::from);
        let [a_squared, b_squared] = [a, b].map(Vector::length_squared);
        let product = a_squared * b_squared;
        if is_regular(a_squared) & is_regular(b_squared) & is_regular(product) {
            // The product b a is |a| |b| (cos θ − sin θ B): adding |a| |b| halves the angle. Near
            // opposite directions the sum would cancel.
            let (size, along) = (product.sqrt(), a.dot(b));
            if (size * S::from_ratio(-7, 8)).less_than(along) {
                let (vector, scalar) = (a.cross(b), size + along);
                let square = vector.length_squared() + scalar * scalar;
                let inverse = square.sqrt().recip();
                return Some(Self::from_quaternion_unchecked(
                    vector * inverse,
                    scalar * inverse,
                ));
            }
        }
        Self::between_any(from, to)
    }

    /// The same for directions of any size, and for opposite ones.
    #[cold]
    #[inline(never)]
    fn between_any(from: [S; 3], to: [S; 3]) -> Option<Self> {
        let [a, b] = [from, to].map(|v| Vector::from(v).normalized());
        let (a, b) = (a?, b?);
        // The cosine and the sine of half the angle are half the lengths of b + a and b − a.
        let (sum, half) = (a + b, S::from_ratio(1, 2));
        let length = sum.length();
        if !a.dot(b).less_than(S::zero()) {
            let vector = a.cross(b).divided(length);
            return Some(Self::from_quaternion_unchecked(vector, length * half));
        }
        // The axis is computed from a + b, which is accurate even if b is close to −a.
        let axis = a
            .cross(sum)
            .normalized()
            .or_else(|| a.cross(smallest_axis(a)).normalized())?;
        let vector = axis * ((b - a).length() * half);
        Some(Self::from_quaternion_unchecked(vector, length * half))
    }

    /// The rotor of the rotation of a quaternion `w + x i + y j + z k`, given as `[x, y, z]` and w:
    /// i = −e23, j = e13, k = −e12. The quaternion need not have length 1, and may be as large or
    /// small as the scalar allows; `None` where it is zero or not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let rotor = Rotor::from_quaternion([0.0_f64, 3e200, 0.0], 4e200).unwrap();
    /// let ([_, y, _], w) = rotor.to_quaternion();
    /// assert!((y - 0.6).abs() < 1e-15 && (w - 0.8).abs() < 1e-15);
    /// assert_eq!(Rotor::from_quaternion([0.0; 3], 0.0), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn from_quaternion(vector: [S; 3], scalar: S) -> Option<Self> {
        let [x, y, z] = vector;
        Self::normalize(Quaternion::new(scalar, -z, y, -x))
    }

    /// The rotor of a rotation matrix given by rows (Cui, eq. 25, corrected): of the four quotients
    /// that give the rotor, one whose divisor is at least 1 is used, so that half turns are not
    /// special cases. `None` where the matrix is not a rotation within √ε.
    #[inline(always)]
    #[must_use]
    pub fn from_matrix(rows: [[S; 3]; 3]) -> Option<Self> {
        let [r0, r1, r2] = rows;
        let [x, y, z] = rows.map(Vector::from);
        let one = S::one();
        let deviations = [
            x.dot(x) - one,
            y.dot(y) - one,
            z.dot(z) - one,
            x.dot(y),
            x.dot(z),
            y.dot(z),
            x.cross(y).dot(z) - one,
        ];
        let tolerance = S::epsilon().sqrt();
        // Without a number, no comparison holds. All are made, without a branch after each.
        let is_rotation = deviations
            .into_iter()
            .fold(true, |all, x| all & x.abs().less_or_equal(tolerance));
        if !is_rotation {
            return None;
        }
        let [xx, yy, zz] = [r0[0], r1[1], r2[2]];
        let [dx, dy, dz] = [r2[1] - r1[2], r0[2] - r2[0], r1[0] - r0[1]];
        let [yz, zx, xy] = [r1[2] + r2[1], r0[2] + r2[0], r0[1] + r1[0]];
        // Four times the quaternion times one of its components, which is at least a half.
        let (vector, w) = if zz.less_than(S::zero()) {
            if yy.less_than(xx) {
                ([one + xx - yy - zz, xy, zx], dx)
            } else {
                ([xy, one - xx + yy - zz, yz], dy)
            }
        } else if xx.less_than(-yy) {
            ([zx, yz, one - xx - yy + zz], dz)
        } else {
            ([dx, dy, dz], one + xx + yy + zz)
        };
        let vector = Vector::from(vector);
        let length = (vector.length_squared() + w * w).sqrt();
        let inverse = S::select(w.less_than(S::zero()), -length, length).recip();
        Some(Self::from_quaternion_unchecked(
            vector * inverse,
            w * inverse,
        ))
    }

    #[inline]
    fn from_quaternion_unchecked(Vector { e1, e2, e3 }: Vector<S>, w: S) -> Self {
        Self::new_unchecked(w, -e3, e2, -e1)
    }
}

impl<S: Ring> Rotor<S> {
    /// The unit quaternion of the same rotation, `[x, y, z]` and w.
    #[inline]
    #[must_use]
    pub fn to_quaternion(self) -> ([S; 3], S) {
        ([-self.e23(), self.e13(), -self.e12()], self.scalar())
    }

    /// The rotation matrix by rows: `x' = matrix · x`.
    #[inline]
    #[must_use]
    pub fn to_matrix(self) -> [[S; 3]; 3] {
        let ([x, y, z], w) = self.to_quaternion();
        let (one, two) = (S::one(), S::from_integer(2));
        [
            [
                one - two * (y * y + z * z),
                two * (x * y - w * z),
                two * (x * z + w * y),
            ],
            [
                two * (x * y + w * z),
                one - two * (x * x + z * z),
                two * (y * z - w * x),
            ],
            [
                two * (x * z - w * y),
                two * (y * z + w * x),
                one - two * (x * x + y * y),
            ],
        ]
    }
}

/// The basis vector along which a vector has its smallest component.
fn smallest_axis<S: Real<Mask = bool>>(vector: Vector<S>) -> Vector<S> {
    let mut least = 0;
    for place in 1..3 {
        if vector[place].abs().less_than(vector[least].abs()) {
            least = place;
        }
    }
    let mut axis = [S::zero(); 3];
    axis[least] = S::one();
    Vector::from(axis)
}
