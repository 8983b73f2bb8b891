//! The common form of point pairs and dual circles: a bivector `(c + eo + β ei) ∧ (d + (c·d) ei)`.
//!
//! c is the centre. A point pair `p∧q` has that form with its axis d and `β = ½(c² + r²)`; the dual
//! of a circle has it with the normal d of its plane and `β = ½(c² − r²)`.

use crate::cga3::{DualCircle, Point};
use crate::geometry::number::{are_numbers, is_moderate, is_number, is_regular};
use crate::scalar::{Field, Real, Ring};
use crate::vga3::Vector;

/// The parts of such a bivector.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoundBivector<S> {
    pub(super) centre: Vector<S>,
    /// d, of any length.
    pub(super) direction: Vector<S>,
    /// `1/d²`.
    pub(super) inverse: S,
    /// β.
    pub(super) infinite: S,
}

impl<S: Real<Mask = bool>> RoundBivector<S> {
    /// `None` for a flat one, where d vanishes, or where centre or β are beyond the range of the
    /// scalar.
    #[inline(always)]
    pub(super) fn of(bivector: DualCircle<S>) -> Option<Self> {
        Self::parts(bivector, false)
    }

    /// The same; `None` also where `2β − c²` is beyond the range of the scalar.
    #[inline(always)]
    pub(super) fn with_square(bivector: DualCircle<S>) -> Option<Self> {
        Self::parts(bivector, true)
    }

    #[inline(always)]
    fn parts(b: DualCircle<S>, needs_square: bool) -> Option<Self> {
        let direction = Vector::new(-b.e1o, -b.e2o, -b.e3o);
        let moment = Vector::new(b.e23, -b.e13, b.e12);
        let last = Vector::new(b.e1i, b.e2i, b.e3i);
        let round = Self::divided(direction, moment, last, b.eoi);
        let [twice, centre_squared] = round.squares();
        let sizes = direction.length_squared() + round.inverse;
        if is_moderate(sizes + twice.abs() + centre_squared) {
            return Some(round);
        }
        let [centre, direction, [inverse, infinite, _]] =
            scaled([direction, moment, last].map(Vector::coordinates), b.eoi)?;
        let round = Self {
            centre: centre.into(),
            direction: direction.into(),
            inverse,
            infinite,
        };
        if needs_square {
            round.signed_square()?;
        }
        Some(round)
    }

    #[inline(always)]
    fn divided(d: Vector<S>, moment: Vector<S>, last: Vector<S>, along: S) -> Self {
        let inverse = d.dot(d).recip();
        Self {
            centre: (d * along + d.cross(moment)) * inverse,
            direction: d,
            inverse,
            infinite: (along * along - d.dot(last)) * inverse,
        }
    }

    /// The centre as a point.
    #[inline]
    pub(super) fn centre(self) -> Point<S> {
        Point::from(self.centre)
    }

    /// d, of length 1.
    #[inline(always)]
    pub(super) fn axis(self) -> Vector<S> {
        self.direction * self.inverse.sqrt()
    }

    /// d, of a given length.
    #[inline(always)]
    pub(super) fn reach(self, length_squared: S) -> Vector<S> {
        let factor = length_squared * self.inverse;
        let factor = if is_regular(factor) {
            factor.sqrt()
        } else {
            product_of_roots(length_squared, self.inverse)
        };
        self.direction * factor
    }

    /// `2β` and `c²`: their difference is the squared radius of a point pair, or minus the squared
    /// radius of a dual circle.
    #[inline(always)]
    pub(super) fn squares(self) -> [S; 2] {
        [self.infinite + self.infinite, self.centre.dot(self.centre)]
    }

    /// `2β − c²`. `None` beyond the range of the scalar.
    #[inline(always)]
    pub(super) fn signed_square(self) -> Option<S> {
        let [a, b] = self.squares();
        is_number(a - b).then_some(a - b)
    }
}

