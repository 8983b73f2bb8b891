//! Lines.

use crate::cga3::{Direction, Line, Point};
use crate::geometry::number::{are_numbers, is_moderate, is_regular};
use crate::scalar::{Mask, Maybe, Optional, Real, Ring};
use crate::vga3::Vector;

impl<S: Ring> Line<S> {
    /// The line through two points, from the first to the second: `p∧q∧ei`. Zero where they
    /// coincide.
    ///
    /// ```
    /// use ga_runtime::cga3::{Infinity, Line, Point};
    /// let (p, q) = (Point::new(0.0, 1.0, 0.0), Point::new(2.0, 1.0, 0.0));
    /// let line = Line::through(p, q);
    /// assert_eq!(line, p ^ q ^ Infinity);
    /// assert_eq!(line.direction(), [2.0, 0.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn through(p: Point<S>, q: Point<S>) -> Self {
        Self::from_point_direction(p, p.vector_to(q).into())
    }

    /// The line through a point in a direction d: `p∧d∧ei`. Zero where d is zero.
    #[inline]
    #[must_use]
    pub fn from_point_direction(point: Point<S>, direction: [S; 3]) -> Self {
        let moment = Vector::from(point).cross(direction.into());
        let [m1, m2, m3] = moment.coordinates();
        let [d1, d2, d3] = direction;
        Self::new(m3, -m2, m1, -d1, -d2, -d3)
    }

    /// The direction d, whose length is the line's weight: `q − p` for `p∧q∧ei`. Its components are
    /// minus the coefficients of e1oi, e2oi, e3oi.
    #[inline]
    #[must_use]
    pub fn direction(self) -> [S; 3] {
        [-self.e1oi, -self.e2oi, -self.e3oi]
    }

    /// The attitude `d∧ei`: the direction as a free vector, `−ei⌋L`.
    #[inline]
    #[must_use]
    pub fn attitude(self) -> Direction<S> {
        Direction::from_vector(self.direction())
    }

    /// The moment `p × d` about the origin, for any point p of the line: the coefficients of e23i,
    /// −e13i, e12i.
    #[inline]
    #[must_use]
    pub fn moment(self) -> [S; 3] {
        [self.e23i, -self.e13i, self.e12i]
    }
}

impl<S: Real> Line<S> {
    /// The line with a direction d and the moment `p × d` of its points p: its Plücker coordinates.
    /// A component of the moment along d, which is zero for every line, is removed. `None` where d
    /// is zero, or a number is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Point};
    /// let line = Line::from_direction_moment([0.0, 0.0, 2.0], [2.0, -2.0, 7.0]).unwrap();
    /// assert_eq!(line, Line::from_point_direction(Point::new(1.0, 1.0, 0.0), [0.0, 0.0, 2.0]));
    /// ```
    #[must_use]
    pub fn from_direction_moment(direction: [S; 3], moment: [S; 3]) -> Maybe<Self, S> {
        let direction = Vector::from(direction);
        direction.normalized().and_then(|unit| {
            let moment = Vector::from(moment).across(unit);
            are_numbers(moment.into()).when(Self::from_vectors(direction, moment))
        })
    }

    /// The direction with length 1; `None` for a line of weight zero.
    #[inline]
    #[must_use]
    pub fn unit_direction(self) -> Maybe<[S; 3], S> {
        Vector::from(self.direction())
            .normalized()
            .map(Vector::coordinates)
    }

    /// The point of the line nearest to the origin, `d × m / d²`; `None` for a line of weight zero.
    #[inline]
    #[must_use]
    pub fn support(self) -> Maybe<Point<S>, S> {
        let (direction, moment) = self.vectors();
        let square = direction.length_squared();
        let inverse = square.recip();
        let place = direction.cross(moment) * inverse;
        // The sum of the coordinates is a number only if each of them is.
        let sum = place.e1 + place.e2 + place.e3;
        is_moderate(square + inverse + sum.abs())
            .when(place.into())
            .or_else_of((direction.into(), moment.into()), |(direction, moment)| {
                parts_of_any(direction, moment).map(|[place, _]| place)
            })
            .map(Point::from)
    }

