//! Tests of the range of numbers, and an accurate logarithm.

use crate::scalar::{Real, Ring};

/// Whether a number is finite, in a ring that may have infinity and NaN; of lanes, whether all are.
#[expect(clippy::eq_op, reason = "NaN where the number is not finite")]
#[inline]
pub(super) fn is_finite_number<S: Ring>(x: S) -> bool {
    x - x == S::zero()
}

/// Whether a number is finite: the difference of infinity and of NaN from themselves is NaN.
#[expect(clippy::eq_op, reason = "NaN where the number is not finite")]
#[inline]
pub(crate) fn is_number<S: Real>(x: S) -> S::Mask {
    (x - x).is_zero()
}

/// Whether all components are finite.
#[expect(clippy::eq_op, reason = "NaN where a component is not finite")]
#[inline]
pub(crate) fn are_numbers<S: Real, const N: usize>(components: [S; N]) -> S::Mask {
    let mut sum = S::zero();
    for x in components {
        sum += x - x;
    }
    sum.is_zero()
}

/// Whether a squared length is so far from both ends of the range of every scalar that a sum of
/// such squares is accurate. Formulas without scaling are used where it is, careful ones elsewhere.
#[inline]
pub(crate) fn is_regular<S: Real>(square: S) -> S::Mask {
    S::from_f64(1e-24).less_than(square) & square.less_than(S::from_f64(1e24))
}

/// Whether a number that is not negative is finite, and so small that sums and products of two such
/// numbers are finite too.
///
/// A sum of numbers that are not negative is moderate only if each of them is. Where one of them is
/// a square and another its inverse, the square is regular: one comparison says it of all.
#[inline]
pub(crate) fn is_moderate<S: Real>(x: S) -> S::Mask {
    x.less_than(S::from_f64(1e18))
}

/// `ln(1 + y)` as `y ln u/(u − 1)` for `u = 1 + y`, which is exact to rounding (Higham, Accuracy
/// and Stability of Numerical Algorithms, 2002, 1.14.1).
pub(super) fn logarithm_above_one<S: Real<Mask = bool>>(y: S) -> S {
    let u = S::one() + y;
    let difference = u - S::one();
    if difference == S::zero() {
        y
    } else {
        y * (u.ln() / difference)
    }
}