/// The parts where d² or a product with d is beyond the regular range: centre, direction, and d²
/// with β. It takes and returns arrays made for it, so that the numbers of its callers stay in
/// registers.
#[cold]
#[inline(never)]
fn scaled<S: Real<Mask = bool>>(vectors: [[S; 3]; 3], along: S) -> Option<[[S; 3]; 3]> {
    let vectors = vectors.map(Vector::from);
    let length = vectors[0].length();
    if !S::zero().less_than(length) || !length.is_finite() {
        return None;
    }
    let [direction, moment, last] = vectors.map(|vector| vector.divided(length));
    let round = RoundBivector::divided(direction, moment, last, along / length);
    let Vector { e1, e2, e3 } = round.centre;
    if !are_numbers([e1, e2, e3, round.infinite]) {
        return None;
    }
    let numbers = [round.inverse, round.infinite, S::zero()];
    Some([round.centre.into(), round.direction.into(), numbers])
}

/// √a/√b, where a/b is beyond the regular range.
#[cold]
#[inline(never)]
pub(super) fn quotient_of_roots<S: Real>(a: S, b: S) -> S {
    a.sqrt() / b.sqrt()
}

/// √a √b, where a b is beyond the regular range.
#[cold]
#[inline(never)]
fn product_of_roots<S: Real>(a: S, b: S) -> S {
    a.sqrt() * b.sqrt()
}

/// A vector divided by its length, by one division where its square is regular.
#[inline(always)]
pub(super) fn unit_axis<S: Real<Mask = bool>>(axis: [S; 3]) -> Option<Vector<S>> {
    let vector = Vector::from(axis);
    let square = vector.length_squared();
    if is_regular(square) {
        return Some(vector * square.sqrt().recip());
    }
    unit_axis_of_any(axis).map(Vector::from)
}

#[cold]
#[inline(never)]
fn unit_axis_of_any<S: Real<Mask = bool>>(axis: [S; 3]) -> Option<[S; 3]> {
    Vector::from(axis).normalized().map(Vector::coordinates)
}

/// The bivector with the centre c, the unit axis d and β. Its weight is 1.
#[inline]
pub(super) fn bivector<S: Field>(c: Vector<S>, d: Vector<S>, infinite: S) -> DualCircle<S> {
    let along = c.dot(d);
    let [m1, m2, m3] = c.cross(d).coordinates();
    let [x1, x2, x3] = (c * along - d * infinite).coordinates();
    let [d1, d2, d3] = d.coordinates();
    DualCircle::new(m3, -m2, m1, -d1, -d2, -d3, x1, x2, x3, along)
}

/// Whether all coefficients of a bivector are finite.
#[inline]
pub(super) fn is_finite<S: Ring>(b: DualCircle<S>) -> bool {
    are_numbers([
        b.e12, b.e13, b.e23, b.e1o, b.e2o, b.e3o, b.e1i, b.e2i, b.e3i, b.eoi,
    ])
}

/// The square r² = a − b; `None` where it is negative or not finite.
///
/// The coefficients of a round determine r² only as a difference of squared lengths, so that a
/// difference below 32 ε (|a| + |b|) is rounding and is treated as zero: a tangent has a real
/// radius, even if r² was rounded to a negative number.
#[inline(always)]
pub(super) fn real_square<S: Real<Mask = bool>>([a, b]: [S; 2]) -> Option<S> {
    let squared = a - b;
    if rounding([a, b]).less_than(squared) {
        return Some(squared);
    }
    zero_or_imaginary([a, b])
}

/// The square a − b where it is positive by more than rounding.
#[inline(always)]
pub(super) fn positive_square<S: Real<Mask = bool>>([a, b]: [S; 2]) -> Option<S> {
    rounding([a, b]).less_than(a - b).then(|| a - b)
}

/// The difference a − b below which it is rounding.
#[inline(always)]
pub(super) fn rounding<S: Real>([a, b]: [S; 2]) -> S {
    S::epsilon() * S::from_integer(32) * (a.abs() + b.abs())
}

/// Zero where a difference is rounding; `None` where it is negative or not a number.
#[cold]
#[inline(never)]
fn zero_or_imaginary<S: Real<Mask = bool>>([a, b]: [S; 2]) -> Option<S> {
    let squared = a - b;
    let is_zero = squared.is_finite() && !rounding([a, b]).less_than(squared.abs());
    is_zero.then(S::zero)
}

/// The root of [`real_square`].
#[inline(always)]
pub(super) fn real_radius<S: Real<Mask = bool>>(squares: [S; 2]) -> Option<S> {
    real_square(squares).map(S::sqrt)
}
