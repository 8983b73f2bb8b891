//! Point pairs of cga2.
//!
//! A pair is `(c + eo + β ei) ∧ (d + (c·d) ei)` with its centre c, the direction d and
//! `β = ½(c² + r²)`.

use crate::cga2::{Point, PointPair};
use crate::geometry::number::{are_numbers, is_number};
use crate::geometry::vector2::{difference, dot, length, scaled};
use crate::scalar::{Real, Ring};

impl<S: Ring> PointPair<S> {
    /// The direction d from the first point to the second, whose length is the pair's weight:
    /// `q − p` for `p∧q`.
    #[inline]
    #[must_use]
    pub fn direction(self) -> [S; 2] {
        [-self.e1o, -self.e2o]
    }
}

impl<S: Real<Mask = bool>> PointPair<S> {
    /// The midpoint of the two points; `None` for a flat point, where the direction is zero, or
    /// beyond the range of the scalar.
    #[must_use]
    pub fn centre(self) -> Option<Point<S>> {
        Some(self.parts()?.0)
    }

    /// The squared radius, a quarter of the squared distance; negative for an imaginary pair.
    /// `None` as in [`centre`](Self::centre).
    #[must_use]
    pub fn radius_squared(self) -> Option<S> {
        Some(self.parts()?.2)
    }

    /// The two points p, q of `p∧q`; `None` for an imaginary pair, and as in
    /// [`centre`](Self::centre).
    ///
    /// ```
    /// use ga_runtime::cga2::{Circle, Line, Point};
    /// let circle = Circle::from_centre_radius(Point::new(0.0, 0.0), 5.0);
    /// let line = Line::from_point_direction(Point::new(0.0, 3.0), [1.0, 0.0]);
    /// // In the order in which the line meets them.
    /// let [p, q] = (line & circle).endpoints().unwrap();
    /// assert_eq!([p.coordinates(), q.coordinates()], [[-4.0, 3.0], [4.0, 3.0]]);
    /// ```
    #[must_use]
    pub fn endpoints(self) -> Option<[Point<S>; 2]> {
        let (centre, unit, radius_squared) = self.parts()?;
        if radius_squared.less_than(S::zero()) {
            return None;
        }
        let half = scaled(unit, radius_squared.sqrt());
        let ends = [half.map(|x| -x), half].map(|step| {
            let [x, y] = centre.coordinates();
            [x + step[0], y + step[1]]
        });
        let usable = ends.into_iter().all(are_numbers);
        usable.then(|| ends.map(Point::from))
    }

    /// Centre, unit direction and squared radius.
    fn parts(self) -> Option<(Point<S>, [S; 2], S)> {
        let weight = length(self.direction());
        if !S::zero().less_than(weight) || !weight.is_finite() {
            return None;
        }
        let pair = self / weight;
        let d = pair.direction();
        // The coefficient of eoi is c·d, that of e12 is c∧d, and (c·d) c − β d belongs to e1i and
        // e2i.
        let across = [d[1], -d[0]];
        let centre = [
            d[0] * pair.eoi + across[0] * pair.e12,
            d[1] * pair.eoi + across[1] * pair.e12,
        ];
        let at_infinity = [pair.e1i, pair.e2i];
        let beta = dot(difference(scaled(centre, pair.eoi), at_infinity), d);
        let radius_squared = beta + beta - dot(centre, centre);
        let usable = are_numbers(centre) && is_number(radius_squared);
        usable.then(|| (Point::from(centre), d, radius_squared))
    }
}
