//! Directions: free vectors and free bivectors.

use crate::cga3::{Direction, DualDirection};
use crate::scalar::{Maybe, Optional, Real, Ring};
use crate::vga3::Vector;

impl<S: Ring> Direction<S> {
    /// The free vector v as `v∧ei`.
    ///
    /// ```
    /// use ga_runtime::cga3::Direction;
    /// let v = Direction::from_vector([0.0, 3.0, 4.0]);
    /// assert_eq!((v, v.vector()), (Direction::from([0.0, 3.0, 4.0]), [0.0, 3.0, 4.0]));
    /// assert_eq!((v.x(), v.y(), v.z(), v.length()), (0.0, 3.0, 4.0, 5.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_vector([x, y, z]: [S; 3]) -> Self {
        Self::new(x, y, z)
    }

    /// The free vector v of `v∧ei`.
    #[inline]
    #[must_use]
    pub fn vector(self) -> [S; 3] {
        [self.e1i, self.e2i, self.e3i]
    }

    /// The components `[x, y, z]`; the same as [`vector`](Self::vector).
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 3] {
        self.vector()
    }

    /// The component along the x axis.
    #[inline]
    #[must_use]
    pub fn x(self) -> S {
        self.e1i
    }

    /// The component along the y axis.
    #[inline]
    #[must_use]
    pub fn y(self) -> S {
        self.e2i
    }

    /// The component along the z axis.
    #[inline]
    #[must_use]
    pub fn z(self) -> S {
        self.e3i
    }

    /// The inner product `u·v` of the free vectors. (That of the blades `u∧ei` and `v∧ei` is zero.)
    ///
    /// ```
    /// use ga_runtime::cga3::Direction;
    /// assert_eq!(Direction::new(1, 2, 3).dot(Direction::new(4, 5, 6)), 32);
    /// ```
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> S {
        Vector::from(self).dot(other.into())
    }

    /// The cross product `u × v` of the free vectors, right-handed.
    ///
    /// ```
    /// use ga_runtime::cga3::Direction;
    /// let (u, v) = (Direction::new(1, 2, 3), Direction::new(4, 5, 6));
    /// assert_eq!(u.cross(v), Direction::new(-3, 6, -3));
    /// ```
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Vector::from(self).cross(other.into()).into()
    }

    /// The squared length `v·v`. It overflows or underflows where the square of a component does.
    #[inline]
    #[must_use]
    pub fn length_squared(self) -> S {
        self.dot(self)
    }

    /// The linear interpolation `(1 − t) u + t v`: exactly `self` at t = 0 and `other` at t = 1.
    #[inline]
    #[must_use]
    pub fn lerp(self, other: Self, t: S) -> Self {
        Vector::from(self).lerp(other.into(), t).into()
    }
}

impl<S: Real> Direction<S> {
    /// The length |v| of the free vector, without intermediate overflow or underflow; NaN where a
    /// component is NaN. It is not the square root of [`norm_squared`](Self::norm_squared), which
    /// is that of the blade `v∧ei` and always zero.
    #[inline]
    #[must_use]
    pub fn length(self) -> S {
        Vector::from(self).length()
    }

    /// The Euclidean norm of the free vector, its [`length`](Self::length). It is not the square
    /// root of [`norm_squared`](Self::norm_squared), which is that of the blade `v∧ei` and always
    /// zero.
    #[inline]
    #[must_use]
    pub fn norm(self) -> S {
        self.length()
    }
}

impl<S: Real> Direction<S> {
    /// The direction of length 1 that points the same way; `None` where it is zero or not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::Direction;
    /// let v = Direction::new(0.0, 3.0, 4.0);
    /// assert_eq!(v.normalized(), Some(Direction::new(0.0, 0.6, 0.8)));
    /// assert_eq!(Direction::<f64>::default().normalized(), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn normalized(self) -> Maybe<Self, S> {
        Vector::from(self).normalized().map(Self::from)
    }

    /// The angle to another direction in radians, in [0, π]; `None` where one is zero or not
    /// finite. It is computed from sine and cosine, so that small angles are accurate to rounding.
    #[must_use]
    pub fn angle(self, other: Self) -> Maybe<S, S> {
        Vector::from(self).angle(other.into())
    }
}

impl<S> From<[S; 3]> for Direction<S> {
    #[inline]
    fn from([x, y, z]: [S; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<S> From<Direction<S>> for [S; 3] {
    #[inline]
    fn from(Direction { e1i, e2i, e3i }: Direction<S>) -> Self {
        [e1i, e2i, e3i]
    }
}

impl<S: Ring> DualDirection<S> {
    /// The free bivector `B∧ei` perpendicular to a normal n: `B = n1 e23 − n2 e13 + n3 e12`, so
    /// that B is counterclockwise as seen from the tip of n.
    ///
    /// ```
    /// use ga_runtime::cga3::{Direction, DualDirection};
    /// let attitude = DualDirection::from_normal([1.0, 2.0, 3.0]);
    /// assert_eq!(attitude.normal(), [1.0, 2.0, 3.0]);
    /// assert_eq!(attitude.undual(), Direction::from_vector([-1.0, -2.0, -3.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_normal([x, y, z]: [S; 3]) -> Self {
        Self::new(z, -y, x)
    }

    /// The normal n of `B∧ei`. Its length is the weight.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 3] {
        [self.e23i, -self.e13i, self.e12i]
    }
}
