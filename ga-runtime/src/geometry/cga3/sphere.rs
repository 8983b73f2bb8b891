//! Spheres.

use crate::cga3::{DualSphere, Point, Sphere};
use crate::scalar::{Field, Real};

impl<S: Field> Sphere<S> {
    /// The sphere through four points, `p∧q∧r∧s`; a plane where they are coplanar, zero where they
    /// are on one circle or line.
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
        p ^ q ^ r ^ s
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

    /// The centre; `None` for a plane.
    #[inline]
    #[must_use]
    pub fn centre(self) -> Option<Point<S>> {
        self.dual().centre()
    }

    /// The squared radius, negative for an imaginary sphere; `None` for a plane.
    #[inline]
    #[must_use]
    pub fn radius_squared(self) -> Option<S> {
        self.dual().radius_squared()
    }
}

impl<S: Real<Mask = bool>> Sphere<S> {
    /// The radius; `None` for a plane and for an imaginary sphere. The coefficients of the sphere
    /// determine r² only up to the rounding of the squared distance of the centre from the origin:
    /// where `|r²| ≤ 32 ε (2c² + r²)` the radius is zero.
    #[inline]
    #[must_use]
    pub fn radius(self) -> Option<S> {
        self.dual().radius()
    }
}
