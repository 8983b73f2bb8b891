//! Circles.

use super::vector3::{are_numbers, cross, dot, is_number, length, normalized, scaled, sum};
use crate::Element;
use crate::cga3::{Circle, DualPlane, Infinity, Plane, Point, RoundVector};
use crate::scalar::{Field, Real};

impl<S: Field> Circle<S> {
    /// The circle through three points, `p∧q∧r`; a line where they are on one.
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Point};
    /// let [p, q, r] = [[2.0, 0.0, 1.0], [0.0, 2.0, 1.0], [-2.0, 0.0, 1.0]].map(Point::from);
    /// let circle = Circle::through(p, q, r);
    /// assert_eq!(circle.centre().unwrap().coordinates(), [0.0, 0.0, 1.0]);
    /// assert_eq!(circle.radius(), Some(2.0));
    /// // Counterclockwise as seen from the tip of the normal.
    /// assert_eq!(circle.unit_normal(), Some([0.0, 0.0, 1.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>, r: Point<S>) -> Self {
        p ^ q ^ r
    }

    /// The plane that carries the circle, `C∧ei`.
    #[inline]
    #[must_use]
    pub fn carrier(self) -> Plane<S> {
        self ^ Infinity
    }
}

impl<S: Real<Mask = bool>> Circle<S> {
    /// The circle about a centre in the plane across a normal, which need not have length 1. `None` where the normal is
    /// zero or not finite, or a coefficient of the circle would not be.
    #[must_use]
    pub fn from_centre_normal_radius(centre: Point<S>, normal: [S; 3], radius: S) -> Option<Self> {
        let normal = normalized(normal)?;
        let distance = dot(normal, centre.coordinates());
        let plane = DualPlane::from_normal_distance(normal, distance);
        // Sphere and plane meet in the circle; in this order its normal is the plane's.
        let sphere = RoundVector::dual_sphere(centre, radius);
        let circle = (RoundVector::from(plane) ^ sphere).dual();
        let mut blades = Self::BLADES.iter();
        let is_finite = blades.all(|&blade| is_number(circle.coefficient(blade)));
        is_finite.then_some(circle)
    }

    /// The normal of the circle's plane, of length 1; `None` for a circle of weight zero, such as a line.
    #[inline]
    #[must_use]
    pub fn unit_normal(self) -> Option<[S; 3]> {
        self.carrier().unit_normal()
    }

    /// The centre; `None` for a line, or where it or the squared radius is beyond the range of the scalar.
    #[must_use]
    pub fn centre(self) -> Option<Point<S>> {
        Some(self.parts()?.0)
    }

    /// The squared radius, negative for an imaginary circle; `None` where there is no [centre](Self::centre).
    #[must_use]
    pub fn radius_squared(self) -> Option<S> {
        Some(self.parts()?.1)
    }

    /// The radius; `None` for a line and for an imaginary circle.
    #[must_use]
    pub fn radius(self) -> Option<S> {
        let squared = self.radius_squared()?;
        let is_real = squared.is_finite() && !squared.less_than(S::zero());
        is_real.then(|| squared.sqrt())
    }

    /// Centre and squared radius. The dual of the circle is a multiple of `(c + eo + β ei) ∧ (n + d ei)` with the centre c,
    /// `β = ½(c² − r²)` and the plane n·x = d, and each is read off its coefficients.
    fn parts(self) -> Option<(Point<S>, S)> {
        let dual = self.dual();
        let normal = [-dual.e1o, -dual.e2o, -dual.e3o];
        let weight = length(normal);
        if !S::zero().less_than(weight) || !weight.is_finite() {
            return None;
        }
        let scale = weight.recip();
        let normal = scaled(normal, scale);
        let distance = dual.eoi * scale;
        let moment = scaled([dual.e23, -dual.e13, dual.e12], scale);
        let centre = sum(scaled(normal, distance), cross(normal, moment));
        let infinite = scaled([dual.e1i, dual.e2i, dual.e3i], scale);
        let beta = distance * distance - dot(normal, infinite);
        let radius_squared = dot(centre, centre) - (beta + beta);
        let is_finite = are_numbers(centre) && is_number(radius_squared);
        is_finite.then(|| (Point::from(centre), radius_squared))
    }
}
