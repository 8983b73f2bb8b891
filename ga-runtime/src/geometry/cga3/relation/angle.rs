//! Angles between primitives, in radians.
//!
//! `a.angle_to(b)` is the same as `b.angle_to(a)`. Every angle is computed by `atan2` from a sine
//! and a cosine, so that angles near zero and near a right angle are accurate.
//!
//! - Line and line: 0 to π, between the directions as oriented, `tan θ = ∣d × e∣ / d·e`.
//! - Plane and plane, plane and circle: 0 to π, between the normals as oriented; the normal of a
//!   circle is that of its plane.
//! - Circle and circle: two angles, [`CircleAngles`].
//! - Line and plane or circle: −½π to ½π, between the line and the plane, positive where the
//!   direction points to the side of the normal.
//! - Sphere and plane: 0 to π, between the inward normal of the sphere and the normal of the plane
//!   where they meet, `cos θ = h/r` with h the height of the centre.
//! - Sphere and sphere: 0 to π, between both inward normals where they meet,
//!   `cos θ = (r² + s² − d²)/(2 r s)`.
//! - Sphere and line or circle: 0 to ½π, between the curve and the tangent plane where they meet.
//!
//! The acute angle of two directions is `min(θ, π − θ)`. In blades, for unit directions, `cos θ` is
//! minus the scalar product `A ~B` of two lines or two planes in direct form, and it is
//! `σ·τ / √(σ² τ²)` for two dual spheres or planes.
//!
//! The result is `None` where a sphere and the other primitive do not meet, where a sphere has
//! radius zero, or where one of the two is not a [`Figure`]. For spheres and planes that do not
//! meet, the [inversive distance](crate::cga3::Sphere::inversive_distance_to) takes the place of
//! the angle.
//!
//! ```
//! use ga_runtime::cga3::{Line, Plane, Point, Sphere};
//! use std::f64::consts::PI;
//!
//! let o = Point::default();
//! let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! assert_eq!(
//!     Line::from_point_direction(o, x).angle_to(Line::from_point_direction(o, y)),
//!     Some(PI / 2.0)
//! );
//! let ground = Plane::from_point_normal(o, [0.0, 0.0, 1.0]);
//! let falling: f64 = Line::from_point_direction(o, [1.0, 0.0, -1.0])
//!     .angle_to(ground)
//!     .unwrap();
//! assert!((falling + PI / 4.0).abs() < 1e-15);
//! // Orthogonal spheres.
//! let (a, b) = (
//!     Sphere::from_centre_radius(o, 3.0),
//!     Sphere::from_centre_radius(Point::new(5.0, 0.0, 0.0), 4.0),
//! );
//! assert_eq!(a.angle_to(b), Some(PI / 2.0));
//! ```

use super::circle_angles::circle_angles;
use super::tolerance::rounding;
use super::{CircleAngles, Figure, Primitive, hypotenuse, parallel};
use crate::cga3::{Circle, DualCircle, DualPlane, DualSphere, Line, MotorGenerator, Plane, Sphere};
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

/// A primitive with extent, between which angles are defined: a line, a plane, a circle or a
/// sphere.
pub trait Extended<S: Real>: Primitive<S> {
    /// The angle between the primitive and a circle: one number, or the [`CircleAngles`] of two
    /// circles.
    type ToCircle;

    /// The angle between two figures, the first of which is a circle and the second this primitive.
    #[doc(hidden)]
    fn angle_to_circle(circle: Figure<S>, figure: Figure<S>) -> Maybe<Self::ToCircle, S>;

    /// What is needed for angles of a line or a plane; `None` for types that do not know it without
    /// their figure.
    #[doc(hidden)]
    #[inline]
    fn attitude_and_size(self) -> Option<AttitudeAndSize<S>> {
        None
    }
}

macro_rules! one_angle {
    ($($Primitive:ident)*) => {$(
        impl<S: Real> Extended<S> for $Primitive<S> {
            type ToCircle = S;
            fn angle_to_circle(circle: Figure<S>, figure: Figure<S>) -> Maybe<S, S> {
                angle(circle, figure)
            }
        }
    )*};
}

one_angle!(Sphere MotorGenerator DualPlane DualSphere);

