//! Tangents: the plane that touches a sphere at a point of it, the line that touches a circle.
//!
//! In blades, the tangent plane at a point P of a sphere S is `−(P⌋S)∧ei`, in dual form `P − σ` for
//! a dual sphere σ of weight 1. Here it is computed from centre and radius, so that it touches the
//! sphere exactly even if the point lies beside it within the tolerance.

use super::tolerance::within;
use super::{Figure, Primitive, Tolerance};
use crate::cga3::{Circle, DualPlane, DualSphere, Line, Plane, Point, Sphere};
use crate::geometry::cga3::round::unit_axis;
use crate::scalar::Real;
use crate::vga3::Vector;

impl<S: Real<Mask = bool>> Sphere<S> {
    /// The plane that touches the sphere at a point of it, with the outward normal of length 1.
    /// `None` where the distance of the point from the sphere is more than that of the tolerance,
    /// where the radius is zero, or where the sphere is not a figure.
    ///
    /// ```
    /// use ga_runtime::cga3::{Plane, Point, Sphere};
    /// use ga_runtime::geometry::relation::Tolerance;
    /// let sphere = Sphere::from_centre_radius(Point::new(1.0, 0.0, 0.0), 5.0);
    /// let top = Point::new(1.0, 0.0, 5.0);
    /// let plane = sphere.tangent_plane_at(top, Tolerance::default());
    /// assert_eq!(plane, Some(Plane::from_point_normal(top, [0.0, 0.0, 1.0])));
    /// // A point off the sphere has no tangent plane. To take the nearest point instead:
    /// let above = Point::new(1.0, 0.0, 7.0);
    /// assert_eq!(sphere.tangent_plane_at(above, Tolerance::default()), None);
    /// let nearest = above.project_onto(sphere).unwrap();
    /// assert_eq!(sphere.tangent_plane_at(nearest, Tolerance::default()), plane);
    /// ```
    #[inline]
    #[must_use]
    pub fn tangent_plane_at(self, point: Point<S>, tolerance: Tolerance<S>) -> Option<Plane<S>> {
        let centre = Vector::from(self.centre()?);
        let radius = self.radius()?;
        let from = Vector::from(point) - centre;
        let is_on =
            S::zero().less_than(radius) && within(from.length() - radius, tolerance.distance);
        let normal = unit_axis(from.into()).filter(|_| is_on)?;
        let distance = normal.dot(centre) + radius;
        Some(DualPlane::from_normal_distance(normal.into(), distance).undual())
    }
}

impl<S: Real<Mask = bool>> DualSphere<S> {
    /// The plane that touches the sphere at a point of it, with the outward normal of length 1; see
    /// [`Sphere::tangent_plane_at`].
    #[inline]
    #[must_use]
    pub fn tangent_plane_at(
        self,
        point: Point<S>,
        tolerance: Tolerance<S>,
    ) -> Option<DualPlane<S>> {
        let plane = self.undual().tangent_plane_at(point, tolerance)?;
        Some(plane.dual())
    }
}

impl<S: Real<Mask = bool>> Circle<S> {
    /// The line that touches the circle at a point of it, with a direction of length 1, which is
    /// that in which the circle runs: counterclockwise as seen from the tip of its normal. `None`
    /// where the distance of the point from the circle is more than that of the tolerance, where
    /// the radius is zero, or where the circle is not a figure.
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Line, Point};
    /// use ga_runtime::geometry::relation::Tolerance;
    /// let (o, up) = (Point::default(), [0.0, 0.0, 1.0]);
    /// let circle = Circle::from_centre_normal_radius(o, up, 2.0).unwrap();
    /// let right = Point::new(2.0, 0.0, 0.0);
    /// let tangent = Line::from_point_direction(right, [0.0, 1.0, 0.0]);
    /// assert_eq!(circle.tangent_line_at(right, Tolerance::default()), Some(tangent));
    /// ```
    #[must_use]
    pub fn tangent_line_at(self, point: Point<S>, tolerance: Tolerance<S>) -> Option<Line<S>> {
        let Figure::Circle {
            centre,
            normal,
            radius,
        } = self.figure()?
        else {
            return None;
        };
        let from = Vector::from(point) - centre;
        let out = from.across(normal).normalized()?;
        let place = centre + out * radius;
        let is_on = S::zero().less_than(radius)
            && within((Vector::from(point) - place).length(), tolerance.distance);
        is_on.then(|| Line::from_point_direction(place.into(), normal.cross(out).into()))
    }
}
