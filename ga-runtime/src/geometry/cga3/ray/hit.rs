//! Where a ray hits a surface, and how it goes on from there.

use super::Ray;
use crate::cga3::{Direction, Point};
use crate::geometry::number::is_regular;
use crate::scalar::{Mask, Maybe, Optional, Real, Select};
use crate::vga3::Vector;

/// Where a ray hits a surface. In a hit that is made by hand, `normal` must have length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<S: Select> {
    /// The distance from the origin of the ray, in the units of the coordinates.
    pub distance: S,
    /// The point: [`Ray::at`] the distance.
    pub point: Point<S>,
    /// The normal of the surface, of length 1, on the side from which the ray comes: its inner
    /// product with the direction of the ray is at most zero, up to rounding.
    pub normal: Direction<S>,
    /// Whether the ray comes from the front; of a single number, [`side`](Self::side) names it.
    pub is_front: S::Mask,
}

/// A side of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// The side of the surface's own normal, for a sphere its outside.
    Front,
    /// The other side, for a sphere its inside.
    Back,
}

impl<S: Real> Ray<S> {
    /// The ray that a mirror at the hit point sends on: it begins there, in the direction
    /// `−n d n = d − 2 (d·n) n`, where n is the normal. For a sphere that is the reflection in its
    /// tangent plane. [`reflect_in`](Self::reflect_in) is the mirror image of the whole ray.
    ///
    /// ```
    /// use ga_runtime::cga3::{Plane, Point};
    /// use ga_runtime::geometry::ray::Ray;
    /// let mirror = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    /// let ray = Ray::new(Point::new(-3.0, 0.0, 4.0), [3.0, 0.0, -4.0]).unwrap();
    /// let hit = ray.first_hit(mirror).unwrap();
    /// let reflected = ray.reflect(&hit);
    /// assert_eq!(reflected.origin(), hit.point);
    /// assert_eq!(reflected.direction().vector(), [0.6, 0.0, 0.8]);
    /// ```
    #[inline]
    #[must_use]
    pub fn reflect(self, hit: &Hit<S>) -> Self {
        let (direction, normal) = (Vector::from(self.direction), Vector::from(hit.normal));
        let along = direction.dot(normal);
        let direction = direction - normal * (along + along);
        Self::new_unchecked(hit.point, direction.into())
    }

    /// The ray that goes on behind the hit point by Snell's law: with θ the angle from the normal
    /// and η the ratio, `sin θ' = η sin θ`. The ratio is the refractive index on the side from
    /// which the ray comes, divided by the index on the other side: 1/1.5 from air into glass, 1.5
    /// back into air. `None` for total reflection, and for a ratio that is not positive and finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Plane, Point};
    /// use ga_runtime::geometry::ray::Ray;
    /// let water = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    /// let ray = Ray::new(Point::new(-3.0, 0.0, 4.0), [3.0_f64, 0.0, -4.0]).unwrap();
    /// let hit = ray.first_hit(water).unwrap();
    /// let [x, _, z] = ray.refract(&hit, 1.0 / 1.33).unwrap().direction().vector();
    /// assert!((x - 0.6 / 1.33).abs() < 1e-15 && z < -0.8);
    /// // Out of glass, at an angle whose sine is 0.6: 1.8 · 0.6 > 1.
    /// assert_eq!(ray.refract(&hit, 1.8), None);
    /// ```
    #[must_use]
    pub fn refract(self, hit: &Hit<S>, ratio: S) -> Maybe<Self, S> {
        let is_ratio = S::zero().less_than(ratio) & ratio.is_finite();
        is_ratio.when(()).and_then(|()| {
            let (direction, normal) = (Vector::from(self.direction), Vector::from(hit.normal));
            let cosine = -direction.dot(normal);
            // The part along the surface; its length is the sine of the new angle.
            let sideways = (direction + normal * cosine) * ratio;
            let cosine_squared = S::one() - sideways.dot(sideways);
            let is_total = cosine_squared.less_than(S::zero());
            (!is_total).when(()).and_then(|()| {
                let direction = sideways - normal * cosine_squared.sqrt();
                let unit = direction.normalized();
                unit.map(|unit| Self::new_unchecked(hit.point, unit.into()))
            })
        })
    }
}

impl<S: Select<Mask = bool>> Hit<S> {
    /// The side from which the ray comes.
    #[inline]
    #[must_use]
    pub fn side(&self) -> Side {
        if self.is_front {
            Side::Front
        } else {
            Side::Back
        }
    }
}

impl<S: Real> Select for Hit<S> {
    type Mask = S::Mask;

    #[inline]
    fn select(mask: S::Mask, if_true: Self, if_false: Self) -> Self {
        Self {
            distance: S::select(mask, if_true.distance, if_false.distance),
            point: Point::select(mask, if_true.point, if_false.point),
            normal: Direction::select(mask, if_true.normal, if_false.normal),
            is_front: (mask & if_true.is_front) | (!mask & if_false.is_front),
        }
    }
}

impl<S: Real> Hit<S> {
    /// The hit at a distance, for a normal of the surface of any length that is not zero, and given
    /// the inner product of that normal with the direction of the ray. `None` where the distance is
    /// not finite, or its square overflows, or the normal has no direction.
    #[inline(always)]
    pub(super) fn of(ray: Ray<S>, distance: S, normal: Vector<S>, slope: S) -> Maybe<Self, S> {
        let is_in_range = (distance * distance).is_finite();
        is_in_range.when(()).and_then(|()| {
            // Where a sphere is only touched, the ray stays in front.
            let is_front = !S::zero().less_than(slope);
            unit(Vector::select(is_front, normal, -normal)).map(|normal| Self {
                distance,
                point: ray.at(distance),
                normal: normal.into(),
                is_front,
            })
        })
    }
}

/// The vector with length 1; `None` where it is zero or not finite.
#[inline]
fn unit<S: Real>(vector: Vector<S>) -> Maybe<Vector<S>, S> {
    let square = vector.dot(vector);
    let excess = square - S::one();
    // The normal of most planes: a step of Newton's method is exact to rounding.
    let is_nearly_unit = (excess * excess).less_than(S::epsilon()).when(());
    is_nearly_unit
        .map(|()| vector * (S::one() - excess * S::from_ratio(1, 2)))
        .or_else(|| {
            let is_regular = is_regular(square).when(());
            is_regular.map(|()| vector * square.sqrt().recip())
        })
        .or_else(|| vector.normalized())
}
