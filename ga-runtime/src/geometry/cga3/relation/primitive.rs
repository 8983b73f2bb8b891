//! Primitives that are figures.

use super::figure_distance::{distance, searched, signed_distance};
use super::figure_incidence::is_on;
use super::from_point::circle_parts;
use super::{FromPoint, Tolerance, parallel};
use crate::cga3::{
    Bivector, Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint,
    Line, MotorGenerator, Plane, Point, PointPair, Quadvector, Sphere, Trivector,
};
use crate::geometry::cga3::round::radius;
use crate::geometry::number::{is_number, is_regular};
use crate::geometry::relation::Figure;
use crate::geometry::relation::figure::sphere_parts;
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

/// A primitive that can be converted to a [`Figure`]; those of lanes are all of one kind.
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
    fn figure(self) -> Maybe<Figure<S>, S>;

    /// The least distance of a circle from a line or a circle, which circles and sums search.
    #[doc(hidden)]
    fn search(_: Figure<S>, _: Figure<S>) -> Maybe<S, S> {
        S::Mask::splat(false).when(S::zero())
    }

    /// The least distance to a line.
    #[doc(hidden)]
    #[inline]
    fn distance_from_line(self, line: Line<S>) -> Maybe<S, S> {
        line.figure()
            .and_then(|a| self.figure().and_then(|b| distance(a, b, Self::search)))
    }

    /// The least distance to another primitive.
    #[doc(hidden)]
    #[inline]
    fn distance_from<T: Primitive<S>>(self, other: T) -> Maybe<S, S> {
        let search = search_for::<S, Self, T>;
        self.figure()
            .and_then(|a| other.figure().and_then(|b| distance(a, b, search)))
    }

    /// The distance to another primitive, with a sign where one of them has sides.
    #[doc(hidden)]
    #[inline]
    fn signed_distance_from<T: Primitive<S>>(self, other: T) -> Maybe<S, S> {
        let search = search_for::<S, Self, T>;
        self.figure()
            .and_then(|a| other.figure().and_then(|b| signed_distance(a, b, search)))
    }

    /// Whether all of this primitive is on the other.
    #[doc(hidden)]
    #[inline]
    fn lies_on<T: Primitive<S>>(self, other: T, tolerance: Tolerance<S>) -> S::Mask {
        self.figure()
            .is_some_and(|a| other.figure().is_some_and(|b| is_on(a, b, tolerance)))
    }
}

/// The search of two types, one of which may be a circle.
fn search_for<S: Real, A: Primitive<S>, B: Primitive<S>>(
    a: Figure<S>,
    b: Figure<S>,
) -> Maybe<S, S> {
    A::search(a, b).or_else(|| B::search(a, b))
}

#[inline]
fn finite<S: Real>(point: Vector<S>) -> Maybe<Figure<S>, S> {
    point.is_finite().when(Figure::Point(point))
}

impl<S: Real> Primitive<S> for Point<S> {
    #[inline]
    fn figure(self) -> Maybe<Figure<S>, S> {
        finite(self.into())
    }

    #[inline]
    fn distance_from_line(self, line: Line<S>) -> Maybe<S, S> {
        line.distance_from_point(self.into())
    }

    #[inline]
    fn distance_from<T: Primitive<S>>(self, other: T) -> Maybe<S, S> {
        other.distance_from_point(self.into())
    }

    #[inline]
    fn signed_distance_from<T: Primitive<S>>(self, other: T) -> Maybe<S, S> {
        other.signed_distance_from_point(self.into())
    }

    #[inline]
    fn lies_on<T: Primitive<S>>(self, other: T, tolerance: Tolerance<S>) -> S::Mask {
        other.is_near(self.into(), tolerance)
    }
}

impl<S: Real> Primitive<S> for FlatPoint<S> {
    #[inline]
    fn figure(self) -> Maybe<Figure<S>, S> {
        self.to_point().and_then(|point| point.figure())
    }
}

impl<S: Real> Primitive<S> for PointPair<S> {
    /// One point where both are equal; of lanes, where they are in all of them.
    fn figure(self) -> Maybe<Figure<S>, S> {
        self.endpoints().map(|ends| {
            let [p, q] = ends.map(Vector::from);
            if p == q {
                Figure::Point(p)
            } else {
                Figure::PointPair([p, q])
            }
        })
    }
}

impl<S: Real> Primitive<S> for Line<S> {
    #[inline]
    fn figure(self) -> Maybe<Figure<S>, S> {
        let parts = self.parts();
        parts.map(|(point, direction)| Figure::Line { point, direction })
    }

    #[inline]
    fn distance_from_line(self, line: Self) -> Maybe<S, S> {
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
        let is_skew = is_regular(square) & bound.less_than(square);
        let usual = is_skew
            .when(())
            .map(|()| (d.dot(n) + e.dot(m)).abs() / square.sqrt())
            .filter(|distance| is_number(*distance));
        usual.or_else(|| {
            self.figure()
                .and_then(|a| line.figure().and_then(|b| distance(a, b, Self::search)))
        })
    }

    #[inline]
    fn distance_from<T: Primitive<S>>(self, other: T) -> Maybe<S, S> {
        other.distance_from_line(self)
    }
}

impl<S: Real> Primitive<S> for Plane<S> {
    #[inline]
    fn figure(self) -> Maybe<Figure<S>, S> {
        let parts = self.parts();
        parts.map(|(normal, distance)| Figure::Plane { normal, distance })
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

    fn search(a: Figure<S>, b: Figure<S>) -> Option<S> {
        searched(a, b)
    }
}

impl<S: Real> Primitive<S> for Sphere<S> {
    fn figure(self) -> Maybe<Figure<S>, S> {
        sphere_parts(self).and_then(|(centre, squared)| {
            radius(squared).map(|radius| Figure::Sphere { centre, radius })
        })
    }
}

macro_rules! of_sums {
    ($($Sum:ident)*) => {$(
        impl<S: Real<Mask = bool>> Primitive<S> for $Sum<S> {
            fn figure(self) -> Option<Figure<S>> {
                let (is_flat, flat, round) = self.flat_or_round();
                if is_flat { flat.figure() } else { round.figure() }
            }

            fn search(a: Figure<S>, b: Figure<S>) -> Option<S> {
                searched(a, b)
            }
        }
    )*};
}

of_sums!(Bivector Trivector Quadvector);

macro_rules! by_the_direct_form {
    ($($Dual:ident of $Direct:ident)*) => {$(
        impl<S: Real> Primitive<S> for $Dual<S>
        where
            $Direct<S>: Primitive<S>,
        {
            #[inline]
            fn figure(self) -> Maybe<Figure<S>, S> {
                self.undual().figure()
            }

            #[inline]
            fn search(a: Figure<S>, b: Figure<S>) -> Maybe<S, S> {
                $Direct::search(a, b)
            }

            #[inline]
            fn distance_from_line(self, line: Line<S>) -> Maybe<S, S> {
                self.undual().distance_from_line(line)
            }
        }
    )*};
}

by_the_direct_form! {
    DualFlatPoint of FlatPoint
    DualPointPair of PointPair
    MotorGenerator of Line
    DualPlane of Plane
    DualCircle of Circle
    DualSphere of Sphere
}
