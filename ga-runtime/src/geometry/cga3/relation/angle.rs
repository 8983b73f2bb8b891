//! Angles between primitives, in radians.
//!
//! `a.angle_to(b)` is the same as `b.angle_to(a)`. All are found by `atan2` from a sine and a
//! cosine, so that small angles and right ones keep their digits.
//!
//! - line, line: 0 to π; between the directions as oriented: `tan θ = ∣d × e∣ / d·e`.
//! - plane, plane; circle, circle; plane, circle: 0 to π; between the normals as oriented, of the
//!   planes of circles.
//! - line and plane or circle: −½π to ½π; between the line and the plane, positive where the
//!   direction leaves on the side of the normal.
//! - sphere and plane: 0 to π; between the inward normal of the sphere and the normal of the plane
//!   where they meet: `cos θ = h/r`, h the height of the centre.
//! - sphere, sphere: 0 to π; between both inward normals where they meet:
//!   `cos θ = (r² + s² − d²)/(2 r s)`.
//! - sphere and line or circle: 0 to ½π; between the curve and the tangent plane where they meet.
//!
//! The acute angle of two directions is `min(θ, π − θ)`. In blades, for unit directions, `cos θ` is
//! minus the scalar product `A ~B` of two lines or two planes in direct form, and `σ·τ / √(σ² τ²)`
//! of two dual spheres or planes.
//!
//! `None` where a sphere and the other do not meet, a sphere has radius zero, or one of the two is
//! no [`Figure`]. What spheres and planes have instead of an angle where they do not meet is the
//! [inversive distance](crate::cga3::Sphere::inversive_distance_to).
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

use super::{Figure, Primitive, hypotenuse, parallel};
use crate::cga3::{Circle, DualCircle, DualPlane, DualSphere, Line, MotorGenerator, Plane, Sphere};
use crate::scalar::Real;
use crate::vga3::Vector;

/// A primitive with extent, which can make an angle: a line, a plane, a circle, a sphere.
pub trait Extended<S>: Primitive<S> {}

impl<S: Real<Mask = bool>> Extended<S> for Line<S> {}
impl<S: Real<Mask = bool>> Extended<S> for Plane<S> {}
impl<S: Real<Mask = bool>> Extended<S> for Circle<S> {}
impl<S: Real<Mask = bool>> Extended<S> for Sphere<S> {}
impl<S: Real<Mask = bool>> Extended<S> for MotorGenerator<S> {}
impl<S: Real<Mask = bool>> Extended<S> for DualPlane<S> {}
impl<S: Real<Mask = bool>> Extended<S> for DualCircle<S> {}
impl<S: Real<Mask = bool>> Extended<S> for DualSphere<S> {}

macro_rules! angles {
    ($($Primitive:ident)*) => {$(
        impl<S: Real<Mask = bool>> $Primitive<S> {
            /// The angle to the other primitive in radians; see
            /// [`angle`](crate::geometry::relation::angle) for all pairs. `None` where a sphere and
            /// the other do not meet, by more than rounding, or either is not a figure.
            #[must_use]
            pub fn angle_to<T: Extended<S>>(self, other: T) -> Option<S> {
                angle(self.figure()?, other.figure()?)
            }
        }
    )*};
}

angles!(Line Plane Circle Sphere MotorGenerator DualPlane DualCircle DualSphere);

macro_rules! inversive_distances {
    ($($Primitive:ident)*) => {$(
        impl<S: Real<Mask = bool>> $Primitive<S> {
            /// The invariant `σ·τ / √(σ² τ²)` of two dual spheres or planes:
            /// `(r² + s² − d²)/(2 r s)` of spheres with radii r, s and centres d apart, `h/r` of a
            /// sphere and a plane that its centre is h above, `n·m` of planes. Spheres count as of
            /// positive weight, by their inward normals, planes by their normals as oriented.
            /// Conformal maps keep it up to sign: an inversion may turn a sphere inside out.
            ///
            /// It is the cosine of the [angle](Self::angle_to) where they meet, 1 or −1 where they
            /// touch from within or from without, above 1 for a sphere inside another or on the
            /// side of a plane's normal, and below −1 for two that are apart. Coxeter's inversive
            /// distance (Annali di Matematica 71, 1966) is the inverse hyperbolic cosine of its
            /// size. `None` where a radius is zero, either is a line or a circle or no figure, or
            /// it is beyond the range of the scalar.
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
            pub fn inversive_distance_to<T: Extended<S>>(self, other: T) -> Option<S> {
                inversive_distance(self.figure()?, other.figure()?)
            }
        }
    )*};
}

inversive_distances!(Plane Sphere DualPlane DualSphere);

