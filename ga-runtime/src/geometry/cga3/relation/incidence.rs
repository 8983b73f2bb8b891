//! Incidence: whether one primitive lies on another, within a tolerance.
//!
//! `a.is_on(b, tolerance)` tests whether every point of a is a point of b. In blades a point x is
//! on a direct X where `x∧X = 0`; here the distance is measured, so that the tolerance has the
//! units of the coordinates and the weights of the blades do not matter.
//!
//! The following must be within the tolerance:
//!
//! - Point a on any b: the distance.
//! - Point pair a on any b: the distance of both points.
//! - Line a on a line or plane, plane a on a plane: the angle, and the distance at the point of a
//!   nearest to the origin.
//! - Circle a on a plane or sphere: the distance of its farthest point.
//! - Circle on circle: the distance of the centres, the difference of the radii, and the radius
//!   times the sine of the angle between the planes.
//! - Sphere on sphere: the distance of the centres and the difference of the radii.
//!
//! All other pairs are never incident, with one exception: a circle or a sphere whose radius is
//! within the tolerance is treated as its centre. Whatever is not a [`Figure`] is on nothing, and
//! nothing is on it.
//!
//! ```
//! use ga_runtime::cga3::{Circle, Plane, Point, Sphere};
//! use ga_runtime::geometry::relation::Tolerance;
//!
//! let tolerance = Tolerance::default();
//! let [p, q, r] = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-2.0, 0.0, 0.0]].map(Point::from);
//! let circle = Circle::through(p, q, r);
//! let sphere = Sphere::from_centre_radius(Point::new(0.0, 0.0, 1.5), 2.5);
//! assert!(p.is_on(circle, tolerance));
//! assert!(circle.is_on(sphere, tolerance) && circle.is_on(Plane::through(p, q, r), tolerance));
//! assert!(!circle.is_on(Sphere::from_centre_radius(p, 2.0), tolerance));
//! ```

use super::figure_incidence::is_on;
use super::tolerance::angle_within;
use super::{Figure, FromPoint, Primitive, Tolerance};
use crate::cga3::{
    Bivector, Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint,
    Line, MotorGenerator, Plane, Point, PointPair, Quadvector, Sphere, Trivector,
};
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

/// A primitive with a direction: a line, a plane by its normal, a circle by the normal of its
/// plane.
pub trait Directed<S: Real>: Primitive<S> {}

impl<S: Real> Directed<S> for Line<S> {}
impl<S: Real> Directed<S> for Plane<S> {}
impl<S: Real<Mask = bool>> Directed<S> for Circle<S> {}
impl<S: Real> Directed<S> for MotorGenerator<S> {}
impl<S: Real> Directed<S> for DualPlane<S> {}
impl<S: Real<Mask = bool>> Directed<S> for DualCircle<S> {}

macro_rules! incidence {
    ($($Primitive:ident)*) => {$(
        impl<S: Real> $Primitive<S> {
            /// Whether this and the other primitive are the same set of points, each
            /// [on](Self::is_on) the other; orientation and weight are ignored. False where either
            /// is not a figure.
            #[must_use]
            pub fn coincides_with<T: Primitive<S>>(self, other: T, tolerance: Tolerance<S>) -> S::Mask
            where
                Self: Primitive<S>,
            {
                self.figure().is_some_and(|a| {
                    other.figure().is_some_and(|b| {
                        let on_other = is_on(a, b, tolerance).when(());
                        on_other.is_some_and(|()| is_on(b, a, tolerance))
                    })
                })
            }
        }
    )*};
}

macro_rules! contained {
    ($($Primitive:ident)*) => {$(
        impl<S: Real> $Primitive<S> {
            /// Whether every point of this primitive is a point of the other, within the tolerance;
            /// see [`incidence`](crate::geometry::relation::incidence). False where either is no
            /// figure.
            #[inline]
            #[must_use]
            pub fn is_on<T: Primitive<S>>(self, other: T, tolerance: Tolerance<S>) -> S::Mask
            where
                Self: Primitive<S>,
            {
                Primitive::lies_on(self, other, tolerance)
            }
        }
    )*};
}

impl<S: Real> Point<S> {
    /// Whether this point is a point of the other primitive, within the tolerance; see
    /// [`incidence`](crate::geometry::relation::incidence). False where either is not a figure.
    #[inline]
    #[must_use]
    pub fn is_on<T: FromPoint<S>>(self, other: T, tolerance: Tolerance<S>) -> S::Mask {
        other.is_near(self.into(), tolerance)
    }
}

macro_rules! attitude {
    ($($Primitive:ident)*) => {$(
        impl<S: Real> $Primitive<S> {
            /// Whether the angle to the other is zero within `tolerance.angle`, ignoring
            /// orientation. Lines, planes and the planes of circles are compared; primitives that
            /// coincide are parallel too. False where either is not a figure.
            #[must_use]
            pub fn is_parallel_to<T: Directed<S>>(self, other: T, tolerance: Tolerance<S>) -> S::Mask
            where
                Self: Directed<S>,
            {
                let slope = self.figure().zip(other.figure()).and_then(|(a, b)| slope(a, b));
                slope.is_some_and(|[sine, cosine]| angle_within(sine, cosine, tolerance.angle))
            }

            /// Whether the angle to the other is a right angle within `tolerance.angle`. Lines,
            /// planes and the planes of circles are compared; they need not meet. False where
            /// either is not a figure.
            #[must_use]
            pub fn is_perpendicular_to<T: Directed<S>>(self, other: T, tolerance: Tolerance<S>) -> S::Mask
            where
                Self: Directed<S>,
            {
                let slope = self.figure().zip(other.figure()).and_then(|(a, b)| slope(a, b));
                slope.is_some_and(|[sine, cosine]| angle_within(cosine, sine, tolerance.angle))
            }
        }
    )*};
}

incidence! {
    Point FlatPoint PointPair Line Plane Circle Sphere Bivector Trivector Quadvector
    DualFlatPoint DualPointPair MotorGenerator DualPlane DualCircle DualSphere
}
contained! {
    FlatPoint PointPair Line Plane Circle Sphere Bivector Trivector Quadvector
    DualFlatPoint DualPointPair MotorGenerator DualPlane DualCircle DualSphere
}
attitude!(Line Plane Circle MotorGenerator DualPlane DualCircle);

/// Sine and cosine, neither negative, of the acute angle between two directed figures.
fn slope<S: Real>(a: Figure<S>, b: Figure<S>) -> Maybe<[S; 2], S> {
    let (Some((u, u_is_normal)), Some((v, v_is_normal))) = (direction(a), direction(b)) else {
        return S::Mask::splat(false).when([S::zero(); 2]);
    };
    let [sine, cosine] = [u.cross(v).length(), u.dot(v).abs()];
    S::Mask::splat(true).when(if u_is_normal == v_is_normal {
        [sine, cosine]
    } else {
        [cosine, sine]
    })
}

/// The direction of a figure, or its normal, and whether it is a normal.
fn direction<S>(figure: Figure<S>) -> Option<(Vector<S>, bool)> {
    match figure {
        Figure::Line { direction, .. } => Some((direction, false)),
        Figure::Plane { normal, .. } | Figure::Circle { normal, .. } => Some((normal, true)),
        Figure::Point(_) | Figure::PointPair(_) | Figure::Sphere { .. } => None,
    }
}