macro_rules! two_angles {
    ($($Circle:ident)*) => {$(
        impl<S: Real<Mask = bool>> Extended<S> for $Circle<S> {
            type ToCircle = CircleAngles<S>;
            fn angle_to_circle(circle: Figure<S>, figure: Figure<S>) -> Option<CircleAngles<S>> {
                circle_angles(circle, figure)
            }
        }

        impl<S: Real<Mask = bool>> $Circle<S> {
            /// The angle to the other primitive in radians; see
            /// [`angle`](crate::geometry::relation::angle) for all pairs. For another circle these
            /// are the two [`CircleAngles`]. `None` where a sphere and the circle do not meet,
            /// beyond what rounding explains, where one of two circles has radius zero, or where
            /// either is not a figure.
            #[must_use]
            pub fn angle_to<T: Extended<S>>(self, other: T) -> Option<T::ToCircle> {
                T::angle_to_circle(self.figure()?, other.figure()?)
            }
        }
    )*};
}

two_angles!(Circle DualCircle);

impl<S: Real> Extended<S> for Line<S> {
    type ToCircle = S;

    fn angle_to_circle(circle: Figure<S>, figure: Figure<S>) -> Maybe<S, S> {
        angle(circle, figure)
    }

    #[inline]
    fn attitude_and_size(self) -> Option<AttitudeAndSize<S>> {
        let (direction, moment) = self.vectors();
        Some(AttitudeAndSize {
            vector: direction,
            is_normal: false,
            size: moment.length_squared(),
        })
    }
}

impl<S: Real> Extended<S> for Plane<S> {
    type ToCircle = S;

    fn angle_to_circle(circle: Figure<S>, figure: Figure<S>) -> Maybe<S, S> {
        angle(circle, figure)
    }

    #[inline]
    fn attitude_and_size(self) -> Option<AttitudeAndSize<S>> {
        let (normal, number) = self.vectors();
        Some(AttitudeAndSize {
            vector: normal,
            is_normal: true,
            size: number * number,
        })
    }
}

macro_rules! angles {
    ($($Primitive:ident)*) => {$(
        impl<S: Real> $Primitive<S> {
            /// The angle to the other primitive in radians; see
            /// [`angle`](crate::geometry::relation::angle) for all pairs. `None` where a sphere and
            /// the other do not meet, beyond what rounding explains, or where either is not a
            /// figure.
            #[inline]
            #[must_use]
            pub fn angle_to<T: Extended<S>>(self, other: T) -> Maybe<S, S> {
                match (self.attitude_and_size(), other.attitude_and_size()) {
                    (Some(a), Some(b)) => angle_of_directions(a, b)
                        .or_else_of((self, other), |(a, b)| angle_of_figures(a, b)),
                    _ => angle_of_figures(self, other),
                }
            }
        }
    )*};
}

angles!(Line Plane Sphere MotorGenerator DualPlane DualSphere);

macro_rules! inversive_distances {
    ($($Primitive:ident)*) => {$(
        impl<S: Real> $Primitive<S> {
            /// The invariant `σ·τ / √(σ² τ²)` of two dual spheres or planes:
            /// `(r² + s² − d²)/(2 r s)` for spheres with radii r and s whose centres are at a
            /// distance d, `h/r` for a sphere of radius r whose centre is at a height h above a
            /// plane, `n·m` for planes with normals n and m. Spheres are taken with positive
            /// weight, that is with inward normals, and planes with their normals as oriented.
            /// Conformal maps preserve it up to sign: an inversion may exchange the inside and the
            /// outside of a sphere.
            ///
            /// It is the cosine of the [angle](Self::angle_to) where they meet, 1 or −1 where they
            /// touch from the inside or from the outside, above 1 for a sphere inside another or on
            /// the side of a plane's normal, and below −1 for two that are apart. Coxeter's
            /// inversive distance (Annali di Matematica 71, 1966) is the inverse hyperbolic cosine
            /// of its absolute value. `None` where a radius is zero, where either is a line, a
            /// circle or not a figure, or where the result is beyond the range of the scalar.
            ///
            /// ```
            /// use ga_runtime::cga3::{Point, Sphere};
            /// let a = Sphere::from_centre_radius(Point::default(), 1.0);
            /// let apart = Sphere::from_centre_radius(Point::new(4.0, 0.0, 0.0), 2.0);
            /// assert_eq!(a.inversive_distance_to(apart), Some(-2.75));
            /// let around = Sphere::from_centre_radius(Point::default(), 2.0);
            /// assert_eq!(a.inversive_distance_to(around), Some(1.25));
            /// ```
            #[must_use]
            pub fn inversive_distance_to<T: Extended<S>>(self, other: T) -> Maybe<S, S> {
                let figures = self.figure().zip(other.figure());
                figures.and_then(|(a, b)| inversive_distance(a, b))
            }
        }
    )*};
}

