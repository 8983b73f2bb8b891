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

#[cfg(doc)]
use super::Figure;
use crate::Element;
use crate::cga3::{
    Circle, Direction, DualCircle, DualDirection, DualFlatPoint, DualPlane, DualPointPair,
    DualSphere, FlatPoint, Line, Motor, MotorGenerator, Plane, Point, PointPair, Rotor,
    RoundVector, Sphere, Translator,
};
use crate::geometry::number::{are_numbers, is_moderate};
use crate::products::Sandwich;
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

/// A mirror of a reflection: a plane, a line or a point.
pub trait Mirror<S: Real> {
    /// The motor of the reflection, and whether all coordinates change sign before it; `None` where
    /// the mirror is not a figure.
    fn reflection(self) -> Maybe<(Motor<S>, bool), S>;

    /// The image of a point, for mirrors that know a shorter way than by their motor.
    #[doc(hidden)]
    #[inline]
    fn image_of_point(self, point: Point<S>) -> Maybe<Point<S>, S>
    where
        Self: Sized,
    {
        image(point, self)
    }

    /// The image of a line, as [`image_of_point`](Self::image_of_point).
    #[doc(hidden)]
    #[inline]
    fn image_of_line(self, line: Line<S>) -> Maybe<Line<S>, S>
    where
        Self: Sized,
    {
        image(line, self)
    }
}

impl<S: Real> Mirror<S> for Plane<S> {
    fn reflection(self) -> Maybe<(Motor<S>, bool), S> {
        self.parts().and_then(|(normal, distance)| {
            let translation = translation(normal * (distance + distance));
            translation.map(|translation| (translation * half_turn(normal), true))
        })
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Maybe<Point<S>, S> {
        let place = self.moved_along_normal(point.into(), S::from_integer(2));
        place.map(Point::from)
    }

    /// A direction d and a moment m = p × d are mapped to those of the image of p: for `n·x = h`
    /// with n² = 1 they are `d − 2 (n·d) n` and `2 (n·m) n − m + 2 h n × d`.
    #[inline]
    fn image_of_line(self, line: Line<S>) -> Maybe<Line<S>, S> {
        let (normal, number) = self.vectors();
        let (direction, moment) = line.vectors();
        let square = normal.length_squared();
        let inverse = square.recip();
        let twice = inverse + inverse;
        let image = direction - normal * (normal.dot(direction) * twice);
        let image_moment = normal * (normal.dot(moment) * twice) - moment
            + normal.cross(direction) * (number * twice);
        // The sum of the components is a number only if each of them is.
        let Vector { e1, e2, e3 } = image + image_moment;
        is_moderate(square + inverse + (e1 + e2 + e3).abs())
            .when(Line::from_vectors(image, image_moment))
            .or_else_of((line, self), |(line, plane)| image_by_motor(line, plane))
    }
}

impl<S: Real> Mirror<S> for Line<S> {
    fn reflection(self) -> Maybe<(Motor<S>, bool), S> {
        self.parts().and_then(|(point, direction)| {
            // The point nearest to the origin is perpendicular to the direction: a half turn about
            // the axis through the origin maps it to its negative.
            let translation = translation(point * S::from_integer(2));
            translation.map(|translation| (translation * half_turn(direction), false))
        })
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Maybe<Point<S>, S> {
        self.foot(point)
            .and_then(|foot| twice_less(foot.into(), point.into()))
    }
}

impl<S: Real> Mirror<S> for Point<S> {
    fn reflection(self) -> Maybe<(Motor<S>, bool), S> {
        let translation = translation(Vector::from(self) * S::from_integer(2));
        translation.map(|translation| (translation.into(), true))
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Maybe<Point<S>, S> {
        twice_less(self.into(), point.into())
    }
}

impl<S: Real> Mirror<S> for FlatPoint<S> {
    fn reflection(self) -> Maybe<(Motor<S>, bool), S> {
        self.to_point().and_then(Mirror::reflection)
    }
}

impl<S: Real> Mirror<S> for DualPlane<S> {
    fn reflection(self) -> Maybe<(Motor<S>, bool), S> {
        self.undual().reflection()
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Maybe<Point<S>, S> {
        self.undual().image_of_point(point)
    }

    #[inline]
    fn image_of_line(self, line: Line<S>) -> Maybe<Line<S>, S> {
        self.undual().image_of_line(line)
    }
}

impl<S: Real> Mirror<S> for MotorGenerator<S> {
    fn reflection(self) -> Maybe<(Motor<S>, bool), S> {
        self.undual().reflection()
    }

