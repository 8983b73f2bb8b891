//! Rays that meet spheres and discs.

use super::ahead::Ahead;
use super::{Hit, Ray};
use crate::cga3::{Circle, DualSphere, Sphere};
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

/// The line of a ray that crosses a sphere, relative to the point of the line nearest to the
/// centre.
pub(super) struct Crossing<S> {
    /// The distance of that point along the ray.
    middle: S,
    /// Half the distance between the two ends.
    half: S,
    /// From that point to the centre, perpendicular to the ray.
    to_centre: Vector<S>,
}

/// How a ray crosses a dual sphere; `None` for a miss, and for a sphere of weight zero or with a
/// number that is not finite.
#[inline]
pub(super) fn sphere_crossing<S: Real>(
    ray: Ray<S>,
    sphere: DualSphere<S>,
) -> Maybe<Crossing<S>, S> {
    let centre = sphere.centre();
    centre.and_then(|centre| sphere_of(ray, centre.into(), sphere.radius_squared))
}

/// How a ray crosses the sphere with this centre and squared radius; `None` unless that is
/// positive.
#[inline]
pub(super) fn sphere_of<S: Real>(
    ray: Ray<S>,
    centre: Vector<S>,
    radius_squared: S,
) -> Maybe<Crossing<S>, S> {
    let is_real = S::zero().less_than(radius_squared);
    is_real.when(()).and_then(|()| {
        let direction = Vector::from(ray.direction);
        let to_centre = centre - Vector::from(ray.origin);
        let middle = to_centre.dot(direction);
        // The part perpendicular to the ray is squared, not the difference of two squares taken,
        // which would lose the radius of a small sphere far away.
        let to_centre = to_centre - direction * middle;
        let half_squared = radius_squared - to_centre.dot(to_centre);
        let is_miss = half_squared.less_than(S::zero());
        (!is_miss).when(()).map(|()| Crossing {
            middle,
            // A number also in lanes that miss, so that they do not need the careful ways of NaN.
            half: S::select(is_miss, S::zero(), half_squared).sqrt(),
            to_centre,
        })
    })
}

impl<S: Real> Ray<S> {
    /// Where the line of the ray enters a sphere and where it leaves it, in this order: from the
    /// front, then from the back. A distance that is not positive is not ahead of the origin: both
    /// are negative for a sphere behind it, and the first for a ray that begins inside. Both are
    /// equal for a line that only touches the sphere. `None` where the line misses it, and for a
    /// sphere that is imaginary, of radius zero or of weight zero.
    ///
    /// The points are the ends of the pair `−(L ∨ S)`, with L the [line](Self::line) and S the
    /// sphere, in the order of [`PointPair::endpoints`](crate::cga3::PointPair::endpoints).
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Sphere};
    /// use ga_runtime::geometry::ray::Ray;
    /// let ball = Sphere::from_centre_radius(Point::new(5.0, 0.0, 0.0), 1.0);
    /// let ray = Ray::new(Point::default(), [1.0, 0.0, 0.0]).unwrap();
    /// let [enters, leaves] = ray.entry_and_exit(ball).unwrap();
    /// assert_eq!((enters.distance, leaves.distance), (4.0, 6.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn entry_and_exit(self, sphere: Sphere<S>) -> Maybe<[Hit<S>; 2], S> {
        let crossing = sphere_crossing(self, sphere.dual());
        crossing.and_then(|crossing| {
            let entry = crossing.entry(self);
            entry.and_then(|entry| crossing.exit(self).map(|exit| [entry, exit]))
        })
    }
}

impl<S: Real> Crossing<S> {
    /// The end that is ahead of the origin, the nearer one if both are.
    #[inline]
    pub(super) fn first(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        let is_outside = self.half.less_than(self.middle);
        let offset = S::select(is_outside, -self.half, self.half);
        let is_ahead = S::zero().less_than(self.middle + offset);
        is_ahead.when(()).and_then(|()| self.end(ray, offset))
    }

    /// Where the line enters the sphere.
    #[inline]
    pub(super) fn entry(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        self.end(ray, -self.half)
    }

    /// Where the line leaves the sphere.
    #[inline]
    pub(super) fn exit(&self, ray: Ray<S>) -> Maybe<Hit<S>, S> {
        self.end(ray, self.half)
    }

    /// The end at a distance from the middle, negative for the entry.
    #[inline]
    fn end(&self, ray: Ray<S>, offset: S) -> Maybe<Hit<S>, S> {
        // From the centre to the end, without the distance from the origin, which may be much
        // larger than the radius.
        let normal = Vector::from(ray.direction) * offset - self.to_centre;
        Hit::of(ray, self.middle + offset, normal, offset)
    }
}

/// The hit of the inside of a circle.
#[inline]
pub(super) fn disc_hit<S: Real>(ray: Ray<S>, disc: Circle<S>) -> Maybe<Hit<S>, S> {
    let normal = Vector::from(disc.normal.vector());
    disc.centre().and_then(|centre| {
        let centre = Vector::from(centre);
        Ahead::through(ray, normal, centre)
            .and_then(|ahead| ahead.within(ray, centre, disc.radius_squared))
            .and_then(|ahead| ahead.hit(ray, normal))
    })
}
