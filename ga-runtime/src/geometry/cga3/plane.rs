//! Planes, direct and dual.

use crate::cga3::{DualDirection, DualPlane, Plane, Point};
use crate::scalar::{Field, Real, Ring};
use crate::vga3::Vector;

impl<S: Ring> DualPlane<S> {
    /// The plane of the points x with `n·x = d`, as `n + d ei`. With a unit normal, d is the
    /// distance from the origin.
    #[inline]
    #[must_use]
    pub fn from_normal_distance([n1, n2, n3]: [S; 3], distance: S) -> Self {
        Self::new(n1, n2, n3, distance)
    }

    /// The normal n. Its length is the plane's weight.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 3] {
        [self.e1, self.e2, self.e3]
    }
}

impl<S: Field> Plane<S> {
    /// The plane through three points, `p∧q∧r∧ei`: its normal is `(q − p) × (r − p)`, so that p, q,
    /// r are in counterclockwise order as seen from its tip. Zero where the points are collinear.
    ///
    /// ```
    /// use ga_runtime::cga3::{Infinity, Plane, Point};
    /// let (p, q, r) =
    ///     (Point::new(0.0, 0.0, 2.0), Point::new(1.0, 0.0, 2.0), Point::new(0.0, 1.0, 2.0));
    /// let plane = Plane::through(p, q, r);
    /// assert_eq!(plane, p ^ q ^ r ^ Infinity);
    /// assert_eq!(plane.unit_normal(), Some([0.0, 0.0, 1.0]));
    /// assert_eq!(plane.signed_distance(Point::new(5.0, 5.0, 1.5)), Some(-0.5));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>, r: Point<S>) -> Self {
        let normal = p.vector_to(q).cross(p.vector_to(r));
        Self::from_point_normal(p, normal.into())
    }

    /// The plane through a point with a normal.
    #[inline]
    #[must_use]
    pub fn from_point_normal(point: Point<S>, normal: [S; 3]) -> Self {
        let distance = Vector::from(normal).dot(point.into());
        DualPlane::from_normal_distance(normal, distance).undual()
    }

    /// The normal n of the dual plane `n + d ei`. Its length is the plane's weight.
    #[inline]
    #[must_use]
    pub fn normal(self) -> [S; 3] {
        self.dual().normal()
    }

    /// The attitude `B∧ei`, where B is the bivector of the plane: `−ei⌋Π`. The normal is that of B
    /// by the right-hand rule.
    #[inline]
    #[must_use]
    pub fn attitude(self) -> DualDirection<S> {
        DualDirection::from_normal(self.normal())
    }
}

impl<S: Real<Mask = bool>> Plane<S> {
    /// The normal with length 1; `None` for a plane of weight zero.
    #[inline]
    #[must_use]
    pub fn unit_normal(self) -> Option<[S; 3]> {
        Vector::from(self.normal())
            .normalized()
            .map(Vector::coordinates)
    }

    /// The point of the plane nearest to the origin; `None` for a plane of weight zero, or beyond
    /// the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Plane, Point};
    /// let plane = Plane::from_point_normal(Point::new(5.0, 7.0, 3.0), [0.0, 0.0, 2.0]);
    /// assert_eq!(plane.support(), Some(Point::new(0.0, 0.0, 3.0)));
    /// ```
    #[inline]
    #[must_use]
    pub fn support(self) -> Option<Point<S>> {
        let normal = Vector::from(self.unit_normal()?);
        let place = normal * -self.signed_distance(Point::default())?;
        place.is_finite().then(|| Point::from(place))
    }

    /// The distance to a point, positive on the side of the normal; `None` for a plane of weight
    /// zero, or beyond the range of the scalar.
    #[inline]
    #[must_use]
    pub fn signed_distance(self, point: Point<S>) -> Option<S> {
        let dual = self.dual();
        let normal = Vector::from(dual.normal());
        let weight = normal.length();
        let distance = normal.normalized()?.dot(point.into()) - dual.ei / weight;
        distance.is_finite().then_some(distance)
    }
}
