//! Primitives as a point sees them: how far away they are, and where they are nearest.

use super::figure_distance::from_circle;
use super::tolerance::within;
use super::{Tolerance, parallel};
use crate::cga3::{
    Bivector, Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint,
    Line, MotorGenerator, Plane, Point, PointPair, Quadvector, Sphere, Trivector,
};
use crate::geometry::cga3::round::unit_axis;
use crate::geometry::number::{are_numbers, is_moderate, is_number, is_regular};
use crate::scalar::{Mask, Maybe, Optional, Real, Select};
use crate::vga3::Vector;

/// A primitive to which points have a distance and onto which they are projected, also several in
/// lanes, since each type has one formula; the methods are those of [`Point`].
pub trait FromPoint<S: Real>: Copy {
    /// The least distance to a point.
    #[doc(hidden)]
    #[inline]
    fn distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
        self.signed_distance_from_point(point).map(S::abs)
    }

    /// The distance to a point, with a sign where this primitive has sides.
    #[doc(hidden)]
    fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S>;

    /// The nearest place to a point, if it is finite.
    #[doc(hidden)]
    fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S>;

    /// Whether a point is at most as far away as the tolerance allows.
    #[doc(hidden)]
    #[inline]
    fn is_near(self, point: Vector<S>, tolerance: Tolerance<S>) -> S::Mask {
        let distance = self.distance_from_point(point);
        distance.is_some_and(|distance| within(distance, tolerance.distance))
    }
}

impl<S: Real> FromPoint<S> for Point<S> {
    #[inline]
    fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
        let distance = Vector::from(self).distance(point);
        is_number(distance).when(distance)
    }

    #[inline]
    fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
        let place = Vector::from(self);
        (point.is_finite() & place.is_finite()).when(place)
    }
}

impl<S: Real> FromPoint<S> for FlatPoint<S> {
    #[inline]
    fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
        self.to_point()
            .and_then(|place| place.signed_distance_from_point(point))
    }

    #[inline]
    fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
        self.to_point().and_then(|place| place.nearest_place(point))
    }
}

impl<S: Real> FromPoint<S> for PointPair<S> {
    fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
        self.endpoints().and_then(|[p, q]| {
            let [to_p, to_q] = [p, q].map(|place| point.distance(place.into()));
            (to_p.is_finite() & to_q.is_finite()).when(to_p.min(to_q))
        })
    }

    fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
        self.endpoints().and_then(|ends| {
            let [p, q] = ends.map(Vector::from);
            let [to_p, to_q] = [p, q].map(|place| (point - place).length());
            let [x, y, z] = (p - q).coordinates();
            let is_one_point = x.is_zero() & y.is_zero() & z.is_zero();
            let is_p = to_p.less_than(to_q) | is_one_point;
            let is_unique = is_p | to_q.less_than(to_p);
            (is_unique & point.is_finite()).when(Vector::select(is_p, p, q))
        })
    }
}

impl<S: Real> FromPoint<S> for Line<S> {
    #[inline]
    fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
        self.distance(point.into())
    }

    #[inline]
    fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
        self.foot(point.into()).map(Vector::from)
    }
}

impl<S: Real> FromPoint<S> for Plane<S> {
    #[inline]
    fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
        self.signed_distance(point.into())
    }

    #[inline]
    fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
        self.moved_along_normal(point, S::one())
    }

    #[inline]
    fn is_near(self, point: Vector<S>, tolerance: Tolerance<S>) -> S::Mask {
        let (normal, number) = self.vectors();
        let square = normal.length_squared();
        let height = (normal.dot(point) - number).abs();
        let is_usual = is_regular(square) & is_moderate(height);
        let is_below = height.less_or_equal(tolerance.distance * square.sqrt());
        if is_usual.all() {
            return is_below;
        }
        let distance = self.distance_from_point(point);
        let is_within = distance.is_some_and(|distance| within(distance, tolerance.distance));
        (is_usual & is_below) | (!is_usual & is_within)
    }
}

