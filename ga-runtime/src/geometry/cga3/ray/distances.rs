//! Distances along the lines of rays alone, without the points and normals of hits.

use super::Ray;
use crate::cga3::{Plane, Sphere};
use crate::scalar::{Optional, Real};
use crate::vga3::Vector;

impl<S: Real> Ray<S> {
    /// Whether the line of the ray crosses a sphere, and the distances at which it enters and
    /// leaves it, in this order, as for [`entry_and_exit`](Self::entry_and_exit). Negative
    /// distances are behind the origin. Both are zero where the line misses the sphere.
    ///
    /// ```
    /// use ga_runtime::cga3::{Direction, Point, Sphere};
    /// use ga_runtime::geometry::ray::Ray;
    /// use ga_runtime::scalar::Lanes;
    ///
    /// let all = |x: f64| Lanes::from_array([x; 4]);
    /// let unit = Sphere::from_centre_radius(Point::new(all(0.0), all(0.0), all(0.0)), all(1.0));
    /// // Four parallel rays at different heights.
    /// let heights = Lanes::from_array([0.0, 0.6, 1.0, 2.0]);
    /// let rays = Ray::new_unchecked(
    ///     Point::new(all(-3.0), heights, all(0.0)),
    ///     Direction::new(all(1.0), all(0.0), all(0.0)),
    /// );
    /// let (is_hit, [enters, leaves]) = rays.sphere_distances(unit);
    /// assert_eq!(is_hit.to_array(), [true, true, true, false]);
    /// assert_eq!(enters.to_array(), [2.0, 2.2, 3.0, 0.0]);
    /// assert_eq!(leaves.to_array(), [4.0, 3.8, 3.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn sphere_distances(self, sphere: Sphere<S>) -> (S::Mask, [S; 2]) {
        let crossing = self.entry_and_exit(sphere);
        let ends = crossing.map(|ends| ends.map(|hit| hit.distance));
        (ends.is_some(), ends.unwrap_or([S::zero(); 2]))
    }

    /// Whether the line of the ray crosses a plane, and at which distance; a negative distance is
    /// behind the origin. Zero for a parallel plane.
    ///
    /// ```
    /// use ga_runtime::cga3::{Plane, Point};
    /// use ga_runtime::geometry::ray::Ray;
    /// let floor = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    /// let ray = Ray::new(Point::new(0.0, 0.0, 4.0), [0.0, 0.0, 1.0]).unwrap();
    /// assert_eq!(ray.plane_distance(floor), (true, -4.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn plane_distance(self, plane: Plane<S>) -> (S::Mask, S) {
        let dual = plane.dual();
        let normal = Vector::new(dual.e1, dual.e2, dual.e3);
        let height = dual.ei - normal.dot(self.origin.into());
        let distance = height / normal.dot(self.direction.into());
        let is_hit = (distance * distance).is_finite();
        (is_hit, S::select(is_hit, distance, S::zero()))
    }
}
