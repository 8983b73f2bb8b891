//! What a ray can hit.

use super::round::{disc_hit, sphere_crossing, sphere_of};
use super::{Hit, Ray};
use crate::cga3::{Circle, DualCircle, DualPlane, DualSphere, Plane, Sphere};
use crate::geometry::relation::Figure;
use crate::scalar::Real;
use crate::vga3::Vector;

/// A surface that a ray can hit. [`Ray::first_hit`] takes it by value or by reference.
///
/// Implement it for surfaces of your own:
///
/// ```
/// use ga_runtime::cga3::{Plane, Point};
/// use ga_runtime::geometry::ray::{Hit, Ray, Surface};
///
/// /// A plane with a round hole about the origin.
/// struct Holed(Plane<f64>);
///
/// impl Surface<f64> for Holed {
///     fn first_hit_by(&self, ray: Ray<f64>) -> Option<Hit<f64>> {
///         let hit = ray.first_hit(self.0)?;
///         (hit.point.distance(Point::default()) > 1.0).then_some(hit)
///     }
/// }
///
/// let holed = Holed(Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]));
/// let down = |x| Ray::new(Point::new(x, 0.0, 5.0), [0.0, 0.0, -1.0]).unwrap();
/// assert_eq!(down(0.5).first_hit(&holed), None);
/// assert_eq!(down(2.0).first_hit(&holed).unwrap().distance, 5.0);
/// ```
pub trait Surface<S> {
    /// The first hit by a ray, at a distance of more than zero; `None` for a miss.
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>>;
}

impl<S, T: Surface<S> + ?Sized> Surface<S> for &T {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        (**self).first_hit_by(ray)
    }
}

impl<S: Real<Mask = bool>> Surface<S> for DualSphere<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        if self.eo == S::zero() {
            return plane_hit(ray, Vector::new(self.e1, self.e2, self.e3), self.ei);
        }
        sphere_crossing(ray, *self)?.first(ray)
    }
}

impl<S: Real<Mask = bool>> Surface<S> for Sphere<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        self.dual().first_hit_by(ray)
    }
}

impl<S: Real<Mask = bool>> Surface<S> for DualPlane<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        plane_hit(ray, Vector::new(self.e1, self.e2, self.e3), self.ei)
    }
}

impl<S: Real<Mask = bool>> Surface<S> for Plane<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        self.dual().first_hit_by(ray)
    }
}

impl<S: Real<Mask = bool>> Surface<S> for DualCircle<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        disc_hit(ray, *self)
    }
}

impl<S: Real<Mask = bool>> Surface<S> for Circle<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        disc_hit(ray, self.dual())
    }
}

/// Points, point pairs and lines are never hit.
impl<S: Real<Mask = bool>> Surface<S> for Figure<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        match *self {
            Self::Point(_) | Self::PointPair(_) | Self::Line { .. } => None,
            Self::Plane { normal, distance } => plane_hit(ray, normal, distance),
            Self::Circle {
                centre,
                normal,
                radius,
            } => {
                let hit = plane_hit(ray, normal, normal.dot(centre))?;
                is_within(hit.point.into(), centre, radius * radius).then_some(hit)
            }
            Self::Sphere { centre, radius } => sphere_of(ray, centre, radius * radius)?.first(ray),
        }
    }
}

/// The hit of the plane of the points x with `n·x = d`, for a normal of any length.
#[inline]
pub(super) fn plane_hit<S: Real<Mask = bool>>(
    ray: Ray<S>,
    normal: Vector<S>,
    distance: S,
) -> Option<Hit<S>> {
    let slope = normal.dot(ray.direction.into());
    let along = (distance - normal.dot(ray.origin.into())) / slope;
    if !S::zero().less_than(along) {
        return None;
    }
    Hit::of(ray, along, normal, slope)
}

/// Whether a point of the plane of a circle is on or inside it.
#[inline]
pub(super) fn is_within<S: Real<Mask = bool>>(
    place: Vector<S>,
    centre: Vector<S>,
    radius_squared: S,
) -> bool {
    let from_centre = place - centre;
    let square = from_centre.dot(from_centre);
    square.less_than(radius_squared) || square == radius_squared
}