    #[inline]
    fn image_of_point(self, point: Point<S>) -> Maybe<Point<S>, S> {
        self.undual().image_of_point(point)
    }

    #[inline]
    fn image_of_line(self, line: Line<S>) -> Maybe<Line<S>, S> {
        self.undual().image_of_line(line)
    }
}

macro_rules! reflections {
    ($($Element:ident)*) => {$(
        impl<S: Real> $Element<S> {
            /// The image under reflection in a plane, a line or a point; see
            /// [`reflection`](crate::geometry::relation::reflection). `None` where the mirror is
            /// not a figure, or the image is not finite.
            #[must_use]
            pub fn reflect_in<M: Mirror<S>>(self, mirror: M) -> Maybe<Self, S> {
                image(self, mirror)
            }
        }
    )*};
}

impl<S: Real> Point<S> {
    /// The image under reflection in a plane, a line or a point; see
    /// [`reflection`](crate::geometry::relation::reflection). `None` where the mirror is not a
    /// figure, or the image is not finite.
    #[inline]
    #[must_use]
    pub fn reflect_in<M: Mirror<S>>(self, mirror: M) -> Maybe<Self, S> {
        mirror.image_of_point(self)
    }
}

impl<S: Real> Line<S> {
    /// The image under reflection in a plane, a line or a point; see
    /// [`reflection`](crate::geometry::relation::reflection). `None` where the mirror is not a
    /// figure, or the image is not finite.
    #[inline]
    #[must_use]
    pub fn reflect_in<M: Mirror<S>>(self, mirror: M) -> Maybe<Self, S> {
        mirror.image_of_line(self)
    }
}

reflections! {
    RoundVector PointPair FlatPoint Direction Circle Sphere Plane
    DualSphere DualPlane DualPointPair DualFlatPoint DualDirection DualCircle MotorGenerator
}

/// The image of an element by the motor of a mirror.
fn image<S, T, M>(element: T, mirror: M) -> Maybe<T, S>
where
    S: Real,
    T: Element<Scalar = S>,
    M: Mirror<S>,
    Motor<S>: Sandwich<T, Output = T>,
{
    let image = mirror.reflection().map(|(motor, is_odd)| {
        let element = if is_odd {
            through_origin(element)
        } else {
            element
        };
        motor.sandwich(element)
    });
    image.filter(|image| image.is_finite())
}

/// The image of a line in a plane of any weight.
#[cold]
#[inline(never)]
fn image_by_motor<S: Real>(line: Line<S>, plane: Plane<S>) -> Maybe<Line<S>, S> {
    image(line, plane)
}

/// The image of a point in another, `2 centre − point`.
#[inline]
fn twice_less<S: Real>(centre: Vector<S>, point: Vector<S>) -> Maybe<Point<S>, S> {
    let place = centre + centre - point;
    are_numbers(place.coordinates()).when(Point::from(place))
}

/// The half turn about a unit axis through the origin.
fn half_turn<S: Real>(Vector { e1, e2, e3 }: Vector<S>) -> Rotor<S> {
    Rotor::new_unchecked(S::zero(), -e3, e2, -e1)
}

fn translation<S: Real>(displacement: Vector<S>) -> Maybe<Translator<S>, S> {
    displacement
        .is_finite()
        .when(Translator::from_displacement(displacement.into()))
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
