//! Reflection in a plane, in a line and in a point.
//!
//! `x.reflect_in(mirror)` is a versor action, for any element x in direct or dual form:
//!
//! | mirror | versor V | image | of a point x |
//! | --- | --- | --- | --- |
//! | plane | `π = dual(Π)/∣Π∣ = n + d ei` | `π X̂ π` | `x − 2 (n·x − d) n` |
//! | line | `ℓ = dual(L)/∣L∣`, a half turn | `ℓ X ~ℓ` | `2 f − x`, f its foot on the line |
//! | point p | `dual(p∧ei)`, of grade 3 | `V X̂ V⁻¹` | `2 p − x` |
//!
//! X̂ is the grade involution, −X for odd grades. So a blade is mapped point by point and keeps its
//! weight and orientation: `p∧q∧r∧ei` becomes `p'∧q'∧r'∧ei`. Planes and points as mirrors reverse
//! the orientation of a dual form: I changes its sign under them, so that the dual of the image is
//! minus the image of the dual. Reflecting twice gives X again.
//!
//! The image is computed with a motor, for odd versors after changing the sign of all coordinates:
//! a reflection in a plane is the reflection in the origin, then a half turn about the normal and a
//! translation.
//!
//! The result is `None` where the mirror is not a [`Figure`], or where the image is beyond the
//! range of the scalar.
//!
//! ```
//! use ga_runtime::cga3::{Line, Plane, Point};
//!
//! let p = Point::new(1.0, 2.0, 3.0);
//! let wall = Plane::from_point_normal(Point::new(4.0, 0.0, 0.0), [1.0, 0.0, 0.0]);
//! assert_eq!(p.reflect_in(wall), Some(Point::new(7.0, 2.0, 3.0)));
//! assert_eq!(p.reflect_in(Point::default()), Some(Point::new(-1.0, -2.0, -3.0)));
//! let ray = Line::from_point_direction(p, [1.0, 0.0, 1.0]);
//! assert_eq!(ray.reflect_in(wall).unwrap().direction(), [-1.0, 0.0, 1.0]);
//! ```

use super::{Figure, Primitive};
use crate::Element;
use crate::cga3::{
    Circle, Direction, DualCircle, DualDirection, DualFlatPoint, DualPlane, DualPointPair,
    DualSphere, FlatPoint, Line, Motor, MotorGenerator, Plane, Point, PointPair, Rotor,
    RoundVector, Sphere, Translator,
};
use crate::geometry::number::{are_numbers, is_moderate};
use crate::products::Sandwich;
use crate::scalar::Real;
use crate::vga3::Vector;

/// A mirror of a reflection: a plane, a line or a point.
pub trait Mirror<S> {
    /// The motor of the reflection, and whether all coordinates change sign before it; `None` where
    /// the mirror is not a figure.
    fn reflection(self) -> Option<(Motor<S>, bool)>;

    /// The image of a point, for mirrors that know a shorter way than by their motor.
    #[doc(hidden)]
    #[inline]
    fn image_of_point(self, point: Point<S>) -> Option<Point<S>>
    where
        S: Real<Mask = bool>,
        Self: Sized,
    {
        image(point, self)
    }

    /// The image of a line, in the same way.
    #[doc(hidden)]
    #[inline]
    fn image_of_line(self, line: Line<S>) -> Option<Line<S>>
    where
        S: Real<Mask = bool>,
        Self: Sized,
    {
        image(line, self)
    }
}

