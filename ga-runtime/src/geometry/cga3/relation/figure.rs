//! Primitives as plain Euclidean figures.

use super::distance::{distance, signed_distance};
use super::from_point::circle_parts;
use super::incidence::is_on;
use super::{FromPoint, Tolerance, parallel};
use crate::Element;
use crate::cga3::{
    Bivector, Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint,
    Line, MotorGenerator, Plane, Point, PointPair, Quadvector, Sphere, Trivector,
};
use crate::geometry::cga3::round::radius;
use crate::geometry::number::{is_moderate, is_number, is_regular};
use crate::scalar::Real;
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

/// A primitive that can be converted to a [`Figure`].
pub trait Primitive<S: Real>: FromPoint<S> {
    /// The figure; `None` for weight zero, imaginary points or radii, and numbers that are not
    /// finite.
    ///
    /// A round element whose weight is exactly zero is flat and is converted as such: a sphere to a
    /// plane, a circle to a line, a point pair to its finite point.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Point};
    /// use ga_runtime::geometry::relation::{Figure, Primitive};
    /// use ga_runtime::vga3::Vector;
    /// let line = Line::through(Point::new(1.0, 2.0, 0.0), Point::new(5.0, 2.0, 0.0));
    /// let (point, direction) = (Vector::new(0.0, 2.0, 0.0), Vector::new(1.0, 0.0, 0.0));
    /// let figure = Figure::Line { point, direction };
    /// assert_eq!(line.figure(), Some(figure));
    /// ```
    fn figure(self) -> Option<Figure<S>>;

    /// The least distance to a line.
    #[doc(hidden)]
    #[inline]
    fn distance_from_line(self, line: Line<S>) -> Option<S>
    where
        S: Real<Mask = bool>,
    {
        distance(line.figure()?, self.figure()?)
    }

    /// The least distance to another primitive.
    #[doc(hidden)]
    #[inline]
    fn distance_from<T: Primitive<S>>(self, other: T) -> Option<S>
    where
        S: Real<Mask = bool>,
    {
        distance(self.figure()?, other.figure()?)
    }

    /// The distance to another primitive, with a sign where one of them has sides.
    #[doc(hidden)]
    #[inline]
    fn signed_distance_from<T: Primitive<S>>(self, other: T) -> Option<S>
    where
        S: Real<Mask = bool>,
    {
        signed_distance(self.figure()?, other.figure()?)
    }

    /// Whether all of this primitive is on the other.
    #[doc(hidden)]
    #[inline]
    fn lies_on<T: Primitive<S>>(self, other: T, tolerance: Tolerance<S>) -> bool
    where
        S: Real<Mask = bool>,
    {
        match (self.figure(), other.figure()) {
            (Some(a), Some(b)) => is_on(a, b, tolerance),
            _ => false,
        }
    }
}

#[inline]
fn finite<S: Real<Mask = bool>>(point: Vector<S>) -> Option<Figure<S>> {
    point.is_finite().then_some(Figure::Point(point))
}

impl<S: Real<Mask = bool>> Primitive<S> for Point<S> {
    #[inline]
    fn figure(self) -> Option<Figure<S>> {
        finite(self.into())
    }

    #[inline]
    fn distance_from_line(self, line: Line<S>) -> Option<S> {
        line.distance_from_point(self.into())
    }

    #[inline]
    fn distance_from<T: Primitive<S>>(self, other: T) -> Option<S> {
        other.distance_from_point(self.into())
    }

    #[inline]
    fn signed_distance_from<T: Primitive<S>>(self, other: T) -> Option<S> {
        other.signed_distance_from_point(self.into())
    }

    #[inline]
    fn lies_on<T: Primitive<S>>(self, other: T, tolerance: Tolerance<S>) -> bool {
        other.is_near(self.into(), tolerance)
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for FlatPoint<S> {
    #[inline]
    fn figure(self) -> Option<Figure<S>> {
        self.to_point()?.figure()
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for PointPair<S> {
    fn figure(self) -> Option<Figure<S>> {
        let [p, q] = self.endpoints()?.map(Vector::from);
        Some(if p == q {
            Figure::Point(p)
        } else {
            Figure::PointPair([p, q])
        })
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for Line<S> {
    #[inline]
    fn figure(self) -> Option<Figure<S>> {
        let (point, direction) = self.parts()?;
        Some(Figure::Line { point, direction })
    }

    #[inline]
    fn distance_from_line(self, line: Self) -> Option<S> {
        let (d, m) = self.vectors();
        let (e, n) = line.vectors();
        let normal = d.cross(e);
        let (square, product) = (
            normal.length_squared(),
            d.length_squared() * e.length_squared(),
        );
        // The sine of the angle, times the lengths of both directions, against the bound below
        // which they are treated as parallel.
        let bound = parallel::<S>() * parallel::<S>() * product;
        if is_regular(square) && bound.less_than(square) {
            let distance = (d.dot(n) + e.dot(m)).abs() / square.sqrt();
            if is_number(distance) {
                return Some(distance);
            }
        }
        distance(self.figure()?, line.figure()?)
    }

    #[inline]
    fn distance_from<T: Primitive<S>>(self, other: T) -> Option<S> {
        other.distance_from_line(self)
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for Plane<S> {
    #[inline]
    fn figure(self) -> Option<Figure<S>> {
        let (normal, distance) = self.parts()?;
        Some(Figure::Plane { normal, distance })
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for Circle<S> {
    fn figure(self) -> Option<Figure<S>> {
        let (centre, normal, squared) = circle_parts(self)?;
        Some(Figure::Circle {
            centre,
            normal,
            radius: radius(squared)?,
        })
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for Sphere<S> {
    fn figure(self) -> Option<Figure<S>> {
        let (centre, squared) = sphere_parts(self)?;
        Some(Figure::Sphere {
            centre,
            radius: radius(squared)?,
        })
    }
}

/// Sums of rounds and flats are what their coefficients say.
macro_rules! of_a_sum {
    ($($Sum:ident: $Round:ident or $Flat:ident without $($weight:ident)*;)*) => {$(
        impl<S: Real<Mask = bool>> Primitive<S> for $Sum<S> {
            fn figure(self) -> Option<Figure<S>> {
                let read = |blade| self.coefficient(blade);
                if $(self.$weight.is_zero())&&* {
                    return $Flat::from_coefficients_unchecked(&mut { read }).figure();
                }
                $Round::from_coefficients_unchecked(&mut { read }).figure()
            }
        }
    )*};
}

of_a_sum! {
    Bivector: PointPair or FlatPoint without e1o e2o e3o;
    Trivector: Circle or Line without e123 e12o e13o e23o;
    Quadvector: Sphere or Plane without e123o;
}

macro_rules! by_the_direct_form {
    ($($Dual:ident)*) => {$(
        impl<S: Real<Mask = bool>> Primitive<S> for $Dual<S> {
            #[inline]
            fn figure(self) -> Option<Figure<S>> {
                self.undual().figure()
            }

            #[inline]
            fn distance_from_line(self, line: Line<S>) -> Option<S> {
                self.undual().distance_from_line(line)
            }
        }
    )*};
}

by_the_direct_form!(DualFlatPoint DualPointPair MotorGenerator DualPlane DualCircle DualSphere);

/// Centre and squared radius, negative for an imaginary sphere.
#[inline]
pub(super) fn sphere_parts<S: Real<Mask = bool>>(sphere: Sphere<S>) -> Option<(Vector<S>, S)> {
    Some((sphere.centre()?.into(), sphere.radius_squared))
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
