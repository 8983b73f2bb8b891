//! Rays that meet spheres and discs.

use super::surface::is_within;
use super::{Hit, Ray};
use crate::cga3::{DualCircle, DualSphere};
use crate::geometry::cga3::round::RoundBivector;
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

/// How a ray crosses a dual sphere σ = w (c − ½r² ei); `None` for a miss, and for a dual plane.
#[inline]
pub(super) fn sphere_crossing<S: Real<Mask = bool>>(
    ray: Ray<S>,
    sphere: DualSphere<S>,
) -> Option<Crossing<S>> {
    // Infinite or NaN for a dual plane, which is a miss.
    let inverse = sphere.eo.recip();
    let centre = Vector::new(sphere.e1, sphere.e2, sphere.e3) * inverse;
    let radius_squared = centre.dot(centre) - (sphere.ei + sphere.ei) * inverse;
    sphere_of(ray, centre, radius_squared)
}

/// How a ray crosses the sphere with this centre and squared radius.
#[inline]
pub(super) fn sphere_of<S: Real<Mask = bool>>(
    ray: Ray<S>,
    centre: Vector<S>,
    radius_squared: S,
) -> Option<Crossing<S>> {
    let direction = Vector::from(ray.direction);
    let to_centre = centre - Vector::from(ray.origin);
    let middle = to_centre.dot(direction);
    // The part perpendicular to the ray is squared, not the difference of two squares taken, which
    // would lose the radius of a small sphere far away.
    let to_centre = to_centre - direction * middle;
    let half_squared = radius_squared - to_centre.dot(to_centre);
    if half_squared.less_than(S::zero()) || !S::zero().less_than(radius_squared) {
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
        if S::zero().less_than(self.middle - self.half) {
            self.entry(ray)
        } else if S::zero().less_than(self.middle + self.half) {
            self.exit(ray)
        } else {
            None
        }
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

/// The hit of the inside of a circle, given in dual form as a multiple of
/// `(c + eo + β ei) ∧ (n + (c·n) ei)`, with its centre c, the normal n and `r² = c² − 2β`.
#[inline]
pub(super) fn disc_hit<S: Real<Mask = bool>>(ray: Ray<S>, circle: DualCircle<S>) -> Option<Hit<S>> {
    let normal = Vector::new(-circle.e1o, -circle.e2o, -circle.e3o);
    let hit = super::surface::plane_hit(ray, normal, circle.eoi)?;
    let square = normal.dot(normal);
    let is_usual = S::from_f64(1e-12).less_than(square) && square.less_than(S::from_f64(1e12));
    let (centre, radius_squared) = if is_usual {
        let inverse = square.recip();
        let moment = Vector::new(circle.e23, -circle.e13, circle.e12);
        let centre = (normal * circle.eoi + normal.cross(moment)) * inverse;
        let last = normal.dot(Vector::new(circle.e1i, circle.e2i, circle.e3i));
        let infinite = (circle.eoi * circle.eoi - last) * inverse;
        (centre, centre.dot(centre) - (infinite + infinite))
    } else {
        let round = RoundBivector::of(circle)?;
        let [a, b] = round.squares();
        (round.centre, b - a)
    };
    is_within(hit.point.into(), centre, radius_squared).then_some(hit)
}
