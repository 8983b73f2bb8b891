//! Rotors, translators and motors of pga3.

use crate::cga3;
use crate::geometry::number::are_numbers;
use crate::pga3::{Line, Motor, MotorSum, Point, Rotor, Translator};
use crate::scalar::{Field, Maybe, Real};
use crate::vga3::Vector;

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotation by an angle in radians about an axis through the origin, right-handed:
    /// `R = cos ½θ − sin ½θ (n1 e23 − n2 e13 + n3 e12)`. The axis need not have length 1; `None`
    /// where it is zero or not finite, or the angle is not finite.
    #[must_use]
    pub fn from_axis_angle(axis: [S; 3], angle: S) -> Option<Self> {
        cga3::Rotor::from_axis_angle(axis, angle).map(Self::from)
    }

    /// The axis of length 1 and the angle in [0, 2π], as in [`cga3::Rotor::to_axis_angle`].
    #[must_use]
    pub fn to_axis_angle(self) -> ([S; 3], S) {
        cga3::Rotor::from(self).to_axis_angle()
    }

    /// The shortest rotation from one direction to another; `None` where one is zero or not finite.
    #[must_use]
    pub fn between(from: [S; 3], to: [S; 3]) -> Option<Self> {
        cga3::Rotor::between(from, to).map(Self::from)
    }
}

impl<S: Field> Translator<S> {
    /// The translation by t: `T = 1 + ½ t e0`. The coefficients of e10, e20, e30 are half the
    /// displacement.
    ///
    /// ```
    /// use ga_runtime::pga3::{Point, Translator};
    /// let translation = Translator::from_displacement([1.0, 2.0, 3.0]);
    /// let moved = translation.transform(Point::from([1.0, 0.0, 0.0]));
    /// assert_eq!(moved, Point::from([2.0, 2.0, 3.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_displacement(displacement: [S; 3]) -> Self {
        let [x, y, z] = displacement.map(|x| x * S::from_ratio(1, 2));
        Self::new(x, y, z)
    }

    /// The displacement t.
    #[inline]
    #[must_use]
    pub fn displacement(self) -> [S; 3] {
        [self.e10(), self.e20(), self.e30()].map(|x| x * S::from_integer(2))
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
    #[inline]
    #[must_use]
    pub fn translator(self) -> Translator<S> {
        let origin = Point::from_coordinates([S::zero(); 3]);
        Translator::from_displacement(self.transform(origin).homogeneous())
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The screw about a line: a rotation by an angle, right-handed about its direction, and a
    /// translation along it. `None` for an ideal line, or where a number is not finite.
    ///
    /// ```
    /// use ga_runtime::pga3::{Line, Motor, Point};
    /// let axis = Line::from_point_direction([1.0, 0.0, 0.0], [0.0, 0.0, 2.0]);
    /// let screw = Motor::from_screw(axis, std::f64::consts::PI, 3.0).unwrap();
    /// let [x, y, z] = screw.transform(Point::from([2.0, 0.0, 0.0])).coordinates().unwrap();
    /// assert!(x.abs() < 1e-15 && y.abs() < 1e-15 && (z - 3.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn from_screw(axis: Line<S>, angle: S, displacement: S) -> Option<Self> {
        let line = axis.normalized()?;
        let direction = line.direction();
        let half = S::from_ratio(-1, 2);
        let direction = Vector::from(direction);
        let moment = Vector::from(line.moment()) * angle + direction * displacement;
        let generator = Line::from_direction_moment(
            (direction * (angle * half)).into(),
            (moment * half).into(),
        );
        let usable = are_numbers(generator.direction()) && are_numbers(generator.moment());
        usable.then(|| generator.exp())
    }

    /// The bivector B with `exp(B) = M`, for a rotation by θ in [0, 2π], so that `exp(B)` restores
    /// the sign of M too. Conventions are those of [`cga3::Motor::log`]; NaN stays NaN.
    ///
    /// ```
    /// use ga_runtime::pga3::{Motor, Rotor, Translator};
    /// let rotation = Rotor::from_axis_angle([0.0_f64, 1.0, 0.0], 2.0).unwrap();
    /// let motor: Motor<f64> = Translator::from_displacement([1.0, 2.0, 3.0]) * rotation;
    /// assert!((motor.log().exp().e10() - motor.e10()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn log(self) -> Line<S> {
        cga3::Motor::from(self).log().into()
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1 along a screw at constant speed,
    /// by the shorter rotation: `M exp(t log(~M N))`.
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        cga3::Motor::from(self).interpolate(other.into(), t).into()
    }

    /// The matrix `[R | t]` by rows: `x' = R x + t`.
    #[must_use]
    pub fn to_matrix(self) -> [[S; 4]; 3] {
        cga3::Motor::from(self).to_matrix()
    }

    /// The motor of a matrix `[R | t]` by rows; `None` where R is not a rotation within √ε, or t is
    /// not finite.
    #[must_use]
    pub fn from_matrix(rows: [[S; 4]; 3]) -> Option<Self> {
        cga3::Motor::from_matrix(rows).map(Self::from)
    }
}

impl<S: Real> MotorSum<S> {
    /// The motor nearest to a sum of motors; see [`Motor::normalize`].
    #[inline]
    #[must_use]
    pub fn normalize(self) -> Maybe<Motor<S>, S> {
        Motor::normalize(self)
    }
}
