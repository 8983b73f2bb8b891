//! The common form of point pairs and dual circles: a bivector `(c + eo + β ei) ∧ (d + (c·d) ei)`.
//!
//! c is the centre. A point pair `p∧q` has that form with its axis d and `β = ½(c² + r²)`; the dual
//! of a circle has it with the normal d of its plane and `β = ½(c² − r²)`.

use crate::cga3::{DualCircle, Point};
use crate::geometry::number::is_number;
use crate::scalar::{Field, Real};
use crate::vga3::Vector;

/// The parts of such a bivector.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoundBivector<S> {
    pub(super) centre: Vector<S>,
    /// d, of length 1.
    pub(super) axis: Vector<S>,
    /// β.
    pub(super) infinite: S,
}

impl<S: Field> RoundBivector<S> {
    /// The coefficients, with weight 1 for an axis of length 1.
    pub(super) fn to_bivector(self) -> DualCircle<S> {
        let (c, d) = (self.centre, self.axis);
        let along = c.dot(d);
        let [m1, m2, m3] = c.cross(d).coordinates();
        let [x1, x2, x3] = [0, 1, 2].map(|k| c[k] * along - d[k] * self.infinite);
        let [d1, d2, d3] = d.coordinates();
        DualCircle::new(m3, -m2, m1, -d1, -d2, -d3, x1, x2, x3, along)
    }
}

impl<S: Real<Mask = bool>> RoundBivector<S> {
    /// `None` for a flat one, where d vanishes, or where centre or β are beyond the range of the
    /// scalar.
    pub(super) fn of(bivector: DualCircle<S>) -> Option<Self> {
        let b = bivector / scale(bivector)?;
        let direction = [-b.e1o, -b.e2o, -b.e3o];
        // Divided by d² only once, so that exact values stay exact.
        let direction = Vector::from(direction);
        let square = direction.dot(direction);
        let moment = Vector::new(b.e23, -b.e13, b.e12);
        let centre = (direction * b.eoi + direction.cross(moment)).divided(square);
        let last = direction.dot(Vector::new(b.e1i, b.e2i, b.e3i));
        let infinite = (b.eoi * b.eoi - last) / square;
        let length = square.sqrt();
        let is_finite = centre.is_finite() && is_number(infinite);
        is_finite.then(|| Self {
            centre,
            axis: direction.divided(length),
            infinite,
        })
    }

    /// The centre as a point.
    pub(super) fn centre(self) -> Point<S> {
        Point::from(self.centre)
    }

    /// `2β` and `c²`: their difference is the squared radius of a point pair, or minus the squared
    /// radius of a dual circle.
    pub(super) fn squares(self) -> [S; 2] {
        [self.infinite + self.infinite, self.centre.dot(self.centre)]
    }

    /// `2β − c²`. `None` beyond the range of the scalar.
    pub(super) fn signed_square(self) -> Option<S> {
        let [a, b] = self.squares();
        is_number(a - b).then_some(a - b)
    }
}

/// The root of `r² = a − b`; `None` where r² is negative or not finite.
///
/// The coefficients of a round determine r² only as a difference of squared lengths, so that a
/// difference below 32 ε (|a| + |b|) is rounding and is treated as zero: a tangent has a real
/// radius, even if r² was rounded to a negative number.
pub(super) fn real_radius<S: Real<Mask = bool>>([a, b]: [S; 2]) -> Option<S> {
    let squared = a - b;
    let rounding = S::epsilon() * S::from_integer(32) * (a.abs() + b.abs());
    if !squared.is_finite() {
        None
    } else if !rounding.less_than(squared.abs()) {
        Some(S::zero())
    } else {
        S::zero().less_than(squared).then(|| squared.sqrt())
    }
}

/// The divisor that brings d² into range: 1 wherever possible. `None` where d is zero or not
/// finite.
fn scale<S: Real<Mask = bool>>(b: DualCircle<S>) -> Option<S> {
    let direction = Vector::new(b.e1o, b.e2o, b.e3o);
    let square = direction.length_squared();
    let (least, most) = (S::from_f64(1e-12), S::from_f64(1e12));
    if least.less_than(square) && square.less_than(most) {
        return Some(S::one());
    }
    let length = direction.length();
    (S::zero().less_than(length) && length.is_finite()).then_some(length)
}
