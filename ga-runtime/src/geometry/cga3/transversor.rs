//! Transversors.

use super::even_versor::image_point;
use crate::cga3::{Bivector, Point, Transversor};
use crate::scalar::{Field, Real, Ring};

impl<S: Field> Transversor<S> {
    /// The special conformal map `K = 1 − k eo = exp(−k eo)`: inversion in the unit sphere about
    /// the origin, translation by k, inversion again, so that x goes to
    /// `(x + k x²)/(1 + 2 k·x + k² x²)`.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Transversor};
    /// let bend = Transversor::from_vector([1.0, 0.0, 0.0]);
    /// assert_eq!(
    ///     bend.transform_point(Point::new(1.0, 0.0, 0.0)),
    ///     Some(Point::new(0.5, 0.0, 0.0))
    /// );
    /// assert_eq!(bend.transform_point(Point::new(-1.0, 0.0, 0.0)), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn from_vector(vector: [S; 3]) -> Self {
        let [x, y, z] = vector.map(|x| -x);
        Self::new(x, y, z)
    }

    /// The vector k.
    #[inline]
    #[must_use]
    pub fn vector(self) -> [S; 3] {
        [-self.e1o(), -self.e2o(), -self.e3o()]
    }
}

impl<S: Ring> Transversor<S> {
    /// The generator `−k eo`, whose exponential this is.
    #[inline]
    #[must_use]
    pub fn log(self) -> Bivector<S> {
        let [e1o, e2o, e3o] = [self.e1o(), self.e2o(), self.e3o()];
        Bivector {
            e1o,
            e2o,
            e3o,
            ..Bivector::default()
        }
    }
}

impl<S: Real<Mask = bool>> Transversor<S> {
    /// The power, which is the transversor of `t k`.
    #[inline]
    #[must_use]
    pub fn powf(self, t: S) -> Self {
        Self::from_vector(self.vector().map(|x| x * t))
    }

    /// The square root, which is the transversor of `½ k`.
    #[inline]
    #[must_use]
    pub fn sqrt(self) -> Self {
        self.powf(S::from_ratio(1, 2))
    }

    /// The image of a point; `None` where it is at infinity, as for the point `−k/k²`, or beyond
    /// the range of the scalar.
    #[must_use]
    pub fn transform_point(self, point: Point<S>) -> Option<Point<S>> {
        image_point(self.transform(point))
    }
}