impl<S: Real> FromPoint<S> for Circle<S> {
    fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
        let parts = circle_parts(self).zip(self.radius());
        parts.and_then(|((centre, normal, _), radius)| {
            let [distance, _] = from_circle(point - centre, normal, radius);
            (point.is_finite() & distance.is_finite()).when(distance)
        })
    }

    fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
        let parts = circle_parts(self).zip(self.radius());
        let place = parts.and_then(|((centre, normal, _), radius)| {
            let from = point - centre;
            let flat = from.across(normal);
            // A vector along the normal leaves only rounding error, which has no meaningful
            // direction.
            let is_off = (from.length() * parallel()).less_than(flat.length());
            let flat = Vector::select(is_off, flat, flat * S::zero());
            radius_towards(centre, flat, radius)
        });
        place.filter(|place| point.is_finite() & place.is_finite())
    }
}

impl<S: Real> FromPoint<S> for Sphere<S> {
    #[inline]
    fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
        self.centre()
            .zip(self.radius())
            .map(|(centre, radius)| Vector::from(centre).distance(point) - radius)
            .filter(|distance| is_number(*distance))
    }

    #[inline]
    fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
        self.centre()
            .zip(self.radius())
            .and_then(|(centre, radius)| {
                let centre = Vector::from(centre);
                radius_towards(centre, point - centre, radius)
            })
            .filter(|place| are_numbers(place.coordinates()))
    }
}

macro_rules! of_sums {
    ($($Sum:ident)*) => {$(
        impl<S: Real> FromPoint<S> for $Sum<S> {
            fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
                let (is_flat, flat, round) = self.flat_or_round();
                by_kind(
                    is_flat,
                    || flat.signed_distance_from_point(point),
                    || round.signed_distance_from_point(point),
                )
            }

            fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
                let (is_flat, flat, round) = self.flat_or_round();
                by_kind(
                    is_flat,
                    || flat.nearest_place(point),
                    || round.nearest_place(point),
                )
            }
        }
    )*};
}

of_sums!(Bivector Trivector Quadvector);

macro_rules! by_the_direct_form {
    ($($Dual:ident)*) => {$(
        impl<S: Real> FromPoint<S> for $Dual<S> {
            #[inline]
            fn signed_distance_from_point(self, point: Vector<S>) -> Maybe<S, S> {
                self.undual().signed_distance_from_point(point)
            }

            #[inline]
            fn nearest_place(self, point: Vector<S>) -> Maybe<Vector<S>, S> {
                self.undual().nearest_place(point)
            }
        }
    )*};
}

by_the_direct_form!(DualFlatPoint DualPointPair MotorGenerator DualPlane DualCircle DualSphere);

/// What the flat or the round gives that a sum is.
fn by_kind<M: Mask, T: Select<Mask = M>>(
    is_flat: M,
    of_flat: impl FnOnce() -> M::Maybe<T>,
    of_round: impl FnOnce() -> M::Maybe<T>,
) -> M::Maybe<T> {
    let flat = is_flat.when(()).and_then(|()| of_flat());
    flat.or_else(|| (!is_flat).when(()).and_then(|()| of_round()))
}

/// Centre, unit normal and squared radius, negative for an imaginary circle.
#[inline]
pub(super) fn circle_parts<S: Real>(circle: Circle<S>) -> Maybe<(Vector<S>, Vector<S>, S), S> {
    let parts = circle.centre().zip(circle.unit_normal());
    parts.map(|(centre, normal)| (centre.into(), normal.into(), circle.radius_squared))
}

/// The end of a radius in a direction; the centre itself where the radius is zero.
#[inline]
fn radius_towards<S: Real>(centre: Vector<S>, way: Vector<S>, radius: S) -> Maybe<Vector<S>, S> {
    radius
        .is_zero()
        .when(centre)
        .or_else_of((centre, way, radius), |(centre, way, radius)| {
            unit_axis(way.into()).map(|unit| centre + unit * radius)
        })
}