    /// The foot of the perpendicular from a point; `None` for a line of weight zero.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Point};
    /// let line = Line::through(Point::new(0.0, 1.0, 0.0), Point::new(2.0, 1.0, 0.0));
    /// let foot = line.foot(Point::new(3.0, 7.0, 0.0)).unwrap();
    /// assert_eq!(foot.coordinates(), [3.0, 1.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn foot(self, point: Point<S>) -> Maybe<Point<S>, S> {
        let (direction, moment) = self.vectors();
        let square = direction.length_squared();
        let inverse = square.recip();
        let along = direction * direction.dot(point.into());
        let place = (along + direction.cross(moment)) * inverse;
        // The sum of the coordinates is a number only if each of them is.
        let sum = place.e1 + place.e2 + place.e3;
        is_moderate(square + inverse + sum.abs())
            .when(place.into())
            .or_else_of(
                (direction.into(), moment.into(), point.coordinates()),
                |(direction, moment, point)| foot_of_any(direction, moment, point),
            )
            .map(Point::from)
    }

    /// The distance to a point; `None` for a line of weight zero, or beyond the range of the
    /// scalar. For other primitives: [`distance_to`](Self::distance_to).
    #[inline]
    #[must_use]
    pub fn distance(self, point: Point<S>) -> Maybe<S, S> {
        let (direction, moment) = self.vectors();
        let square = direction.length_squared();
        let arm = Vector::from(point).cross(direction) - moment;
        let reach = arm.length_squared();
        let quotient = reach / square;
        let are_regular = is_regular(square) & is_regular(reach);
        (are_regular & is_regular(quotient))
            .when(quotient.sqrt())
            .or_else(|| are_regular.when(quotient_of_roots(reach, square)))
            .or_else_of(
                (direction.into(), moment.into(), point.coordinates()),
                |(direction, moment, point)| distance_of_any(direction, moment, point),
            )
    }

    /// The point nearest to the origin and the unit direction; `None` for a line of weight zero, or
    /// beyond the range of the scalar.
    #[inline]
    pub(super) fn parts(self) -> Maybe<(Vector<S>, Vector<S>), S> {
        let (direction, moment) = self.vectors();
        let square = direction.length_squared();
        let place = direction.cross(moment).divided(square);
        (is_regular(square) & are_numbers(place.coordinates()))
            .when((place, direction.divided(square.sqrt())))
            .or_else_of((direction.into(), moment.into()), |(direction, moment)| {
                let parts = parts_of_any(direction, moment);
                parts.map(|[place, direction]| (place.into(), direction.into()))
            })
    }
}

impl<S: Ring> Line<S> {
    /// The line with a direction and a moment that are perpendicular.
    #[inline]
    pub(super) fn from_vectors(direction: Vector<S>, moment: Vector<S>) -> Self {
        let ([d1, d2, d3], [m1, m2, m3]) = (direction.into(), moment.into());
        Self::new(m3, -m2, m1, -d1, -d2, -d3)
    }

    /// The direction and the moment.
    #[inline]
    pub(super) fn vectors(self) -> (Vector<S>, Vector<S>) {
        (self.direction().into(), self.moment().into())
    }
}

/// The point nearest to the origin and the unit direction of a line of any weight.
fn unit_parts<S: Real>(
    direction: Vector<S>,
    moment: Vector<S>,
) -> Maybe<(Vector<S>, Vector<S>), S> {
    let weight = direction.length();
    direction.normalized().and_then(|unit| {
        let place = unit.cross(moment.divided(weight));
        (weight.is_finite() & place.is_finite()).when((place, unit))
    })
}

// Outlined code takes and returns arrays made for it, so that the numbers of its callers stay in
// registers.

#[cold]
#[inline(never)]
fn parts_of_any<S: Real>(direction: [S; 3], moment: [S; 3]) -> Maybe<[[S; 3]; 2], S> {
    let parts = unit_parts(direction.into(), moment.into());
    parts.map(|(place, direction)| [place.into(), direction.into()])
}

#[cold]
#[inline(never)]
fn foot_of_any<S: Real>(direction: [S; 3], moment: [S; 3], point: [S; 3]) -> Maybe<[S; 3], S> {
    let place = unit_parts(direction.into(), moment.into()).map(|(support, direction)| {
        let along = (Vector::from(point) - support).dot(direction);
        support + direction * along
    });
    place.filter(|place| place.is_finite()).map(Vector::into)
}

#[cold]
#[inline(never)]
fn distance_of_any<S: Real>(direction: [S; 3], moment: [S; 3], point: [S; 3]) -> Maybe<S, S> {
    foot_of_any(direction, moment, point)
        .map(|foot| Vector::from(foot).distance(point.into()))
        .filter(|distance| distance.is_finite())
}

/// `√a/√b`, for numbers whose quotient is too large or too small.
#[cold]
#[inline(never)]
fn quotient_of_roots<S: Real>(a: S, b: S) -> S {
    a.sqrt() / b.sqrt()
}
