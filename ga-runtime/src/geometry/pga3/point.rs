//! Points of pga3, finite and ideal.

use crate::geometry::number::are_numbers;
use crate::pga3::{Direction, Point};
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

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
}
