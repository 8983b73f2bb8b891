//! Points of pga3, finite and ideal.

use crate::geometry::number::are_numbers;
use crate::pga3::{Direction, Point};
use crate::scalar::{ConstRing, Real, Ring};
use crate::vga3::Vector;

impl<S: ConstRing> Point<S> {
    /// The origin, with weight 1.
    pub const ORIGIN: Self = Self::new(S::ONE, S::ZERO, S::ZERO, S::ZERO);
}

impl<S: Ring> Point<S> {
    /// The point (x, y, z) with weight 1: `e123 − x e230 + y e130 − z e120`.
    ///
    /// ```
    /// use ga_runtime::pga3::{Plane, Point};
    /// let planes = [
    ///     ([1.0, 0.0, 0.0], 1.0),
    ///     ([0.0, 1.0, 0.0], 2.0),
    ///     ([0.0, 0.0, 1.0], 3.0),
    /// ];
    /// let [x, y, z] =
    ///     planes.map(|(normal, distance)| Plane::from_normal_distance(normal, distance));
    /// assert_eq!(x ^ y ^ z, Point::from_coordinates([1.0, 2.0, 3.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_coordinates(coordinates: [S; 3]) -> Self {
        Self::from_homogeneous(coordinates, S::one())
    }

    /// The point (x, y, z)/w with weight w; for w = 0 the ideal point in that direction.
    #[inline]
    #[must_use]
    pub fn from_homogeneous([x, y, z]: [S; 3], weight: S) -> Self {
        Self::new(weight, -z, y, -x)
    }

    /// The coordinates times the weight.
    #[inline]
    #[must_use]
    pub fn homogeneous(self) -> [S; 3] {
        [-self.e230, self.e130, -self.e120]
    }

    /// The weight, the coefficient of e123.
    #[inline]
    #[must_use]
    pub fn weight(self) -> S {
        self.e123
    }
}

impl<S: Real<Mask = bool>> Point<S> {
    /// The coordinates `[x, y, z]`; `None` for an ideal point, or beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::pga3::{Direction, Point};
    /// assert_eq!(
    ///     Point::from_homogeneous([2.0, 4.0, 6.0], 2.0).coordinates(),
    ///     Some([1.0, 2.0, 3.0])
    /// );
    /// assert_eq!(
    ///     Point::from(Direction::from_vector([2.0, 4.0, 6.0])).coordinates(),
    ///     None
    /// );
    /// ```
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> Option<[S; 3]> {
        let place = self.homogeneous().map(|x| x / self.weight());
        are_numbers(place).then_some(place)
    }

    /// The direction from this point to another, `q − p`: the difference of the points with weight
    /// 1. `None` where one is ideal, or beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::pga3::{Direction, Point};
    /// let p = Point::from([1.0, 2.0, 3.0]);
    /// let q = Point::from_homogeneous([10.0, 10.0, 10.0], 2.0);
    /// let way = p.to(q).unwrap();
    /// assert_eq!(way, Direction::from([4.0, 3.0, 2.0]));
    /// assert_eq!((p + Point::from(way)).coordinates(), Some([5.0, 5.0, 5.0]));
    /// ```
    #[must_use]
    pub fn to(self, other: Self) -> Option<Direction<S>> {
        let [p, q] = [self.coordinates()?, other.coordinates()?].map(Vector::from);
        let way = (q - p).coordinates();
        are_numbers(way).then(|| Direction::from_vector(way))
    }

    /// The point midway between two points, with weight 1; `None` where one is ideal, or beyond the
    /// range of the scalar.
    #[must_use]
    pub fn midpoint(self, other: Self) -> Option<Self> {
        let [p, q] = [self.coordinates()?, other.coordinates()?].map(Vector::from);
        let middle = p.lerp(q, S::from_ratio(1, 2)).coordinates();
        are_numbers(middle).then(|| Self::from_coordinates(middle))
    }

    /// The distance between two points, `|P ∨ Q|` for weights 1; `None` where one is ideal, or
    /// beyond the range of the scalar.
    #[must_use]
    pub fn distance(self, other: Self) -> Option<S> {
        let [p, q] = [self.coordinates()?, other.coordinates()?].map(Vector::from);
        let distance = p.distance(q);
        distance.is_finite().then_some(distance)
    }
}

impl<S: Ring> From<[S; 3]> for Point<S> {
    #[inline]
    fn from(coordinates: [S; 3]) -> Self {
        Self::from_coordinates(coordinates)
    }
}

impl<S: Ring> Direction<S> {
    /// The free vector v as the ideal point `−v1 e230 + v2 e130 − v3 e120`.
    #[inline]
    #[must_use]
    pub fn from_vector([x, y, z]: [S; 3]) -> Self {
        Self::new(-z, y, -x)
    }

    /// The free vector v.
    #[inline]
    #[must_use]
    pub fn vector(self) -> [S; 3] {
        [-self.e230, self.e130, -self.e120]
    }
    /// The inner product `u·v` of the free vectors.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> S {
        Vector::from(self.vector()).dot(other.vector().into())
    }

    /// The cross product `u × v` of the free vectors, right-handed.
    ///
    /// ```
    /// use ga_runtime::pga3::Direction;
    /// let (u, v) = (Direction::from([1, 2, 3]), Direction::from([4, 5, 6]));
    /// assert_eq!((u.cross(v).vector(), u.dot(v)), ([-3, 6, -3], 32));
    /// ```
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        let cross = Vector::from(self.vector()).cross(other.vector().into());
        Self::from_vector(cross.coordinates())
    }
}

impl<S: Real<Mask = bool>> Direction<S> {
    /// The length |v| of the free vector, without intermediate overflow or underflow. The norm of
    /// the ideal point is zero.
    #[inline]
    #[must_use]
    pub fn length(self) -> S {
        Vector::from(self.vector()).length()
    }

    /// The direction of length 1 that points the same way; `None` where it is zero or not finite.
    #[inline]
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        let unit = Vector::from(self.vector()).normalized()?;
        Some(Self::from_vector(unit.coordinates()))
    }
}

impl<S: Ring> From<[S; 3]> for Direction<S> {
    #[inline]
    fn from(vector: [S; 3]) -> Self {
        Self::from_vector(vector)
    }
}

impl<S: Ring> From<Direction<S>> for [S; 3] {
    #[inline]
    fn from(direction: Direction<S>) -> Self {
        direction.vector()
    }
}
