//! Rotors, translators and motors of pga2.

use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{difference, dot, scaled};
use crate::pga2::{Motor, MotorSum, Point, Rotor, Translator};
use crate::scalar::{Field, Maybe, Real};

impl<S: Field> Translator<S> {
    /// The translation by t: `T = 1 + ½ t e0 = 1 + ½ (t2 e20 − t1 e01)`.
    ///
    /// ```
    /// use ga_runtime::pga2::{Point, Translator};
    /// let translation = Translator::from_displacement([1.0, 2.0]);
    /// assert_eq!(translation.transform(Point::from([3.0, 3.0])), Point::from([4.0, 5.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_displacement(displacement: [S; 2]) -> Self {
        let [x, y] = scaled(displacement, S::from_ratio(1, 2));
        Self::new(y, -x)
    }

    /// The displacement t.
    #[inline]
    #[must_use]
    pub fn displacement(self) -> [S; 2] {
        scaled([-self.e01(), self.e20()], S::from_integer(2))
    }
}

impl<S: Field> Motor<S> {
    /// The rotation R of `M = T R`, which is applied first.
    #[inline]
    #[must_use]
    pub fn rotor(self) -> Rotor<S> {
        Rotor::new_unchecked(self.scalar(), self.e12())
    }

    /// The translation T of `M = T R`, which is applied second. It is the displacement of the
    /// origin.
    #[inline]
    #[must_use]
    pub fn translator(self) -> Translator<S> {
        let origin = Point::from_coordinates([S::zero(); 2]);
        Translator::from_displacement(self.transform(origin).homogeneous())
    }

    /// The matrix `[R | t]` by rows: `x' = R x + t`.
    #[must_use]
    pub fn to_matrix(self) -> [[S; 3]; 2] {
        let [tx, ty] = self.translator().displacement();
        let (c, s) = (self.scalar(), self.e12());
        let (cosine, sine) = (c * c - s * s, -(c * s + c * s));
        [[cosine, -sine, tx], [sine, cosine, ty]]
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotation about the origin by an angle in radians, counterclockwise:
    /// `R = cos ½θ − sin ½θ e12`. `None` where the angle is not finite.
    #[must_use]
    pub fn from_angle(angle: S) -> Option<Self> {
        if !angle.is_finite() {
            return None;
        }
        let (sine, cosine) = (angle * S::from_ratio(1, 2)).sin_cos();
        Some(Self::new_unchecked(cosine, -sine))
    }

    /// The angle in [−2π, 2π]; a rotor and its negative rotate to the same orientation, and their
    /// angles differ by 2π.
    #[must_use]
    pub fn angle(self) -> S {
        let half = (-self.e12()).atan2(self.scalar());
        half + half
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The rotation by a rotor about a position instead of the origin, `T(p) R T(−p)`.
    ///
    /// ```
    /// use ga_runtime::pga2::{Motor, Point, Rotor};
    /// let rotation = Motor::about([1.0, 0.0], Rotor::from_angle(std::f64::consts::PI).unwrap());
    /// let [x, y] = rotation.transform(Point::from([3.0, 0.0])).coordinates().unwrap();
    /// assert!((x + 1.0).abs() < 1e-15 && y.abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn about(place: [S; 2], rotor: Rotor<S>) -> Self {
        let turned = rotor
            .transform(Point::from_coordinates(place))
            .homogeneous();
        Translator::from_displacement(difference(place, turned)) * rotor
    }

    /// The fixed point, about which the motor rotates; `None` for a translation, or where it is
    /// beyond the range of the scalar.
    #[must_use]
    pub fn centre(self) -> Option<Point<S>> {
        let place = [self.e20() / self.e12(), self.e01() / self.e12()];
        are_numbers(place).then(|| Point::from_coordinates(place))
    }

    /// The bivector B with `exp(B) = M` and a weight in [−π, π]: a point for a rotation, an ideal
    /// point for a translation. `None` for the negative of a translation other than the identity,
    /// which is not an exponential, and where a number is not finite. The logarithm of −1 is
    /// `π e12`.
    #[must_use]
    pub fn log(self) -> Option<Point<S>> {
        let (cosine, sine) = (self.scalar(), self.e12());
        let shift = [self.e20(), self.e01()];
        let weight = sine.atan2(cosine);
        if !are_numbers([cosine, sine]) {
            return None;
        }
        if sine == S::zero() && cosine.less_than(S::zero()) {
            let is_still = shift == [S::zero(); 2];
            let pi = S::from_f64(core::f64::consts::PI);
            return is_still.then(|| Point::from_homogeneous(shift, pi));
        }
        let ratio = if sine == S::zero() {
            S::one()
        } else {
            weight / sine
        };
        let ends = scaled(shift, ratio);
        are_numbers(ends).then(|| Point::from_homogeneous(ends, weight))
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1 with constant speed about one
    /// point, by the shorter rotation: `M exp(t log(~M N))`. NaN stays NaN.
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        let mut between = self.reverse() * other;
        if between.scalar().less_than(S::zero()) {
            between = -between;
        }
        // If the scalar part is not negative, only motors that are not finite have no logarithm.
        match between.log() {
            Some(generator) => self * (generator * t).exp(),
            None => self * between,
        }
    }

    /// The motor of a matrix `[R | t]` by rows; `None` where R is not a rotation within √ε, or a
    /// number is not finite.
    #[must_use]
    pub fn from_matrix([a, b]: [[S; 3]; 2]) -> Option<Self> {
        let tolerance = S::epsilon().sqrt();
        let (r0, r1, displacement) = ([a[0], a[1]], [b[0], b[1]], [a[2], b[2]]);
        for (value, expected) in [
            (dot(r0, r0), S::one()),
            (r0[0] - r1[1], S::zero()),
            (r0[1] + r1[0], S::zero()),
        ] {
            let deviation = (value - expected).abs();
            if !deviation.is_finite() || tolerance.less_than(deviation) {
                return None;
            }
        }
        let rotor = Rotor::from_angle((r1[0] - r0[1]).atan2(r0[0] + r1[1]))?;
        are_numbers(displacement).then(|| Translator::from_displacement(displacement) * rotor)
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