impl<S: Real<Mask = bool>> Mirror<S> for Plane<S> {
    fn reflection(self) -> Option<(Motor<S>, bool)> {
        let Figure::Plane { normal, distance } = self.figure()? else {
            return None;
        };
        let translation = translation(normal * (distance + distance))?;
        Some((translation * half_turn(normal), true))
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Option<Point<S>> {
        let place = self.moved_along_normal(point.into(), S::from_integer(2))?;
        Some(place.into())
    }

    /// The direction d and the moment m become `d − 2 (n·d) n` and `2 (n·m) n − m + 2 h n × d`,
    /// with the unit normal n and the distance h of the plane from the origin.
    #[inline]
    fn image_of_line(self, line: Line<S>) -> Option<Line<S>> {
        let (normal, number) = self.vectors();
        let (direction, moment) = line.vectors();
        let square = normal.length_squared();
        let inverse = square.recip();
        let twice = normal * (inverse + inverse);
        let image = direction - normal * twice.dot(direction);
        let around = twice.cross(direction) * number - moment + normal * twice.dot(moment);
        // A number that is not finite gives a sum that is not.
        let sizes = image.length_squared() + around.length_squared();
        if is_moderate(square + inverse + sizes) {
            return Some(Line::from_vectors(image, around));
        }
        image_by_motor(line, self)
    }
}

impl<S: Real<Mask = bool>> Mirror<S> for Line<S> {
    fn reflection(self) -> Option<(Motor<S>, bool)> {
        let Figure::Line { point, direction } = self.figure()? else {
            return None;
        };
        // The point nearest to the origin is perpendicular to the direction: a half turn about the
        // axis through the origin maps it to its negative.
        let translation = translation(point * S::from_integer(2))?;
        Some((translation * half_turn(direction), false))
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Option<Point<S>> {
        twice_less(self.foot(point)?.into(), point.into())
    }
}

impl<S: Real<Mask = bool>> Mirror<S> for Point<S> {
    fn reflection(self) -> Option<(Motor<S>, bool)> {
        let translation = translation(Vector::from(self) * S::from_integer(2))?;
        Some((translation.into(), true))
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Option<Point<S>> {
        twice_less(self.into(), point.into())
    }
}

impl<S: Real<Mask = bool>> Mirror<S> for FlatPoint<S> {
    fn reflection(self) -> Option<(Motor<S>, bool)> {
        self.to_point()?.reflection()
    }
}

impl<S: Real<Mask = bool>> Mirror<S> for DualPlane<S> {
    fn reflection(self) -> Option<(Motor<S>, bool)> {
        self.undual().reflection()
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Option<Point<S>> {
        self.undual().image_of_point(point)
    }

    #[inline]
    fn image_of_line(self, line: Line<S>) -> Option<Line<S>> {
        self.undual().image_of_line(line)
    }
}

impl<S: Real<Mask = bool>> Mirror<S> for MotorGenerator<S> {
    fn reflection(self) -> Option<(Motor<S>, bool)> {
        self.undual().reflection()
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Option<Point<S>> {
        self.undual().image_of_point(point)
    }
}

macro_rules! reflections {
    ($($Element:ident)*) => {$(
        impl<S: Real<Mask = bool>> $Element<S> {
            /// The image under reflection in a plane, a line or a point; see
            /// [`reflection`](crate::geometry::relation::reflection). `None` where the mirror is
            /// not a figure, or the image is not finite.
            #[must_use]
            pub fn reflect_in<M: Mirror<S>>(self, mirror: M) -> Option<Self> {
                image(self, mirror)
            }
        }
    )*};
}

macro_rules! reflections_by_mirrors {
    ($($Element:ident: $image:ident;)*) => {$(
        impl<S: Real<Mask = bool>> $Element<S> {
            /// The image under reflection in a plane, a line or a point; see
            /// [`reflection`](crate::geometry::relation::reflection). `None` where the mirror is
            /// not a figure, or the image is not finite.
            #[inline]
            #[must_use]
            pub fn reflect_in<M: Mirror<S>>(self, mirror: M) -> Option<Self> {
                mirror.$image(self)
            }
        }
    )*};
}

reflections_by_mirrors! {
    Point: image_of_point;
    Line: image_of_line;
}

reflections! {
    RoundVector PointPair FlatPoint Direction Circle Sphere Plane
    DualSphere DualPlane DualPointPair DualFlatPoint DualDirection DualCircle MotorGenerator
}

/// The image of an element by the motor of a mirror.
fn image<S, T, M>(element: T, mirror: M) -> Option<T>
where
    S: Real<Mask = bool>,
    T: Element<Scalar = S>,
    M: Mirror<S>,
    Motor<S>: Sandwich<T, Output = T>,
{
    let (motor, is_odd) = mirror.reflection()?;
    let element = if is_odd {
        through_origin(element)
    } else {
        element
    };
    finite(motor.sandwich(element))
}

/// The image of a line in a plane whose numbers are too large or too small for the formula.
#[cold]
#[inline(never)]
fn image_by_motor<S: Real<Mask = bool>>(line: Line<S>, plane: Plane<S>) -> Option<Line<S>> {
    image(line, plane)
}

/// The image of a point in another, `2 centre − point`.
#[inline]
fn twice_less<S: Real<Mask = bool>>(centre: Vector<S>, point: Vector<S>) -> Option<Point<S>> {
    let place = centre + centre - point;
    are_numbers(place.coordinates()).then(|| Point::from(place))
}

/// The element if all its coefficients are finite.
fn finite<T: Element<Scalar: Real<Mask = bool>>>(element: T) -> Option<T> {
    let mut blades = T::BLADES.iter();
    let is_finite = blades.all(|&blade| element.coefficient(blade).is_finite());
    is_finite.then_some(element)
}

/// The half turn about a unit axis through the origin.
fn half_turn<S: Real>(Vector { e1, e2, e3 }: Vector<S>) -> Rotor<S> {
    Rotor::new_unchecked(S::zero(), -e3, e2, -e1)
}

fn translation<S: Real<Mask = bool>>(displacement: Vector<S>) -> Option<Translator<S>> {
    displacement
        .is_finite()
        .then(|| Translator::from_displacement(displacement.into()))
}

/// The image under reflection in the origin, which changes the sign of e1, e2 and e3.
fn through_origin<T: Element<Scalar: Real>>(element: T) -> T {
    T::from_coefficients_unchecked(&mut |blade| {
        let coefficient = element.coefficient(blade);
        if (blade & 0b111).count_ones() % 2 == 1 {
            -coefficient
        } else {
            coefficient
        }
    })
}
