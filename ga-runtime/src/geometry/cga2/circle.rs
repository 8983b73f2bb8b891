//! Circles of cga2, and vectors as dual circles.

use crate::cga2::{Circle, Point, RoundVector};
use crate::geometry::number::{are_numbers, is_number};
use crate::geometry::vector2::dot;
use crate::scalar::{Field, Mask, Maybe, Optional, Real};

impl<S: Field> RoundVector<S> {
    /// The dual circle `c − ½r² ei` with centre c; imaginary where r² is negative, the point c
    /// itself where it is zero.
    #[inline]
    #[must_use]
    pub fn dual_circle(centre: Point<S>, radius_squared: S) -> Self {
        Self::new(
            centre.e1(),
            centre.e2(),
            S::one(),
            centre.ei() - radius_squared * S::from_ratio(1, 2),
        )
    }
}

impl<S: Real> RoundVector<S> {
    /// The centre of a dual circle, or the position of a weighted point; `None` for a line, which
    /// has weight zero, or beyond the range of the scalar.
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        let place = [self.e1 / self.eo, self.e2 / self.eo];
        (!self.eo.equals(S::zero()) & are_numbers(place)).when(Point::from(place))
    }

    /// The squared radius of a dual circle, `V²/(V·ei)²`; negative for an imaginary one. `None` as
    /// in [`centre`](Self::centre).
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        self.centre().and_then(|centre| {
            let centre = centre.coordinates();
            let infinite = self.ei / self.eo;
            let radius_squared = dot(centre, centre) - (infinite + infinite);
            is_number(radius_squared).when(radius_squared)
        })
    }
}

impl<S: Field> Circle<S> {
    /// The circle through three points, `p∧q∧r`, with twice the area of their triangle as its
    /// weight: positive where they are in counterclockwise order. A line where they are collinear.
    ///
    /// ```
    /// use ga_runtime::cga2::{Circle, Point};
    /// let [p, q, r] = [[3.0, 0.0], [0.0, 1.0], [-3.0, 0.0]].map(Point::from);
    /// let circle = Circle::through(p, q, r);
    /// assert_eq!(circle, p ^ q ^ r);
    /// assert_eq!(circle.centre(), Some(Point::new(0.0, -4.0)));
    /// assert_eq!(circle.radius(), Some(5.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>, r: Point<S>) -> Self {
        p ^ q ^ r
    }

    /// The circle with a given centre and radius, `undual(c − ½r² ei)`, counterclockwise with
    /// weight 1.
    #[inline]
    #[must_use]
    pub fn from_centre_radius(centre: Point<S>, radius: S) -> Self {
        Self::from_centre_radius_squared(centre, radius * radius)
    }

    /// The circle with a given centre and squared radius; imaginary where that is negative.
    #[inline]
    #[must_use]
    pub fn from_centre_radius_squared(centre: Point<S>, radius_squared: S) -> Self {
        RoundVector::dual_circle(centre, radius_squared).undual()
    }
}

impl<S: Real> Circle<S> {
    /// The centre; `None` for a line, which has weight zero, or beyond the range of the scalar.
    #[must_use]
    pub fn centre(self) -> Maybe<Point<S>, S> {
        self.dual().centre()
    }

    /// The squared radius, negative for an imaginary circle; `None` as in [`centre`](Self::centre).
    #[must_use]
    pub fn radius_squared(self) -> Maybe<S, S> {
        self.dual().radius_squared()
    }

    /// The radius; `None` for an imaginary circle, and as in [`centre`](Self::centre).
    #[must_use]
    pub fn radius(self) -> Maybe<S, S> {
        let real = self.radius_squared().filter(|r| !r.less_than(S::zero()));
        real.map(S::sqrt)
    }
}
