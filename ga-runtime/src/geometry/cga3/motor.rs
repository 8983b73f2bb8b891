//! Motors from their parts and matrices, and back.

use crate::cga3::{DualQuaternion, Motor, Point, Rotor, Translator};
use crate::geometry::number::{are_numbers, is_moderate};
use crate::scalar::{Field, Mask, Maybe, Optional, Real};

impl<S: Real<Mask = bool>> Motor<S> {
    /// The rotation by a rotor about a point instead of the origin, `T(p) R T(−p)`.
    #[inline]
    #[must_use]
    pub fn about(point: Point<S>, rotor: Rotor<S>) -> Self {
        let turned = rotor.transform(point);
        Translator::from_displacement(turned.vector_to(point).into()) * rotor
    }

    /// The motor of a matrix `[R | t]` by rows; `None` where R is not a rotation within √ε, or t is
    /// not finite.
    #[inline]
    #[must_use]
    pub fn from_matrix(rows: [[S; 4]; 3]) -> Option<Self> {
        let rotor = Rotor::from_matrix(rows.map(|[x, y, z, _]| [x, y, z]))?;
        let displacement = rows.map(|row| row[3]);
        are_numbers(displacement).then(|| Translator::from_displacement(displacement) * rotor)
    }
}

impl<S: Field> Motor<S> {
    /// The rotation R of `M = T R`, which is applied first.
    #[inline]
    #[must_use]
    pub fn rotor(self) -> Rotor<S> {
        Rotor::new_unchecked(self.scalar(), self.e12(), self.e13(), self.e23())
    }

    /// The translation T of `M = T R`, which is applied second. It is the displacement of the
    /// origin.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Rotor, Translator};
    /// let rotation = Rotor::from_axis_angle([1.0, 2.0, 3.0], 0.7).unwrap();
    /// let motor = Translator::from_displacement([1.0, -2.0, 0.5]) * rotation;
    /// let [x, y, z]: [f64; 3] = motor.translator().displacement();
    /// assert!((x - 1.0).abs() < 1e-15 && (y + 2.0).abs() < 1e-15 && (z - 0.5).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn translator(self) -> Translator<S> {
        let (s, d0) = (self.scalar(), self.e123i());
        let [q12, q13, q23] = [self.e12(), self.e13(), self.e23()];
        let [d1, d2, d3] = [self.e1i(), self.e2i(), self.e3i()];
        // Minus half the displacement.
        let half = [
            s * d1 + q12 * d2 + (q13 * d3 + q23 * d0),
            s * d2 - q12 * d1 + (q23 * d3 - q13 * d0),
            s * d3 - q13 * d1 + (q12 * d0 - q23 * d2),
        ];
        Translator::from_displacement(half.map(|x| S::zero() - (x + x)))
    }

    /// The matrix `[R | t]` by rows: `x' = R x + t`.
    #[inline]
    #[must_use]
    pub fn to_matrix(self) -> [[S; 4]; 3] {
        let [r0, r1, r2] = self.rotor().to_matrix();
        let [x, y, z] = self.translator().displacement();
        [
            [r0[0], r0[1], r0[2], x],
            [r1[0], r1[1], r1[2], y],
            [r2[0], r2[1], r2[2], z],
        ]
    }
}

impl<S: Real> DualQuaternion<S> {
    /// The motor nearest to a sum of motors; see [`Motor::normalize`].
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let (a, b) = (
    ///     Motor::default(),
    ///     Motor::from(Translator::from_displacement([2.0, 0.0, 0.0])),
    /// );
    /// let blend = (a * 0.25 + b * 0.75).normalize().unwrap();
    /// assert_eq!(blend.translator().displacement(), [1.5, 0.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn normalize(self) -> Maybe<Motor<S>, S> {
        let (motor, size) = self.divided_by_norm();
        is_moderate(size)
            .when(motor)
            .or_else_of(self, Motor::normalize)
    }

    /// The motor nearest to a sum of motors, without a check, and a number that is moderate only
    /// where every intermediate result is in the range of the scalar.
    #[inline(always)]
    pub(super) fn divided_by_norm(self) -> (Motor<S>, S) {
        // The real part q and the other part d as quaternions: q is scaled to length 1, and what d
        // has along q is removed.
        let Self {
            scalar,
            e12,
            e13,
            e23,
            e1i,
            e2i,
            e3i,
            e123i,
        } = self;
        let square = scalar * scalar + e12 * e12 + e13 * e13 + e23 * e23;
        let inverse = square.recip();
        let along = (scalar * e123i - e12 * e3i + (e13 * e2i - e23 * e1i)) * inverse;
        let d = [
            e1i + e23 * along,
            e2i - e13 * along,
            e3i + e12 * along,
            e123i - scalar * along,
        ];
        let sum = d[0] + d[1] + (d[2] + d[3]);
        // The sum is moderate only if each of its terms is finite.
        let size = square + inverse + sum.abs();
        let scale = inverse.sqrt();
        let [scalar, e12, e13, e23] = [scalar, e12, e13, e23].map(|x| x * scale);
        let [e1i, e2i, e3i, e123i] = d.map(|x| x * scale);
        let motor = Motor::new_unchecked(scalar, e12, e13, e23, e1i, e2i, e3i, e123i);
        (motor, size)
    }
}