inversive_distances!(Plane Sphere DualPlane DualSphere);

/// A direction or a normal of any length, and the square of the other numbers.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct AttitudeAndSize<S> {
    vector: Vector<S>,
    is_normal: bool,
    size: S,
}

/// The angle of two directions of any length; `None` where they are nearly parallel or a number is
/// large, in which case one of them may be no figure.
#[inline]
fn angle_of_directions<S: Real>(a: AttitudeAndSize<S>, b: AttitudeAndSize<S>) -> Maybe<S, S> {
    let (u, v) = (a.vector, b.vector);
    let (across, along) = (u.cross(v).length_squared(), u.dot(v));
    // A cross product that is not small shows that none of both vectors is.
    let squares = u.length_squared() + v.length_squared();
    let is_regular = S::from_f64(1e-12).less_than(across)
        & squares.less_than(S::from_f64(1e12))
        & (a.size + b.size).less_than(S::from_f64(1e24));
    let angle = || {
        let (sine, size) = (across.sqrt(), (across + along * along).sqrt());
        if a.is_normal != b.is_normal {
            return along.atan2(sine);
        }
        // The acute angle, by the polynomial for half of the angle of a rotation.
        let inverse = size.recip();
        let (by_sine, _) = (along.abs() * inverse).angle_by_sine();
        // Rounding of the polynomial must not make it obtuse.
        let acute = (by_sine * (sine * inverse)).min(S::from_f64(core::f64::consts::FRAC_PI_2));
        S::select(
            along.less_than(S::zero()),
            S::from_f64(core::f64::consts::PI) - acute,
            acute,
        )
    };
    is_regular.when(()).map(|()| angle())
}

fn angle_of_figures<S: Real, A: Primitive<S>, B: Primitive<S>>(a: A, b: B) -> Maybe<S, S> {
    a.figure().zip(b.figure()).and_then(|(a, b)| angle(a, b))
}

#[inline(never)]
fn angle<S: Real>(a: Figure<S>, b: Figure<S>) -> Maybe<S, S> {
    use Figure::{Circle, Line, Plane, Sphere};
    let between = |u: Vector<S>, v: Vector<S>| u.cross(v).length().atan2(u.dot(v));
    let always = S::Mask::splat(true);
    match (a, b) {
        (Line { direction: u, .. }, Line { direction: v, .. })
        | (
            Plane { normal: u, .. } | Circle { normal: u, .. },
            Plane { normal: v, .. } | Circle { normal: v, .. },
        ) => always.when(between(u, v)),
        (Line { direction, .. }, Plane { normal, .. } | Circle { normal, .. })
        | (Plane { normal, .. } | Circle { normal, .. }, Line { direction, .. }) => {
            let sine = direction.dot(normal);
            always.when(sine.atan2(direction.cross(normal).length()))
        }
        (Sphere { centre, radius }, Plane { normal, distance })
        | (Plane { normal, distance }, Sphere { centre, radius }) => {
            let height = centre.dot(normal) - distance;
            half_chord(height, radius, rounding(centre, radius)).map(|chord| chord.atan2(height))
        }
        (Sphere { centre, radius }, Line { point, direction })
        | (Line { point, direction }, Sphere { centre, radius }) => {
            let height = (centre - point).across(direction).length();
            half_chord(height, radius, rounding(centre, radius)).map(|chord| chord.atan2(height))
        }
        (
            Sphere {
                centre: c,
                radius: r,
            },
            Sphere { centre, radius },
        ) => {
            let sides = [(centre - c).length(), r, radius];
            let area = heron(sides, rounding(c, r) + rounding(centre, radius));
            let have_size = S::zero().less_than(r) & S::zero().less_than(radius);
            let unit = sides[0].max(r).max(radius);
            let [d, r, s] = sides.map(|x| x / unit);
            area.map(|area| area.atan2(r * r + s * s - d * d))
                .filter(|_| have_size)
        }
        (
            Sphere {
                centre: c,
                radius: r,
            },
            Circle {
                centre,
                normal,
                radius,
            },
        )
        | (
            Circle {
                centre,
                normal,
                radius,
            },
            Sphere {
                centre: c,
                radius: r,
            },
        ) => sphere_and_circle([c, centre], normal, [r, radius]),
        (Figure::Point(_) | Figure::PointPair(_), _)
        | (_, Figure::Point(_) | Figure::PointPair(_)) => S::Mask::splat(false).when(S::zero()),
    }
    .filter(|angle| angle.is_finite())
}

