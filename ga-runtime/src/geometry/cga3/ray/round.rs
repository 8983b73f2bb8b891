//! Rays that meet spheres and discs.

use super::surface::Ahead;
use super::{Hit, Ray};
use crate::cga3::{Circle, DualCircle, DualSphere};
use crate::geometry::cga3::round::{RoundBivector, positive_square};
use crate::geometry::number::is_regular;
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

/// How a ray crosses a dual sphere `σ = w (c − ½r² ei)`; `None` for a miss, for a radius that is
/// zero up to the rounding of σ, and for a dual plane.
#[inline]
pub(super) fn sphere_crossing<S: Real<Mask = bool>>(
    ray: Ray<S>,
    sphere: DualSphere<S>,
) -> Option<Crossing<S>> {
    let place = Vector::new(sphere.e1, sphere.e2, sphere.e3);
    // Their difference is σ², which is w² r².
    let squares = [place.dot(place), (sphere.ei + sphere.ei) * sphere.eo];
    if is_regular(squares[0] - squares[1]) {
        return crossing(ray, place, sphere.eo, positive_square(squares)?);
    }
    let [centre, [a, b, _]] = centre_and_square([
        [sphere.e1, sphere.e2, sphere.e3],
        [sphere.eo, sphere.ei, S::zero()],
    ]);
    crossing(ray, centre.into(), S::one(), positive_square([a, b])?)
}

/// The centre c of a sphere of any weight, with c² and c² − r², given its coefficients of e1, e2,
/// e3 and of eo, ei.
#[cold]
#[inline(never)]
fn centre_and_square<S: Real>([place, [eo, ei, _]]: [[S; 3]; 2]) -> [[S; 3]; 2] {
    let centre = Vector::from(place).divided(eo);
    let squares = [centre.dot(centre), (ei + ei) / eo, S::zero()];
    [centre.into(), squares]
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
    crossing(ray, centre, S::one(), radius_squared)
}

/// How a ray crosses a sphere, given w c, w and w² r² > 0. A miss is found without a division.
#[inline]
fn crossing<S: Real<Mask = bool>>(
    ray: Ray<S>,
    place: Vector<S>,
    weight: S,
    square: S,
) -> Option<Crossing<S>> {
    let direction = Vector::from(ray.direction);
    let to_centre = place - Vector::from(ray.origin) * weight;
    let middle = to_centre.dot(direction);
    // The part perpendicular to the ray is squared, not the difference of two squares taken, which
    // would lose the radius of a small sphere far away.
    let to_centre = to_centre - direction * middle;
    let half_squared = square - to_centre.dot(to_centre);
    if half_squared.less_than(S::zero()) {
        return None;
    }
    let inverse = weight.recip();
    Some(Crossing {
        middle: middle * inverse,
        half: half_squared.sqrt() * inverse.abs(),
        to_centre: to_centre * inverse,
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

/// The hit of the inside of a circle, given in dual form as a multiple of
/// `(c + eo + β ei) ∧ (n + (c·n) ei)`, with its centre c, the normal n and `r² = c² − 2β`.
#[inline]
pub(super) fn disc_hit<S: Real<Mask = bool>>(
    ray: Ray<S>,
    disc: DualCircle<S>,
    circle: &Circle<S>,
) -> Option<Hit<S>> {
    let normal = Vector::new(-disc.e1o, -disc.e2o, -disc.e3o);
    let ahead = Ahead::of_plane(ray, normal, disc.eoi)?;
    let square = normal.dot(normal);
    let (centre, radius_squared) = if is_regular(square) {
        let inverse = square.recip();
        let moment = Vector::new(disc.e23, -disc.e13, disc.e12);
        let centre = (normal * disc.eoi + normal.cross(moment)) * inverse;
        let last = normal.dot(Vector::new(disc.e1i, disc.e2i, disc.e3i));
        let infinite = (disc.eoi * disc.eoi - last) * inverse;
        (centre, centre.dot(centre) - (infinite + infinite))
    } else {
        let [centre, [radius_squared, ..]] = centre_and_square_of_disc(circle)?;
        (centre.into(), radius_squared)
    };
    ahead.within(ray, centre, radius_squared)?.hit(ray, normal)
}

/// Centre and squared radius of a circle of any weight. It takes the circle by reference, so that
/// its coefficients stay in registers where this is not called.
#[cold]
#[inline(never)]
fn centre_and_square_of_disc<S: Real<Mask = bool>>(circle: &Circle<S>) -> Option<[[S; 3]; 2]> {
    let round = RoundBivector::of(circle.dual())?;
    let [a, b] = round.squares();
    Some([round.centre.into(), [b - a, S::zero(), S::zero()]])
}
