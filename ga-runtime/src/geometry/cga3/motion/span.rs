//! The basis functions of cubic splines between their knots.

use alloc::vec::Vec;

use super::spline::SplineError;
use crate::cga3::Motor;
use crate::scalar::Real;

/// The time between two keys, with the four basis functions that are not zero there, as polynomials
/// in the position from 0 to 1, the lowest power first.
pub(super) struct Span<S> {
    pub(super) start: S,
    pub(super) duration: S,
    basis: [[S; 4]; 4],
}

impl<S: Real<Mask = bool>> Span<S> {
    /// The sums of the basis functions from the second, the third and the fourth on.
    pub(super) fn shares(&self) -> [[S; 4]; 3] {
        let [_, b1, b2, b3] = self.basis;
        let sum = |a: [S; 4], b: [S; 4]| core::array::from_fn(|k| a[k] + b[k]);
        let last_two = sum(b2, b3);
        [sum(b1, last_two), last_two, b3]
    }
}

/// The spans between keys, with the knots at the keys, those at the ends fourfold.
pub(super) fn spans<S: Real<Mask = bool>>(
    keys: &[(S, Motor<S>)],
) -> Result<Vec<Span<S>>, SplineError<S>> {
    let last = keys.len() - 1;
    let knot = |index: usize, shift: isize| {
        let place = index.saturating_add_signed(shift).min(last);
        keys[place].0
    };
    (0..last)
        .map(|index| {
            let start = knot(index, 0);
            let duration = knot(index, 1) - start;
            // Differences of knots from the start, in durations.
            let at = |shift| (knot(index, shift) - start) / duration;
            let [left, right] = [[0, -1, -2], [1, 2, 3]].map(|shifts: [isize; 3]| shifts.map(at));
            let is_usable = duration.is_finite() && duration.recip().is_finite();
            let are_usable = left.into_iter().chain(right).all(Real::is_finite);
            if !is_usable || !are_usable {
                return Err(SplineError::OutOfRange { index });
            }
            Ok(Span {
                start,
                duration,
                basis: basis(left, right),
            })
        })
        .collect()
}

/// The basis functions by the recurrence of Cox and de Boor (Piegl and Tiller, The NURBS Book,
/// 1997, algorithm A2.2), on polynomials: the span is from 0 to 1, and `left` and `right` are the
/// knots from its ends outwards.
fn basis<S: Real>(left: [S; 3], right: [S; 3]) -> [[S; 4]; 4] {
    let zero = S::zero();
    let mut basis = [[zero; 4]; 4];
    basis[0][0] = S::one();
    for degree in 1..4 {
        let mut saved = [zero; 4];
        for r in 0..degree {
            let (above, below) = (right[r], left[degree - 1 - r]);
            let share = basis[r].map(|c| c / (above - below));
            // Times `above − s` and times `s − below`.
            let shifted = [zero, share[0], share[1], share[2]];
            basis[r] = core::array::from_fn(|k| saved[k] + above * share[k] - shifted[k]);
            saved = core::array::from_fn(|k| shifted[k] - below * share[k]);
        }
        basis[degree] = saved;
    }
    basis
}