fn angle<S: Real<Mask = bool>>(a: Figure<S>, b: Figure<S>) -> Option<S> {
    use Figure::{Circle, Line, Plane, Sphere};
    let between = |u: Vector<S>, v: Vector<S>| u.cross(v).length().atan2(u.dot(v));
    let found = match (a, b) {
        (Line { direction: u, .. }, Line { direction: v, .. })
        | (
            Plane { normal: u, .. } | Circle { normal: u, .. },
            Plane { normal: v, .. } | Circle { normal: v, .. },
        ) => between(u, v),
        (Line { direction, .. }, Plane { normal, .. } | Circle { normal, .. })
        | (Plane { normal, .. } | Circle { normal, .. }, Line { direction, .. }) => direction
            .dot(normal)
            .atan2(direction.cross(normal).length()),
        (Sphere { centre, radius }, Plane { normal, distance })
        | (Plane { normal, distance }, Sphere { centre, radius }) => {
            let height = centre.dot(normal) - distance;
            let chord = half_chord(height, radius, rounding(centre, radius))?;
            chord.atan2(height)
        }
        (Sphere { centre, radius }, Line { point, direction })
        | (Line { point, direction }, Sphere { centre, radius }) => {
            let height = (centre - point).across(direction).length();
            let chord = half_chord(height, radius, rounding(centre, radius))?;
            chord.atan2(height)
        }
        (
            Sphere {
                centre: c,
                radius: r,
            },
            Sphere { centre, radius },
        ) => {
            let sides = [(centre - c).length(), r, radius];
            let area = heron(sides, rounding(c, r) + rounding(centre, radius))?;
            let unit = sides[0].max(r).max(radius);
            if !S::zero().less_than(r) || !S::zero().less_than(radius) {
                return None;
            }
            let [d, r, s] = sides.map(|x| x / unit);
            area.atan2(r * r + s * s - d * d)
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
        ) => sphere_and_circle([c, centre], normal, [r, radius])?,
        (Figure::Point(_) | Figure::PointPair(_), _)
        | (_, Figure::Point(_) | Figure::PointPair(_)) => return None,
    };
    found.is_finite().then_some(found)
}

/// The angle of a sphere and a circle, by their centres, the normal of the circle and their radii.
fn sphere_and_circle<S: Real<Mask = bool>>(
    [c, centre]: [Vector<S>; 2],
    normal: Vector<S>,
    [r, radius]: [S; 2],
) -> Option<S> {
    let from = c - centre;
    let height = from.dot(normal);
    // The plane of the circle cuts the sphere in a circle of this radius, and the two circles meet.
    let rounded = rounding(c, r) + rounding(centre, radius);
    let cut = half_chord(height, r, rounded)?;
    let between = from.across(normal).length();
    let sides = [between, radius, cut];
    let area = heron(sides, rounded)?;
    let unit = between.max(radius).max(cut);
    if !S::zero().less_than(radius) {
        return None;
    }
    let [d, q, s] = sides.map(|x| x / unit);
    let cosine = hypotenuse(q * q + s * s - d * d, (q + q) * (height / unit));
    Some(area.atan2(cosine))
}

fn inversive_distance<S: Real<Mask = bool>>(a: Figure<S>, b: Figure<S>) -> Option<S> {
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
        _ => return None,
    };
    found.is_finite().then_some(found)
}

/// The length whose ε bounds by how much a radius and a centre are rounded: a blade knows the
/// radius by its square beside that of the centre's distance from the origin.
fn rounding<S: Real<Mask = bool>>(centre: Vector<S>, radius: S) -> S {
    let distance = centre.length();
    radius + distance + distance * (distance / radius)
}

/// Half the chord that a sphere cuts off at a height from its centre; `None` where it does not
/// reach so far, or has no radius.
fn half_chord<S: Real<Mask = bool>>(height: S, radius: S, rounding: S) -> Option<S> {
    let short = slack(radius - height.abs(), rounding)?;
    let usable = S::zero().less_than(radius);
    usable.then(|| short.sqrt() * (radius + height.abs()).sqrt())
}

/// Four times the area of a triangle in units of its longest side squared, by Heron's formula;
/// `None` where the sides make none, or two of them vanish.
fn heron<S: Real<Mask = bool>>(sides: [S; 3], rounding: S) -> Option<S> {
    let unit = sides[0].max(sides[1]).max(sides[2]);
    if !S::zero().less_than(unit) {
        return None;
    }
    let [a, b, c] = sides.map(|x| x / unit);
    let size = S::one() + rounding / unit;
    let product = slack(b + c - a, size)? * slack(c + a - b, size)? * slack(a + b - c, size)?;
    Some((product * (a + b + c)).sqrt())
}

/// A number that is negative by rounding only, raised to zero.
fn slack<S: Real<Mask = bool>>(x: S, size: S) -> Option<S> {
    let is_off = x.less_than(-(size * parallel::<S>()));
    (!is_off).then(|| x.max(S::zero()))
}
