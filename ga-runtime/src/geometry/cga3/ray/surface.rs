//! What a ray can hit.

use super::ahead::Ahead;
use super::round::{disc_hit, sphere_crossing, sphere_of};
use super::{Hit, Ray};
use crate::cga3::{Circle, DualCircle, DualPlane, DualSphere, Plane, Sphere};
use crate::geometry::relation::Figure;
use crate::scalar::{Maybe, Optional, Real};
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

impl<S: Real> Ray<S> {
    /// The first hit of a surface, at a distance of more than zero; `None` for a miss. The
    /// [module](super) lists the surfaces and says what counts as a hit.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::ray::{Ray, Side};
    /// let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]].map(Point::from);
    /// let ray = Ray::new(Point::new(1.0, 1.0, 3.0), [0.0, 0.0, -1.0]).unwrap();
    /// let hit = ray.first_hit(triangle).unwrap();
    /// assert_eq!((hit.distance, hit.side()), (3.0, Side::Front));
    /// let beside = Ray::new(Point::new(3.0, 3.0, 3.0), [0.0, 0.0, -1.0]).unwrap();
    /// assert_eq!(beside.first_hit(triangle), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn first_hit<T: Surface<S>>(self, surface: T) -> Maybe<Hit<S>, S> {
        surface.first_hit_by(self)
    }
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
