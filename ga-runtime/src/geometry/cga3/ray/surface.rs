//! What a ray can hit.

use super::round::{disc_hit, sphere_crossing, sphere_of};
use super::{Hit, Ray};
use crate::cga3::{Circle, DualCircle, DualPlane, DualSphere, Plane, Sphere};
use crate::geometry::relation::Figure;
use crate::scalar::{Mask, Maybe, Optional, Real};
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
pub trait Surface<S: Real> {
    /// The first hit by a ray, at a distance of more than zero; `None` for a miss.
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S>;
}

impl<S: Real, T: Surface<S> + ?Sized> Surface<S> for &T {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        (**self).first_hit_by(ray)
    }
}

impl<S: Real> Surface<S> for DualSphere<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        sphere_crossing(ray, *self).and_then(|crossing| crossing.first(ray))
    }
}

impl<S: Real> Surface<S> for Sphere<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        self.dual().first_hit_by(ray)
    }
}

impl<S: Real> Surface<S> for DualPlane<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        let normal = Vector::new(self.e1, self.e2, self.e3);
        Ahead::of_plane(ray, normal, self.ei).and_then(|ahead| ahead.hit(ray, normal))
    }
}

impl<S: Real> Surface<S> for Plane<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        self.dual().first_hit_by(ray)
    }
}

impl<S: Real> Surface<S> for DualCircle<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        disc_hit(ray, self.undual())
    }
}

impl<S: Real> Surface<S> for Circle<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        disc_hit(ray, *self)
    }
}

/// Points, point pairs and lines are never hit.
impl<S: Real<Mask = bool>> Surface<S> for Figure<S> {
    #[inline]
    fn first_hit_by(&self, ray: Ray<S>) -> Option<Hit<S>> {
        match *self {
            Self::Point(_) | Self::PointPair(_) | Self::Line { .. } => None,
            Self::Plane { normal, distance } => {
                Ahead::of_plane(ray, normal, distance)?.hit(ray, normal)
            }
            Self::Circle {
                centre,
                normal,
                radius,
            } => {
                let ahead = Ahead::through(ray, normal, centre)?;
                ahead.within(ray, centre, radius * radius)?.hit(ray, normal)
            }
            Self::Sphere { centre, radius } => sphere_of(ray, centre, radius * radius)?.first(ray),
        }
    }
}

/// A point of a plane ahead of the origin of a ray.
#[derive(Clone, Copy)]
pub(super) struct Ahead<S> {
    distance: S,
    /// The inner product of the normal and the direction of the ray.
    slope: S,
}

impl<S: Real> Ahead<S> {
    /// Of the plane of the points x with `n·x = d`, for a normal of any length.
    #[inline]
    pub(super) fn of_plane(ray: Ray<S>, normal: Vector<S>, distance: S) -> Maybe<Self, S> {
        Self::at(ray, normal, distance - normal.dot(ray.origin.into()))
    }

    /// Of the plane through a point, for a normal of any length.
    #[inline]
    pub(super) fn through(ray: Ray<S>, normal: Vector<S>, point: Vector<S>) -> Maybe<Self, S> {
        Self::at(ray, normal, normal.dot(point - Vector::from(ray.origin)))
    }

    /// Of the plane at a height above the origin of the ray, times the length of the normal.
    #[inline]
    fn at(ray: Ray<S>, normal: Vector<S>, height: S) -> Maybe<Self, S> {
        let slope = normal.dot(ray.direction.into());
        let distance = height / slope;
        // False for a parallel plane, where the quotient is infinite with either sign, or NaN.
        let ahead = S::zero().less_than(distance).when(Self { distance, slope });
        ahead.filter(|_| (distance * distance).is_finite())
    }

    /// Itself, if it is in or on the sphere with this centre and squared radius.
    #[inline]
    pub(super) fn within(
        self,
        ray: Ray<S>,
        centre: Vector<S>,
        radius_squared: S,
    ) -> Maybe<Self, S> {
        let from_centre = Vector::from(ray.at(self.distance)) - centre;
        let square = from_centre.dot(from_centre);
        square.less_or_equal(radius_squared).when(self)
    }

    /// The hit, with the normal of the plane.
    #[inline]
    pub(super) fn hit(self, ray: Ray<S>, normal: Vector<S>) -> Maybe<Hit<S>, S> {
        Hit::of(ray, self.distance, normal, self.slope)
    }
}
