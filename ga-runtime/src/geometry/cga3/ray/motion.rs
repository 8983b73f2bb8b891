//! Rays moved by versors and mirrored.

use super::Ray;
use crate::cga3::{Direction, Motor, Rotor, Similarity, Translator};
use crate::geometry::relation::Mirror;
use crate::products::Sandwich;
use crate::scalar::{Maybe, Optional, Real, Ring};
use crate::vga3::Vector;

macro_rules! rigid {
    ($($Versor:ident)*) => {$(
        /// Moves the origin and the direction.
        impl<S: Ring> Sandwich<Ray<S>> for $Versor<S>
        where
            Self: Sandwich<crate::cga3::Point<S>, Output = crate::cga3::Point<S>>
                + Sandwich<Direction<S>, Output = Direction<S>>,
        {
            type Output = Ray<S>;

            #[inline]
            fn sandwich(self, ray: Ray<S>) -> Ray<S> {
                Ray::new_unchecked(
                    Sandwich::sandwich(self, ray.origin),
                    Sandwich::sandwich(self, ray.direction),
                )
            }
        }
    )*};
}

rigid!(Rotor Translator Motor);

/// Moves the origin and the direction, which keeps its length 1.
impl<S: Real<Mask = bool>> Sandwich<Ray<S>> for Similarity<S> {
    type Output = Ray<S>;

    #[inline]
    fn sandwich(self, ray: Ray<S>) -> Ray<S> {
        let direction: Direction<S> = Sandwich::sandwich(self, ray.direction);
        let unit = Vector::from(direction).normalized();
        Ray::new_unchecked(
            self.transform_point(ray.origin),
            unit.map_or(direction, Direction::from),
        )
    }
}

impl<S: Real> Ray<S> {
    /// The image under reflection in a plane, a line or a point; see
    /// [`reflection`](crate::geometry::relation::reflection). `None` where the mirror is not a
    /// figure, or the image is not finite. [`reflect`](Self::reflect) is the ray that goes on from
    /// a mirror.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Plane, Point, Translator};
    /// use ga_runtime::geometry::ray::Ray;
    /// let ray = Ray::new(Point::new(0.0, 0.0, 2.0), [1.0, 0.0, 0.0]).unwrap();
    /// let wall = Plane::from_point_normal(Point::new(5.0, 0.0, 0.0), [1.0, 0.0, 0.0]);
    /// let image = ray.reflect_in(wall).unwrap();
    /// assert_eq!(image.origin(), Point::new(10.0, 0.0, 2.0));
    /// assert_eq!(image.direction().vector(), [-1.0, 0.0, 0.0]);
    /// // Motions transform rays as they do all elements.
    /// let motor = Motor::from(Translator::from_displacement([0.0, 3.0, 0.0]));
    /// assert_eq!(motor.transform(ray).origin(), Point::new(0.0, 3.0, 2.0));
    /// ```
    #[must_use]
    pub fn reflect_in<M: Mirror<S> + Copy>(self, mirror: M) -> Maybe<Self, S> {
        self.origin.reflect_in(mirror).and_then(|origin| {
            let direction = self.direction.reflect_in(mirror);
            direction.map(|direction| Self::new_unchecked(origin, direction))
        })
    }
}
