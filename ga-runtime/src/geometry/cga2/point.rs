//! Points, flat points and directions of cga2.

use core::ops::{Add, AddAssign, Sub, SubAssign};

use crate::cga2::{Direction, FlatPoint, Point};
use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{area, difference, dot, length, normalized, scaled};
use crate::scalar::{ConstRing, Field, Mask, Maybe, Real, Ring};

impl<S: ConstRing> Point<S> {
    /// The origin.
    pub const ORIGIN: Self = Self::new(S::ZERO, S::ZERO);
}

impl<S: Ring> Point<S> {
    /// The coordinates `[x, y]`.
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 2] {
        [self.e1(), self.e2()]
    }

    /// The coordinate along the x axis.
    #[inline]
    #[must_use]
    pub fn x(self) -> S {
        self.e1()
    }

    /// The coordinate along the y axis.
    #[inline]
    #[must_use]
    pub fn y(self) -> S {
        self.e2()
    }

    /// The direction from this point to another, the free vector `q − p` as `(q − p)∧ei`. Added to
    /// this point, it gives the other. The operator `q - p` is the difference of two conformal
    /// vectors instead.
    ///
    /// ```
    /// use ga_runtime::cga2::{Direction, Point};
    /// let (p, q) = (Point::new(1.0, 2.0), Point::new(5.0, 5.0));
    /// assert_eq!(p.to(q), Direction::new(4.0, 3.0));
    /// assert_eq!((p + p.to(q), q - p.to(q)), (q, p));
    /// assert_eq!(p.to(q).length(), 5.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn to(self, other: Self) -> Direction<S> {
        Direction::from_vector(difference(other.coordinates(), self.coordinates()))
    }

    /// The point `(1 − t) p + t q` of the line through two points: exactly p at t = 0 and q at
    /// t = 1, beyond them for other t outside [0, 1].
    #[inline]
    #[must_use]
    pub fn lerp(self, other: Self, t: S) -> Self {
        let [a, b] = scaled(self.coordinates(), S::one() - t);
        let [c, d] = scaled(other.coordinates(), t);
        Self::new(a + c, b + d)
    }

    /// The squared distance between two points, `−2 P·Q`, computed from differences of coordinates.
    #[inline]
    #[must_use]
    pub fn distance_squared(self, other: Self) -> S {
        let between = difference(self.coordinates(), other.coordinates());
        dot(between, between)
    }
}

impl<S: Real<Mask = bool>> Point<S> {
    /// The distance between two points, `√(−2 P·Q)`.
    ///
    /// ```
    /// use ga_runtime::cga2::Point;
    /// assert_eq!(Point::new(1.0, 1.0).distance(Point::new(1.0, 6.0)), 5.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn distance(self, other: Self) -> S {
        length(difference(self.coordinates(), other.coordinates()))
    }
}

impl<S: Field> Point<S> {
    /// The point midway between two points.
    ///
    /// ```
    /// use ga_runtime::cga2::Point;
    /// assert_eq!(Point::new(1.0, 2.0).midpoint(Point::new(5.0, 3.0)), Point::new(3.0, 2.5));
    /// ```
    #[inline]
    #[must_use]
    pub fn midpoint(self, other: Self) -> Self {
        self.lerp(other, S::from_ratio(1, 2))
    }
}

impl<S> From<[S; 2]> for Point<S> {
    #[inline]
    fn from([x, y]: [S; 2]) -> Self {
        Self::new(x, y)
    }
}

impl<S: Ring> From<Point<S>> for [S; 2] {
    #[inline]
    fn from(point: Point<S>) -> Self {
        point.coordinates()
    }
}

/// The point displaced by a free vector v, `x + v`: the translation of the point.
impl<S: Ring> Add<Direction<S>> for Point<S> {
    type Output = Self;

    #[inline]
    fn add(self, displacement: Direction<S>) -> Self {
        Self::new(self.e1() + displacement.e1i, self.e2() + displacement.e2i)
    }
}

/// The point displaced by minus a free vector v, `x − v`.
impl<S: Ring> Sub<Direction<S>> for Point<S> {
    type Output = Self;

    #[inline]
    fn sub(self, displacement: Direction<S>) -> Self {
        Self::new(self.e1() - displacement.e1i, self.e2() - displacement.e2i)
    }
}

impl<S: Ring> AddAssign<Direction<S>> for Point<S> {
    #[inline]
    fn add_assign(&mut self, displacement: Direction<S>) {
        *self = *self + displacement;
    }
}

impl<S: Ring> SubAssign<Direction<S>> for Point<S> {
    #[inline]
    fn sub_assign(&mut self, displacement: Direction<S>) {
        *self = *self - displacement;
    }
}

impl<S: Real> FlatPoint<S> {
    /// The point p of `p∧ei`; `None` for a direction, which is the meet of parallel lines, or
    /// beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga2::{Line, Point};
    /// let (a, b) = (
    ///     Line::from_point_direction(Point::new(1.0, 0.0), [0.0, 1.0]),
    ///     Line::from_point_direction(Point::new(0.0, 2.0), [1.0, 0.0]),
    /// );
    /// assert_eq!((a & b).to_point(), Some(Point::new(1.0, 2.0)));
    /// assert_eq!((a & a).to_point(), None);
    /// ```
    #[must_use]
    pub fn to_point(self) -> Maybe<Point<S>, S> {
        let place = [self.e1i / self.eoi, self.e2i / self.eoi];
        (!self.eoi.equals(S::zero()) & are_numbers(place)).when(Point::from(place))
    }
}

impl<S: Ring> Direction<S> {
    /// The free vector v as `v∧ei`.
    #[inline]
    #[must_use]
    pub fn from_vector([x, y]: [S; 2]) -> Self {
        Self::new(x, y)
    }

    /// The free vector v of `v∧ei`.
    #[inline]
    #[must_use]
    pub fn vector(self) -> [S; 2] {
        [self.e1i, self.e2i]
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

    /// The inner product `u·v` of the free vectors.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> S {
        dot(self.vector(), other.vector())
    }

    /// The oriented area `u₁v₂ − u₂v₁` of the parallelogram of two free vectors, the third
    /// component of their cross product: positive where the rotation from u to v is
    /// counterclockwise.
    ///
    /// ```
    /// use ga_runtime::cga2::Direction;
    /// assert_eq!(Direction::new(2, 0).cross(Direction::new(5, 3)), 6);
    /// ```
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> S {
        area(self.vector(), other.vector())
    }
}

impl<S: Real<Mask = bool>> Direction<S> {
    /// The length |v| of the free vector, without intermediate overflow or underflow.
    #[inline]
    #[must_use]
    pub fn length(self) -> S {
        length(self.vector())
    }

    /// The Euclidean norm of the free vector, its [`length`](Self::length). It is not the square
    /// root of [`norm_squared`](Self::norm_squared), which is that of the blade `v∧ei` and always
    /// zero.
    #[inline]
    #[must_use]
    pub fn norm(self) -> S {
        self.length()
    }

    /// The direction of length 1 that points the same way; `None` where it is zero or not finite.
    #[inline]
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        normalized(self.vector()).map(Self::from_vector)
    }
}

impl<S> From<[S; 2]> for Direction<S> {
    #[inline]
    fn from([x, y]: [S; 2]) -> Self {
        Self::new(x, y)
    }
}

impl<S> From<Direction<S>> for [S; 2] {
    #[inline]
    fn from(Direction { e1i, e2i }: Direction<S>) -> Self {
        [e1i, e2i]
    }
}