/// The angle of a sphere and a circle, by their centres, the normal of the circle and their radii.
fn sphere_and_circle<S: Real>(
    [c, centre]: [Vector<S>; 2],
    normal: Vector<S>,
    [r, radius]: [S; 2],
) -> Maybe<S, S> {
    let from = c - centre;
    let height = from.dot(normal);
    // The plane of the circle intersects the sphere in a circle of this radius, and the two circles
    // meet.
    let rounded = rounding(c, r) + rounding(centre, radius);
    let between = from.across(normal).length();
    let angle = half_chord(height, r, rounded).and_then(|cut| {
        let sides = [between, radius, cut];
        let unit = between.max(radius).max(cut);
        let [d, q, s] = sides.map(|x| x / unit);
        heron(sides, rounded).map(|area| {
            let cosine = hypotenuse(q * q + s * s - d * d, (q + q) * (height / unit));
            area.atan2(cosine)
        })
    });
    angle.filter(|_| S::zero().less_than(radius))
}

fn inversive_distance<S: Real>(a: Figure<S>, b: Figure<S>) -> Maybe<S, S> {
    use Figure::{Plane, Sphere};
    let found = match (a, b) {
        (Plane { normal, .. }, Plane { normal: m, .. }) => normal.dot(m),
        (Sphere { centre, radius }, Plane { normal, distance })
        | (Plane { normal, distance }, Sphere { centre, radius }) => {
            (centre.dot(normal) - distance) / radius
        }
        (
            Sphere {
                centre: c,
                radius: r,
            },
            Sphere { centre, radius },
        ) => {
            let d = (centre - c).length();
            // (r² + s² − d²)/(2 r s) = 1 − (d − r + s)(d + r − s)/(2 r s).
            let cut = ((d - r + radius) / r) * ((d + r - radius) / radius);
            S::one() - cut * S::from_ratio(1, 2)
        }
        _ => return S::Mask::splat(false).when(S::zero()),
    };
    found.is_finite().when(found)
}

/// Half the length of the chord of a sphere at a height from its centre; `None` where the height is
/// beyond the radius, or the radius is zero.
fn half_chord<S: Real>(height: S, radius: S, rounding: S) -> Maybe<S, S> {
    slack(radius - height.abs(), rounding)
        .filter(|_| S::zero().less_than(radius))
        .map(|short| short.sqrt() * (radius + height.abs()).sqrt())
}

/// Four times the area of a triangle in units of its longest side squared, by Heron's formula;
/// `None` where no triangle has these sides. It is NaN where all of them vanish.
fn heron<S: Real>(sides: [S; 3], rounding: S) -> Maybe<S, S> {
    let unit = sides[0].max(sides[1]).max(sides[2]);
    let [a, b, c] = sides.map(|x| x / unit);
    let size = S::one() + rounding / unit;
    let [first, second, third] = [b + c - a, c + a - b, a + b - c].map(|x| slack(x, size));
    first
        .zip(second)
        .zip(third)
        .map(|((x, y), z)| (x * y * z * (a + b + c)).sqrt())
}

/// The number, or zero where it is negative by rounding only.
fn slack<S: Real>(x: S, size: S) -> Maybe<S, S> {
    let is_off = x.less_than(-(size * parallel::<S>()));
    (!is_off).when(x.max(S::zero()))
}
