//! Translators.

use crate::cga3::{MotorGenerator, Translator};
use crate::scalar::Field;

impl<S: Field> Translator<S> {
    /// The translation by t: `T = 1 − ½ t ei` (Cui, eq. 26, corrected).
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Translator};
    /// let translation = Translator::from_displacement([1.0, 2.0, 3.0]);
    /// assert_eq!(translation.transform(Point::new(1.0, 0.0, 0.0)), Point::new(2.0, 2.0, 3.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_displacement(displacement: [S; 3]) -> Self {
        let [x, y, z] = displacement.map(|x| x * S::from_ratio(-1, 2));
        Self::new(x, y, z)
    }

    /// The displacement t.
    #[inline]
    #[must_use]
    pub fn displacement(self) -> [S; 3] {
        [self.e1i(), self.e2i(), self.e3i()].map(|x| x * S::from_integer(-2))
    }

    /// The generator `−½ t ei`, whose [`exp`](MotorGenerator::exp) is this translation.
    ///
    /// ```
    /// use ga_runtime::cga3::Translator;
    /// let translation = Translator::from_displacement([1.0, 2.0, 3.0]);
    /// assert_eq!(translation.log().exp(), translation.into());
    /// ```
    #[inline]
    #[must_use]
    pub fn log(self) -> MotorGenerator<S> {
        let zero = S::zero();
        MotorGenerator::new(zero, zero, zero, self.e1i(), self.e2i(), self.e3i())
    }

    /// The translation by s times the displacement, `1 − ½ s t ei`.
    #[inline]
    #[must_use]
    pub fn powf(self, exponent: S) -> Self {
        let [x, y, z] = [self.e1i(), self.e2i(), self.e3i()].map(|x| x * exponent);
        Self::new(x, y, z)
    }

    /// The translation by half the displacement.
    #[inline]
    #[must_use]
    pub fn sqrt(self) -> Self {
        self.powf(S::from_ratio(1, 2))
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1, along a straight line at
    /// constant speed.
    ///
    /// ```
    /// use ga_runtime::cga3::Translator;
    /// let [a, b] = [[0.0, 0.0, 1.0], [4.0, 0.0, 1.0]].map(Translator::from_displacement);
    /// assert_eq!(a.interpolate(b, 0.25).displacement(), [1.0, 0.0, 1.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        self * (self.reverse() * other).powf(t)
    }
}
