//! Vectors of vga2.

use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{area, difference, dot, length, normalized, scaled};
use crate::scalar::{Real, Ring};
use crate::vga2::{Complex, Vector};

impl<S: Ring> Vector<S> {
    /// The coordinates `[x, y]`.
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 2] {
        [self.e1, self.e2]
    }

    /// The complex number `x + y e12 = e1 v`, which fixes e1 as the real axis.
    #[inline]
    #[must_use]
    pub fn to_complex(self) -> Complex<S> {
        Complex::new(self.e1, self.e2)
    }
}

impl<S: Real<Mask = bool>> Vector<S> {
    /// The length, without intermediate overflow or underflow.
    #[inline]
    #[must_use]
    pub fn length(self) -> S {
        length(self.coordinates())
    }

    /// The angle of the rotation to another vector, in (−π, π], positive from e1 towards e2; `None`
    /// where one is zero or not finite.
    ///
    /// ```
    /// use ga_runtime::vga2::Vector;
    /// let (a, b) = (Vector::new(0.0, 2.0), Vector::new(3.0, 0.0));
    /// assert_eq!(a.angle(b), Some(-std::f64::consts::FRAC_PI_2));
    /// ```
    #[must_use]
    pub fn angle(self, other: Self) -> Option<S> {
        let (a, b) = (
            normalized(self.coordinates())?,
            normalized(other.coordinates())?,
        );
        Some(area(a, b).atan2(dot(a, b)))
    }

    /// The component along another vector, `(a·b) b⁻¹`; `None` where b is zero or a number is not
    /// finite.
    #[must_use]
    pub fn project(self, other: Self) -> Option<Self> {
        let direction = normalized(other.coordinates())?;
        let part = scaled(direction, dot(self.coordinates(), direction));
        are_numbers(part).then(|| part.into())
    }

    /// The component perpendicular to another vector, `(a∧b) b⁻¹`; `None` where b is zero or a
    /// number is not finite.
    #[must_use]
    pub fn reject(self, other: Self) -> Option<Self> {
        let part = difference(self.coordinates(), self.project(other)?.coordinates());
        are_numbers(part).then(|| part.into())
    }

    /// The mirror image in the line perpendicular to a normal n, `−n a n⁻¹`; `None` where n is zero
    /// or a number is not finite.
    ///
    /// ```
    /// use ga_runtime::vga2::Vector;
    /// assert_eq!(
    ///     Vector::new(1.0, 2.0).reflect(Vector::new(0.0, 3.0)),
    ///     Some(Vector::new(1.0, -2.0))
    /// );
    /// ```
    #[must_use]
    pub fn reflect(self, normal: Self) -> Option<Self> {
        let along = self.project(normal)?.coordinates();
        let image = difference(difference(self.coordinates(), along), along);
        are_numbers(image).then(|| image.into())
    }
}

impl<S> From<[S; 2]> for Vector<S> {
    #[inline]
    fn from([x, y]: [S; 2]) -> Self {
        Self::new(x, y)
    }
}

impl<S> From<Vector<S>> for [S; 2] {
    #[inline]
    fn from(Vector { e1, e2 }: Vector<S>) -> Self {
        [e1, e2]
    }
}
