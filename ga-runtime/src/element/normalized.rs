//! Norms for elements of unit norm.

use super::Element;
use crate::scalar::{Mask, Maybe, Real, Ring};

/// The largest absolute value of a coefficient; none where it is zero or not finite.
pub fn largest<T: Element<Scalar: Real>>(element: T) -> Maybe<T::Scalar, T::Scalar> {
    let zero = T::Scalar::zero();
    let coefficients = element.coefficients();
    let largest = coefficients.fold(zero, |most, (_, x)| most.max(x.abs()));
    (element.is_finite() & zero.less_than(largest)).when(largest)
}

/// An element and the absolute value of its squared norm, both of them divided so that the latter
/// neither overflows nor underflows; none where it is zero, or a coefficient is not finite.
/// `measured` are the coefficients on which the norm depends.
#[inline]
pub fn scaled_norm<T: Copy, S: Real, const N: usize>(
    element: T,
    norm_squared: impl Fn(T) -> S,
    measured: [S; N],
    divided: impl Fn(T, S) -> T,
) -> Maybe<(T, S), S> {
    let size = norm_squared(element).abs();
    let least = S::epsilon() * S::epsilon();
    let is_regular = least.less_than(size) & size.is_finite();
    if is_regular.all() {
        return is_regular.when((element, size));
    }
    let (zero, one) = (S::zero(), S::one());
    let largest = measured.into_iter().fold(zero, |most, x| most.max(x.abs()));
    let has_size = zero.less_than(largest) & largest.is_finite();
    // The squares of coefficients up to one stay within the range of the scalar. Lanes that need no
    // division are divided by one, which changes nothing.
    let scaled = divided(element, S::select(is_regular, one, largest));
    let size = norm_squared(scaled).abs();
    (has_size & zero.less_than(size) & size.is_finite()).when((scaled, size))
}

/// Numbers divided by the largest absolute value of some of them, where they are not regular. Those
/// become NaN where all of them are zero or one of them is not finite. It takes and returns arrays,
/// so that the numbers of its callers stay in registers.
#[cold]
#[inline(never)]
pub fn divided_by_largest<S: Real, const N: usize, const M: usize>(
    is_regular: S::Mask,
    numbers: [S; N],
    measured: [S; M],
) -> [S; N] {
    let largest = measured
        .into_iter()
        .fold(S::zero(), |most, x| most.max(x.abs()));
    let divisor = S::select(is_regular, S::one(), largest);
    numbers.map(|x| x / divisor)
}
