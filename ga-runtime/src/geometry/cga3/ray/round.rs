//! Rays that meet spheres and discs.

use super::surface::Ahead;
use super::{Hit, Ray};
use crate::cga3::{Circle, DualSphere};
use crate::scalar::Real;
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
pub(super) fn sphere_crossing<S: Real<Mask = bool>>(
    ray: Ray<S>,
    sphere: DualSphere<S>,
) -> Option<Crossing<S>> {
    sphere_of(ray, sphere.centre()?.into(), sphere.radius_squared)
}

/// How a ray crosses the sphere with this centre and squared radius; `None` unless that is
/// positive.
#[inline]
pub(super) fn sphere_of<S: Real<Mask = bool>>(
    ray: Ray<S>,
    centre: Vector<S>,
    radius_squared: S,
) -> Option<Crossing<S>> {
    if !S::zero().less_than(radius_squared) {
        return None;
    }
    let direction = Vector::from(ray.direction);
    let to_centre = centre - Vector::from(ray.origin);
    let middle = to_centre.dot(direction);
    // The part perpendicular to the ray is squared, not the difference of two squares taken, which
    // would lose the radius of a small sphere far away.
    let to_centre = to_centre - direction * middle;
    let half_squared = radius_squared - to_centre.dot(to_centre);
    if half_squared.less_than(S::zero()) {
        return None;
    }
    Some(Crossing {
        middle,
        half: half_squared.sqrt(),
        to_centre,
    })
}

impl<S: Real<Mask = bool>> Crossing<S> {
    /// The end that is ahead of the origin, the nearer one if both are.
    #[inline]
    pub(super) fn first(&self, ray: Ray<S>) -> Option<Hit<S>> {
        let is_outside = self.half.less_than(self.middle);
        let offset = if is_outside { -self.half } else { self.half };
        if !S::zero().less_than(self.middle + offset) {
            return None;
        }
        self.end(ray, offset)
    }

    /// Where the line enters the sphere.
    #[inline]
    pub(super) fn entry(&self, ray: Ray<S>) -> Option<Hit<S>> {
        self.end(ray, -self.half)
    }

    /// Where the line leaves the sphere.
    #[inline]
    pub(super) fn exit(&self, ray: Ray<S>) -> Option<Hit<S>> {
        self.end(ray, self.half)
    }

    /// The end at a distance from the middle, negative for the entry.
    #[inline]
    fn end(&self, ray: Ray<S>, offset: S) -> Option<Hit<S>> {
        // From the centre to the end, without the distance from the origin, which may be much
        // larger than the radius.
        let normal = Vector::from(ray.direction) * offset - self.to_centre;
        Hit::of(ray, self.middle + offset, normal, offset)
    }
}

/// The hit of the inside of a circle.
#[inline]
pub(super) fn disc_hit<S: Real<Mask = bool>>(ray: Ray<S>, disc: Circle<S>) -> Option<Hit<S>> {
    let (centre, normal) = (
        Vector::from(disc.centre()?),
        Vector::from(disc.normal.vector()),
    );
    let ahead = Ahead::through(ray, normal, centre)?;
    ahead
        .within(ray, centre, disc.radius_squared)?
        .hit(ray, normal)
}
