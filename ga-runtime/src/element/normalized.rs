//! Norms for elements of unit norm.

use super::Element;
use crate::scalar::{Real, Ring};

/// The largest absolute value of a coefficient; `None` where it is zero or not finite.
pub fn largest<T: Element<Scalar: Real<Mask = bool>>>(element: T) -> Option<T::Scalar> {
    let zero = T::Scalar::zero();
    let coefficients = element.coefficients();
    let largest = coefficients.fold(zero, |most, (_, x)| most.max(x.abs()));
    (element.is_finite() && zero.less_than(largest)).then_some(largest)
}

/// An element and the absolute value of its squared norm, both of them divided so that the latter
/// neither overflows nor underflows; `None` where it is zero, or a coefficient is not finite.
/// `measured` are the coefficients on which the norm depends.
#[inline]
pub fn scaled_norm<T: Copy, S: Real<Mask = bool>, const N: usize>(
    element: T,
    norm_squared: impl Fn(T) -> S,
    measured: [S; N],
    divided: impl Fn(T, S) -> T,
) -> Option<(T, S)> {
    let size = norm_squared(element).abs();
    let least = S::epsilon() * S::epsilon();
    if least.less_than(size) && size.is_finite() {
        return Some((element, size));
    }
    let zero = S::zero();
    let largest = measured.into_iter().fold(zero, |most, x| most.max(x.abs()));
    if !zero.less_than(largest) || !largest.is_finite() {
        return None;
    }
    // The squares of coefficients up to one stay within the range of the scalar.
    let scaled = divided(element, largest);
    let size = norm_squared(scaled).abs();
    (zero.less_than(size) && size.is_finite()).then_some((scaled, size))
}

/// Numbers divided by the largest absolute value of some of them; `None` where that is zero or not
/// finite. It takes and returns arrays, so that the numbers of its callers stay in registers.
#[cold]
#[inline(never)]
pub fn divided_by_largest<S: Real<Mask = bool>, const N: usize, const M: usize>(
    numbers: [S; N],
    measured: [S; M],
) -> Option<[S; N]> {
    let zero = S::zero();
    let largest = measured.into_iter().fold(zero, |most, x| most.max(x.abs()));
    (zero.less_than(largest) && largest.is_finite()).then(|| numbers.map(|x| x / largest))
}
