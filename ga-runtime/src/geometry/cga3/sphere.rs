//! Spheres.

use crate::cga3::{DualSphere, Point, Sphere};
use crate::scalar::{Field, Maybe, Real};

crate::ga! {
    crate::cga3;

    fn through(p: Point, q: Point, r: Point, s: Point) -> Sphere { p ^ q ^ r ^ s }
}

impl<S: Field> Sphere<S> {
    /// The sphere through four points, `p∧q∧r∧s`. Its weight is zero where they are coplanar, so
    /// that it has no [centre](Self::centre); [`Plane::through`] joins three of them.
    ///
    /// [`Plane::through`]: crate::cga3::Plane::through
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Sphere};
    /// let [p, q, r, s] =
    ///     [[3.0, 0.0, 0.0], [1.0, 2.0, 0.0], [1.0, 0.0, 2.0], [-1.0, 0.0, 0.0]].map(Point::from);
    /// let sphere = Sphere::through(p, q, r, s);
    /// assert_eq!(sphere.centre().unwrap().coordinates(), [1.0, 0.0, 0.0]);
    /// assert_eq!(sphere.radius(), Some(2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>, r: Point<S>, s: Point<S>) -> Self {
        through(p, q, r, s)
    }

    /// The sphere with a given centre and radius.
    #[inline]
    #[must_use]
    pub fn from_centre_radius(centre: Point<S>, radius: S) -> Self {
        DualSphere::from_centre_radius(centre, radius).undual()
    }

    /// The sphere with a given centre and squared radius, which may be zero, for a point, or
    /// negative, for an imaginary sphere.
    #[inline]
    #[must_use]
    pub fn from_centre_radius_squared(centre: Point<S>, radius_squared: S) -> Self {
        DualSphere::from_centre_radius_squared(centre, radius_squared).undual()
    }
}

impl<S: Real> Sphere<S> {
    /// The centre; `None` for a sphere of weight zero, and where a number is not finite.
    #[inline]
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        self.dual().centre()
    }

    /// The squared radius, negative for an imaginary sphere; `None` where there is no
    /// [centre](Self::centre).
    #[inline]
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        self.dual().radius_squared()
    }

    /// The radius; `None` where there is no [centre](Self::centre), and for an imaginary sphere.
    #[inline]
    #[must_use]
    pub fn radius(self) -> Maybe<S, S> {
        self.dual().radius()
    }
}
