//! Vectors of vga3: products, lengths, angles and projections.

use crate::cga3;
use crate::geometry::number::is_regular;
use crate::scalar::{Mask, Maybe, Optional, Real, Ring};
use crate::vga3::Vector;

impl<S: Ring> Vector<S> {
    /// The inner product `a · b`, the sum of the products of the components.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// assert_eq!(Vector::new(1, 2, 3).dot(Vector::new(4, 5, 6)), 32);
    /// ```
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> S {
        self.e1 * other.e1 + self.e2 * other.e2 + self.e3 * other.e3
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
        Self::new(
            self.e2 * other.e3 - self.e3 * other.e2,
            self.e3 * other.e1 - self.e1 * other.e3,
            self.e1 * other.e2 - self.e2 * other.e1,
        )
    }

    /// The component perpendicular to a vector of length 1, `a − (a·u) u`.
    #[inline]
    pub(crate) fn across(self, unit: Self) -> Self {
        self - unit * self.dot(unit)
    }

    /// The squared length `a · a`. It overflows or underflows where the square of a component does.
    #[inline]
    #[must_use]
    pub fn length_squared(self) -> S {
        self.dot(self)
    }

    /// The linear interpolation `(1 − t) a + t b`: exactly `self` at t = 0 and `other` at t = 1.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let (a, b) = (Vector::new(1.0, 0.0, 2.0), Vector::new(3.0, 4.0, 2.0));
    /// assert_eq!(a.lerp(b, 0.25), Vector::new(1.5, 1.0, 2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn lerp(self, other: Self, t: S) -> Self {
        self * (S::one() - t) + other * t
    }
}

impl<S: Real> Vector<S> {
    /// The length `√(a · a)`, without intermediate overflow or underflow; NaN where a component is
    /// NaN.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// assert_eq!(Vector::new(2.0, 3.0, 6.0).length(), 7.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn length(self) -> S {
        let square = self.dot(self);
        let is_regular = is_regular(square);
        if is_regular.all() {
            return square.sqrt();
        }
        S::select(is_regular, square.sqrt(), length_of_any(self.coordinates()))
    }

    /// The distance between the points with these position vectors, `|a − b|`.
    #[inline]
    #[must_use]
    pub fn distance(self, other: Self) -> S {
        (self - other).length()
    }

    /// Each component divided by a number. (The operator `/` multiplies by the reciprocal, which is
    /// infinite for a subnormal number.)
    #[inline]
    pub(crate) fn divided(self, scalar: S) -> Self {
        Self::new(self.e1 / scalar, self.e2 / scalar, self.e3 / scalar)
    }

    #[inline]
    fn largest_component(self) -> S {
        self.e1.abs().max(self.e2.abs()).max(self.e3.abs())
    }
}

impl<S: Real> Vector<S> {
    /// The angle to another vector, in [0, π]; `None` where one is zero or not finite.
    ///
    /// It is computed from sine and cosine, so that small angles are accurate to rounding.
    #[must_use]
    pub fn angle(self, other: Self) -> Maybe<S, S> {
        let both = self.normalized().zip(other.normalized());
        both.map(|(a, b)| a.cross(b).length().atan2(a.dot(b)))
    }

    /// The component along another vector, the projection `(a·b) b⁻¹`; `None` where b is zero or a
    /// number is not finite.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let (a, b) = (Vector::new(3.0, 4.0, 5.0), Vector::new(0.0, 2.0, 0.0));
    /// assert_eq!(a.project(b), Some(Vector::new(0.0, 4.0, 0.0)));
    /// assert_eq!(a.reject(b), Some(Vector::new(3.0, 0.0, 5.0)));
    /// ```
    #[must_use]
    pub fn project(self, other: Self) -> Maybe<Self, S> {
        let part = other.normalized().map(|unit| unit * self.dot(unit));
        part.filter(|part| part.is_finite())
    }

    /// The component perpendicular to another vector, the rejection `(a∧b) b⁻¹`; `None` where b is
    /// zero or a number is not finite.
    #[must_use]
    pub fn reject(self, other: Self) -> Maybe<Self, S> {
        let part = self.project(other).map(|along| self - along);
        part.filter(|part| part.is_finite())
    }

    /// The mirror image in the plane perpendicular to a normal n, `−n a n⁻¹`; `None` where n is
    /// zero or a number is not finite.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// let image = Vector::new(1.0, 2.0, 3.0).reflect(Vector::new(0.0, 0.0, 5.0));
    /// assert_eq!(image, Some(Vector::new(1.0, 2.0, -3.0)));
    /// ```
    #[must_use]
    pub fn reflect(self, normal: Self) -> Maybe<Self, S> {
        let image = self.project(normal).map(|along| self - along - along);
        image.filter(|image| image.is_finite())
    }
}

// Outlined code takes and returns arrays made for it, so that the vectors of its callers stay in
// registers.

/// The length, from components divided by the largest.
#[cold]
#[inline(never)]
fn length_of_any<S: Real>(components: [S; 3]) -> S {
    let vector = Vector::from(components);
    let largest = vector.largest_component();
    let is_regular = S::zero().less_than(largest) & largest.is_finite();
    // Zero, infinity and NaN are not scaled.
    let size = S::select(is_regular, largest, S::one());
    let unit = vector.divided(size);
    unit.dot(unit).sqrt() * size
}

/// The position vector of the point.
impl<S: Ring> From<cga3::Point<S>> for Vector<S> {
    #[inline]
    fn from(point: cga3::Point<S>) -> Self {
        Self::new(point.e1(), point.e2(), point.e3())
    }
}

/// The point with this position vector.
impl<S> From<Vector<S>> for cga3::Point<S> {
    #[inline]
    fn from(Vector { e1, e2, e3 }: Vector<S>) -> Self {
        Self::new(e1, e2, e3)
    }
}

/// The vector v of `v∧ei`.
impl<S> From<cga3::Direction<S>> for Vector<S> {
    #[inline]
    fn from(direction: cga3::Direction<S>) -> Self {
        Self::new(direction.e1i, direction.e2i, direction.e3i)
    }
}

/// The direction `v∧ei`.
impl<S> From<Vector<S>> for cga3::Direction<S> {
    #[inline]
    fn from(Vector { e1, e2, e3 }: Vector<S>) -> Self {
        Self::new(e1, e2, e3)
    }
}
