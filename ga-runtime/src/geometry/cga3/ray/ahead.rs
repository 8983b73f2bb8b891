//! Points of planes ahead of a ray.

use super::{Hit, Ray};
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

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
