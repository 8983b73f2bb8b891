//! Rotors, translators and motors of cga2.

use crate::cga2::{Motor, MotorGenerator, Point, Rotor, Translator};
use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{difference, scaled};
use crate::scalar::{Field, Real};

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

impl<S: Field> Translator<S> {
    /// The translation by t: `T = 1 − ½ t ei`.
    ///
    /// ```
    /// use ga_runtime::cga2::{Point, Translator};
    /// let translation = Translator::from_displacement([1.0, 2.0]);
    /// assert_eq!(translation.transform(Point::new(3.0, 3.0)), Point::new(4.0, 5.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_displacement(displacement: [S; 2]) -> Self {
        let [x, y] = scaled(displacement, S::from_ratio(-1, 2));
        Self::new(x, y)
    }

    /// The displacement t.
    #[inline]
    #[must_use]
    pub fn displacement(self) -> [S; 2] {
        scaled([self.e1i(), self.e2i()], S::from_integer(-2))
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
        Translator::from_displacement(self.transform(Point::default()).coordinates())
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The rotation by a rotor about a point instead of the origin, `T(p) R T(−p)`.
    ///
    /// ```
    /// use ga_runtime::cga2::{Motor, Point, Rotor};
    /// let half_turn = Rotor::from_angle(std::f64::consts::PI).unwrap();
    /// let moved = Motor::about(Point::new(1.0, 0.0), half_turn).transform(Point::new(3.0, 0.0));
    /// assert!(moved.distance(Point::new(-1.0, 0.0)) < 1e-15);
    /// ```
    #[must_use]
    pub fn about(point: Point<S>, rotor: Rotor<S>) -> Self {
        let rotated = rotor.transform(point).coordinates();
        Translator::from_displacement(difference(point.coordinates(), rotated)) * rotor
    }

    /// The fixed point, about which the motor rotates; `None` for a translation, or where it is
    /// beyond the range of the scalar.
    #[must_use]
    pub fn centre(self) -> Option<Point<S>> {
        let place = [-self.e2i() / self.e12(), self.e1i() / self.e12()];
        are_numbers(place).then(|| Point::from(place))
    }

    /// The generator G with `exp(G) = M` and the coefficient of e12 in [−π, π]. `None` for the
    /// negative of a translation other than the identity, which is not an exponential, and where a
    /// number is not finite. The logarithm of −1 is `π e12`.
    #[must_use]
    pub fn log(self) -> Option<MotorGenerator<S>> {
        let (cosine, sine) = (self.scalar(), self.e12());
        let [x, y] = [self.e1i(), self.e2i()];
        if !are_numbers([cosine, sine]) {
            return None;
        }
        if sine == S::zero() && cosine.less_than(S::zero()) {
            let is_still = [x, y] == [S::zero(); 2];
            let pi = S::from_f64(core::f64::consts::PI);
            return is_still.then(|| MotorGenerator::new(pi, x, y));
        }
        let angle = sine.atan2(cosine);
        let ratio = if sine == S::zero() {
            S::one()
        } else {
            angle / sine
        };
        let ends = [x * ratio, y * ratio];
        are_numbers(ends).then(|| MotorGenerator::new(angle, ends[0], ends[1]))
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The power `Mᵗ = exp(t log M)`: the rotation about the same point by t times the angle in
    /// [−2π, 2π], or t times the translation. `None` as for [`log`](Self::log).
    #[must_use]
    pub fn powf(self, t: S) -> Option<Self> {
        Some((self.log()? * t).exp())
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1 at constant speed about one
    /// point, `M exp(t log(~M N))`, by the shorter rotation. t may be outside [0, 1]. As for the
    /// motors of cga3 there is always a motor, also for opposite rotations; its coefficients are
    /// finite where all numbers are and `log(~M N)` is within the range of the scalar, otherwise
    /// some are NaN.
    ///
    /// ```
    /// use ga_runtime::cga2::{Motor, Point, Rotor, Translator};
    /// let half_turn = Rotor::from_angle(std::f64::consts::PI).unwrap();
    /// let end = Motor::about(Point::new(1.0, 0.0), half_turn);
    /// let middle = Motor::default().interpolate(end, 0.5).transform(Point::new(0.0, 0.0));
    /// assert!(middle.distance(Point::new(1.0, -1.0)) < 1e-15);
    /// // Two translations are interpolated along a straight line.
    /// let translation = |t| Motor::from(Translator::from_displacement(t));
    /// let (a, b) = (translation([0.0, 2.0]), translation([4.0, 2.0]));
    /// assert_eq!(a.interpolate(b, 0.25).translator().displacement(), [1.0, 2.0]);
    /// ```
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        let mut between = self.reverse() * other;
        if between.scalar().less_than(S::zero()) {
            between = -between;
        }
        // As the scalar part is not negative, the logarithm exists but for its range.
        let nan = S::zero() / S::zero();
        match between.powf(t) {
            Some(part) => self * part,
            None => Self::new_unchecked(nan, nan, nan, nan),
        }
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The interpolation from `self` at t = 0 to `other` at t = 1 at constant angular velocity, by
    /// the shorter rotation: `R exp(t log(~R R'))`. t may be outside [0, 1]. There is always a
    /// rotor, also for opposite rotations; NaN stays NaN.
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        let mut between = self.reverse() * other;
        if between.scalar().less_than(S::zero()) {
            between = -between;
        }
        let (sine, cosine) = (between.e12().atan2(between.scalar()) * t).sin_cos();
        self * Self::new_unchecked(cosine, sine)
    }
}

impl<S: Real<Mask = bool>> MotorGenerator<S> {
    /// The motor `exp(G)`: for `−½θ e12` a rotation by θ about the origin, for `−½ t ei` a
    /// translation by t, for a dual point a rotation about that point. NaN stays NaN.
    #[must_use]
    pub fn exp(self) -> Motor<S> {
        let (sine, cosine) = self.e12.sin_cos();
        let ratio = if self.e12 == S::zero() {
            S::one()
        } else {
            sine / self.e12
        };
        Motor::new_unchecked(cosine, sine, self.e1i * ratio, self.e2i * ratio)
    }
}
