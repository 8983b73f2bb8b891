//! Translators.

use super::vector3::scaled;
use crate::cga3::Translator;
use crate::scalar::Field;

impl<S: Field> Translator<S> {
    /// The shift by t: `T = 1 − ½ t ei` (the paper's eq. 26, corrected).
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Translator};
    /// let shift = Translator::from_displacement([1.0, 2.0, 3.0]);
    /// assert_eq!(shift.transform(Point::new(1.0, 0.0, 0.0)), Point::new(2.0, 2.0, 3.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_displacement(displacement: [S; 3]) -> Self {
        let [x, y, z] = scaled(displacement, S::from_ratio(-1, 2));
        Self::new(x, y, z)
    }

    /// The displacement t.
    #[inline]
    #[must_use]
    pub fn displacement(self) -> [S; 3] {
        scaled([self.e1i(), self.e2i(), self.e3i()], S::from_integer(-2))
    }
}
