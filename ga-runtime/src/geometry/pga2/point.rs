//! Points of pga2, finite and ideal.

use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{difference, length};
use crate::pga2::{Motor, Point};
use crate::scalar::{ConstRing, Real, Ring};

impl<S: ConstRing> Point<S> {
    /// The origin, with weight 1.
    pub const ORIGIN: Self = Self::new(S::ONE, S::ZERO, S::ZERO);
}

impl<S: Ring> Point<S> {
    /// The point (x, y) with weight 1: `e12 + x e20 + y e01`.
    #[inline]
    #[must_use]
    pub fn from_coordinates(coordinates: [S; 2]) -> Self {
        Self::from_homogeneous(coordinates, S::one())
    }

    /// The point (x, y)/w with weight w; for w = 0 the ideal point in that direction.
    #[inline]
    #[must_use]
    pub fn from_homogeneous([x, y]: [S; 2], weight: S) -> Self {
        Self::new(weight, x, y)
    }

    /// The coordinates times the weight.
    #[inline]
    #[must_use]
    pub fn homogeneous(self) -> [S; 2] {
        [self.e20, self.e01]
    }

    /// The weight, the coefficient of e12.
    #[inline]
    #[must_use]
    pub fn weight(self) -> S {
        self.e12
    }
}

impl<S: Real<Mask = bool>> Point<S> {
    /// The coordinates `[x, y]`; `None` for an ideal point, or beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::pga2::Point;
    /// assert_eq!(Point::from_homogeneous([2.0, 4.0], 2.0).coordinates(), Some([1.0, 2.0]));
    /// assert_eq!(Point::from_homogeneous([2.0, 4.0], 0.0).coordinates(), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> Option<[S; 2]> {
        let place = self.homogeneous().map(|x| x / self.weight());
        are_numbers(place).then_some(place)
    }

    /// The distance between two points; `None` where one is ideal, or beyond the range of the
    /// scalar.
    #[must_use]
    pub fn distance(self, other: Self) -> Option<S> {
        let distance = length(difference(self.coordinates()?, other.coordinates()?));
        distance.is_finite().then_some(distance)
    }

    /// The motor `exp(B)` of any bivector: `−½θP` rotates by θ about the point P of weight 1,
    /// counterclockwise; `½ t∧e0`, an ideal point, translates by t. NaN stays NaN.
    ///
    /// A point B squares to minus its squared weight w², so that `exp(B) = cos w + (sin w / w) B`.
    ///
    /// ```
    /// use ga_runtime::pga2::Point;
    /// let quarter = (Point::from([1.0, 0.0]) * (-0.25 * std::f64::consts::PI)).exp();
    /// let [x, y] = quarter.transform(Point::from([2.0, 0.0])).coordinates().unwrap();
    /// assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn exp(self) -> Motor<S> {
        let (sine, cosine) = self.e12.sin_cos();
        let ratio = if self.e12 == S::zero() {
            S::one()
        } else {
            sine / self.e12
        };
        Motor::new_unchecked(cosine, sine, self.e20 * ratio, self.e01 * ratio)
    }
}

impl<S: Ring> From<[S; 2]> for Point<S> {
    #[inline]
    fn from(coordinates: [S; 2]) -> Self {
        Self::from_coordinates(coordinates)
    }
}
