//! Vectors of vga3.

use crate::geometry::vector3::{are_numbers, cross, difference, dot, length, normalized, scaled};
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

impl<S: Ring> Vector<S> {
    /// The coordinates `[x, y, z]`.
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 3] {
        [self.e1, self.e2, self.e3]
    }

    /// The cross product, right-handed: the dual of the outer product,
    /// `a × b = dual(a ∧ b) = −(a ∧ b) I`.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let (a, b) = (Vector::new(1, 2, 3), Vector::new(4, 5, 6));
    /// assert_eq!(a.cross(b), Vector::new(-3, 6, -3));
    /// ```
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        cross(self.coordinates(), other.coordinates()).into()
    }
}

impl<S: Real<Mask = bool>> Vector<S> {
    /// The length, without overflow or underflow on the way.
    #[inline]
    #[must_use]
    pub fn length(self) -> S {
        length(self.coordinates())
    }

    /// The vector of length 1 in the same direction; `None` where it is zero or not finite.
    #[inline]
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        normalized(self.coordinates()).map(Self::from)
    }

    /// The angle to another vector, in [0, π]; `None` where one is zero or not finite.
    ///
    /// From sine and cosine, so that small angles are right to rounding.
    #[must_use]
    pub fn angle(self, other: Self) -> Option<S> {
        let (a, b) = (
            normalized(self.coordinates())?,
            normalized(other.coordinates())?,
        );
        Some(length(cross(a, b)).atan2(dot(a, b)))
    }

    /// The part along another vector, its projection `(a·b) b⁻¹`; `None` where b is zero or a
    /// number is not finite.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let (a, b) = (Vector::new(3.0, 4.0, 5.0), Vector::new(0.0, 2.0, 0.0));
    /// assert_eq!(a.project(b), Some(Vector::new(0.0, 4.0, 0.0)));
    /// assert_eq!(a.reject(b), Some(Vector::new(3.0, 0.0, 5.0)));
    /// ```
    #[must_use]
    pub fn project(self, other: Self) -> Option<Self> {
        let direction = normalized(other.coordinates())?;
        let part = scaled(direction, dot(self.coordinates(), direction));
        are_numbers(part).then(|| part.into())
    }

    /// The part across another vector, its rejection `(a∧b) b⁻¹`; `None` where b is zero or a
    /// number is not finite.
    #[must_use]
    pub fn reject(self, other: Self) -> Option<Self> {
        let part = difference(self.coordinates(), self.project(other)?.coordinates());
        are_numbers(part).then(|| part.into())
    }

    /// The mirror image in the plane across a normal n, `−n a n⁻¹`; `None` where n is zero or a
    /// number is not finite.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let image = Vector::new(1.0, 2.0, 3.0).reflect(Vector::new(0.0, 0.0, 5.0));
    /// assert_eq!(image, Some(Vector::new(1.0, 2.0, -3.0)));
    /// ```
    #[must_use]
    pub fn reflect(self, normal: Self) -> Option<Self> {
        let along = self.project(normal)?.coordinates();
        let image = difference(difference(self.coordinates(), along), along);
        are_numbers(image).then(|| image.into())
    }
}

impl<S> From<[S; 3]> for Vector<S> {
    #[inline]
    fn from([x, y, z]: [S; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<S> From<Vector<S>> for [S; 3] {
    #[inline]
    fn from(Vector { e1, e2, e3 }: Vector<S>) -> Self {
        [e1, e2, e3]
    }
}
