//! Primitives as plain Euclidean figures.

use crate::cga3::{
    Circle, DualCircle, DualFlatPoint, DualPlane, DualPointPair, DualSphere, FlatPoint, Line,
    MotorGenerator, Plane, Point, PointPair, Sphere,
};
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
pub trait Primitive<S>: Copy {
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
}

impl<S: Real<Mask = bool>> Primitive<S> for Point<S> {
    #[inline]
    fn figure(self) -> Option<Figure<S>> {
        let place = Vector::from(self);
        place.is_finite().then_some(Figure::Point(place))
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
        if [self.e1o, self.e2o, self.e3o] == [S::zero(); 3] {
            // p∧ei, where p is finite.
            return FlatPoint::new(self.e1i, self.e2i, self.e3i, self.eoi).figure();
        }
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
        let (point, direction) = (self.support()?.into(), self.unit_direction()?.into());
        Some(Figure::Line { point, direction })
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for Plane<S> {
    #[inline]
    fn figure(self) -> Option<Figure<S>> {
        let normal = self.unit_normal()?.into();
        let dual = self.dual();
        let distance = dual.ei / Vector::from(dual.normal()).length();
        let figure = Figure::Plane { normal, distance };
        distance.is_finite().then_some(figure)
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for Circle<S> {
    fn figure(self) -> Option<Figure<S>> {
        if [self.e123, self.e12o, self.e13o, self.e23o] == [S::zero(); 4] {
            let Self {
                e12i,
                e13i,
                e23i,
                e1oi,
                e2oi,
                e3oi,
                ..
            } = self;
            return Line::new(e12i, e13i, e23i, e1oi, e2oi, e3oi).figure();
        }
        let (centre, normal, _) = circle_parts(self)?;
        let radius = self.radius()?;
        Some(Figure::Circle {
            centre,
            normal,
            radius,
        })
    }
}

impl<S: Real<Mask = bool>> Primitive<S> for Sphere<S> {
    fn figure(self) -> Option<Figure<S>> {
        if self.e123o == S::zero() {
            let Self {
                e123i,
                e12oi,
                e13oi,
                e23oi,
                ..
            } = self;
            return Plane::new(e123i, e12oi, e13oi, e23oi).figure();
        }
        let (centre, _) = sphere_parts(self)?;
        let radius = self.radius()?;
        Some(Figure::Sphere { centre, radius })
    }
}

macro_rules! by_the_direct_form {
    ($($Dual:ident)*) => {$(
        impl<S: Real<Mask = bool>> Primitive<S> for $Dual<S> {
            #[inline]
            fn figure(self) -> Option<Figure<S>> {
                self.undual().figure()
            }
        }
    )*};
}

by_the_direct_form!(DualFlatPoint DualPointPair MotorGenerator DualPlane DualCircle DualSphere);

/// Centre, unit normal and squared radius, negative for an imaginary circle.
pub(super) fn circle_parts<S: Real<Mask = bool>>(
    circle: Circle<S>,
) -> Option<(Vector<S>, Vector<S>, S)> {
    let (centre, normal) = (circle.centre()?.into(), circle.unit_normal()?.into());
    let squared = circle.radius_squared()?;
    squared.is_finite().then_some((centre, normal, squared))
}

/// Centre and squared radius, negative for an imaginary sphere.
pub(super) fn sphere_parts<S: Real<Mask = bool>>(sphere: Sphere<S>) -> Option<(Vector<S>, S)> {
    let (centre, squared) = (Vector::from(sphere.centre()?), sphere.radius_squared()?);
    let finite = centre.is_finite() && squared.is_finite();
    finite.then_some((centre, squared))
}
