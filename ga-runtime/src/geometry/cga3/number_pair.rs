//! Numbers `a + b q` with a scalar square `q² = β`: complex for negative β, dual for zero, double
//! for positive.
//!
//! The square of a bivector of the conformal algebra is such a number, where q is a 4-vector that
//! commutes with the bivector, and so is the even part of the bivector's exponential. Power series
//! of these numbers need no distinction by the sign of β.

use crate::scalar::Real;

/// `1 + f₁ z (1 + f₂ z (1 + …))` for `z = scalar + rest q`, with the factors given from the first
/// to the last.
pub(super) fn nested_series<S: Real>(
    [scalar, rest]: [S; 2],
    square: S,
    factors: impl DoubleEndedIterator<Item = S>,
) -> [S; 2] {
    factors.rev().fold([S::one(), S::zero()], |[a, b], factor| {
        [
            S::one() + factor * (a * scalar + b * rest * square),
            factor * (a * rest + b * scalar),
        ]
    })
}

/// The factors of `cosh √z`.
pub(super) fn cosh_factors<S: Real>() -> impl DoubleEndedIterator<Item = S> {
    (1..=10_i64).map(|n| S::from_ratio(1, (2 * n - 1) * (2 * n)))
}

/// The factors of `sinh √z / √z`.
pub(super) fn sinh_ratio_factors<S: Real>() -> impl DoubleEndedIterator<Item = S> {
    (1..=10_i64).map(|n| S::from_ratio(1, 2 * n * (2 * n + 1)))
}

/// The factors of `arsinh √z / √z`.
pub(super) fn arsinh_ratio_factors<S: Real>() -> impl DoubleEndedIterator<Item = S> {
    (1..=11_i64).map(|n| S::from_ratio(-(2 * n - 1) * (2 * n - 1), 2 * n * (2 * n + 1)))
}

/// `cosh √x` and `sinh √x / √x`, which are `cos √−x` and `sin √−x / √−x` for negative x.
pub(super) fn cosh_and_sinh_ratio<S: Real<Mask = bool>>(x: S) -> (S, S) {
    if !S::one().less_than(x.abs()) {
        let real = [x, S::zero()];
        let [cosh, _] = nested_series(real, S::zero(), cosh_factors());
        let [ratio, _] = nested_series(real, S::zero(), sinh_ratio_factors());
        return (cosh, ratio);
    }
    let root = x.abs().sqrt();
    if x.less_than(S::zero()) {
        let (sine, cosine) = root.sin_cos();
        return (cosine, sine / root);
    }
    let (half, grown) = (S::from_ratio(1, 2), root.exp());
    let shrunk = grown.recip();
    ((grown + shrunk) * half, (grown - shrunk) * half / root)
}

/// `arsinh √x / √x`, which is `arcsin √−x / √−x` for x in (−1, 0).
pub(super) fn arsinh_ratio<S: Real<Mask = bool>>(x: S) -> S {
    if !S::from_ratio(1, 32).less_than(x.abs()) {
        return nested_series([x, S::zero()], S::zero(), arsinh_ratio_factors())[0];
    }
    let (root, cosh) = (x.abs().sqrt(), (S::one() + x).sqrt());
    if x.less_than(S::zero()) {
        root.atan2(cosh) / root
    } else {
        (root + cosh).ln() / root
    }
}
