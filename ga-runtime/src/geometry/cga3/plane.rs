//! Planes, direct and dual.

use crate::cga3::{DualDirection, DualPlane, Plane, Point};
use crate::geometry::number::{is_moderate, is_number, is_regular};
use crate::scalar::{Field, Mask, Maybe, Optional, Real, Ring};
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

impl<S: Real> Plane<S> {
    /// The normal with length 1; `None` for a plane of weight zero.
    #[inline]
    #[must_use]
    pub fn unit_normal(self) -> Maybe<[S; 3], S> {
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
    pub fn support(self) -> Maybe<Point<S>, S> {
        let (normal, number) = self.vectors();
        let square = normal.length_squared();
        let inverse = square.recip();
        let way = number * inverse;
        let is_accurate = is_moderate(square + inverse + way.abs());
        let place = is_accurate.when((normal * way).into());
        place
            .or_else_of((normal.into(), number), |(normal, number)| {
                moved_of_any(normal, number, [S::zero(); 3], S::one())
            })
            .map(Point::from)
    }

    /// The distance to a point, positive on the side of the normal; `None` for a plane of weight
    /// zero, or beyond the range of the scalar.
    #[inline]
    #[must_use]
    pub fn signed_distance(self, point: Point<S>) -> Maybe<S, S> {
        let (normal, number) = self.vectors();
        let square = normal.length_squared();
        let distance = (normal.dot(point.into()) - number) / square.sqrt();
        (is_regular(square) & is_number(distance))
            .when(distance)
            .or_else_of(
                (normal.into(), number, point.coordinates()),
                |(normal, number, point)| signed_distance_of_any(normal, number, point),
            )
    }

    /// The unit normal n and the distance d of the points x with `n·x = d`; `None` for a plane of
    /// weight zero, or beyond the range of the scalar.
    #[inline]
    pub(super) fn parts(self) -> Maybe<(Vector<S>, S), S> {
        let (normal, number) = self.vectors();
        let square = normal.length_squared();
        let length = square.sqrt();
        let distance = number / length;
        (is_regular(square) & is_number(distance))
            .when((normal.divided(length), distance))
            .or_else_of((normal.into(), number), |(normal, number)| {
                let parts = parts_of_any(normal, number);
                parts.map(|[x, y, z, distance]| (Vector::new(x, y, z), distance))
            })
    }

    /// A point moved along the normal by a factor times its height above the plane, towards the
    /// plane: the foot of the perpendicular for 1, the mirror image for 2.
    #[inline]
    pub(super) fn moved_along_normal(self, point: Vector<S>, factor: S) -> Maybe<Vector<S>, S> {
        let (normal, number) = self.vectors();
        let square = normal.length_squared();
        let inverse = square.recip();
        let way = (normal.dot(point) - number) * (factor * inverse);
        // A point without a number gives a way without one.
        let is_accurate = is_moderate(square + inverse + way.abs());
        is_accurate.when(point - normal * way).or_else_of(
            (normal.into(), number, point.into(), factor),
            |(normal, number, point, factor)| {
                moved_of_any(normal, number, point, factor).map(Vector::from)
            },
        )
    }

    /// The normal n and the number d of the points x with `n·x = d`, both times the weight.
    #[inline]
    pub(super) fn vectors(self) -> (Vector<S>, S) {
        let dual = self.dual();
        (dual.normal().into(), dual.ei)
    }
}

/// The unit normal and the distance of a plane of any weight.
fn unit_parts<S: Real>(normal: Vector<S>, number: S) -> Maybe<(Vector<S>, S), S> {
    let distance = number / normal.length();
    let unit = normal.normalized();
    unit.zip(distance.is_finite().when(distance))
}

// Outlined code takes and returns arrays made for it, so that the numbers of its callers stay in
// registers.

#[cold]
#[inline(never)]
fn parts_of_any<S: Real>(normal: [S; 3], number: S) -> Maybe<[S; 4], S> {
    let parts = unit_parts(normal.into(), number);
    parts.map(|(Vector { e1, e2, e3 }, distance)| [e1, e2, e3, distance])
}

#[cold]
#[inline(never)]
fn signed_distance_of_any<S: Real>(normal: [S; 3], number: S, point: [S; 3]) -> Maybe<S, S> {
    unit_parts(normal.into(), number)
        .map(|(normal, distance)| normal.dot(point.into()) - distance)
        .filter(|distance| distance.is_finite())
}

#[cold]
#[inline(never)]
fn moved_of_any<S: Real>(normal: [S; 3], number: S, point: [S; 3], factor: S) -> Maybe<[S; 3], S> {
    let point = Vector::from(point);
    let place = unit_parts(normal.into(), number).map(|(normal, distance)| {
        let height = normal.dot(point) - distance;
        point - normal * (height * factor)
    });
    place.filter(|place| place.is_finite()).map(Vector::into)
}
