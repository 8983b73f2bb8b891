//! Primitives as plain Euclidean figures.

use crate::cga3::Sphere;
use crate::geometry::number::is_moderate;
use crate::scalar::{Maybe, Optional, Real};
use crate::vga3::Vector;

/// A primitive as a set of points of space, given by position vectors and directions. All numbers
/// are finite, directions and normals have length 1, radii are not negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Figure<S> {
    /// One point.
    Point(Vector<S>),
    /// The two points of a pair, as in `p∧q`.
    PointPair([Vector<S>; 2]),
    /// A line.
    Line {
        /// Its point nearest to the origin.
        point: Vector<S>,
        /// Its direction.
        direction: Vector<S>,
    },
    /// The plane of the points x with `n·x = d`.
    Plane {
        /// The normal n.
        normal: Vector<S>,
        /// The distance d.
        distance: S,
    },
    /// A circle.
    Circle {
        /// Its centre.
        centre: Vector<S>,
        /// The normal of its plane; seen from its tip, the circle runs counterclockwise.
        normal: Vector<S>,
        /// Its radius.
        radius: S,
    },
    /// A sphere.
    Sphere {
        /// Its centre.
        centre: Vector<S>,
        /// Its radius.
        radius: S,
    },
}

/// Centre and squared radius, negative for an imaginary sphere.
#[inline]
pub(super) fn sphere_parts<S: Real>(sphere: Sphere<S>) -> Maybe<(Vector<S>, S), S> {
    let centre = sphere.centre();
    centre.map(|centre| (centre.into(), sphere.radius_squared))
}

/// The same where the centre and the radius are so far from both ends of the range of the scalar
/// that sums and products of their squares are accurate. `None` elsewhere, and for an imaginary
/// sphere.
#[inline(always)]
pub(super) fn regular_sphere<S: Real<Mask = bool>>(sphere: Sphere<S>) -> Option<(Vector<S>, S)> {
    let (centre, squared) = (Vector::from(sphere.centre), sphere.radius_squared);
    let is_regular = S::from_f64(1e-24).less_than(squared)
        & is_moderate(centre.length_squared() + squared)
        & (sphere.weight != S::zero());
    is_regular.then_some((centre, squared))
}
