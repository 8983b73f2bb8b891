//! A smooth step.

use super::Real;

/// The smooth step of shading languages: 0 up to `low`, 1 from `high` on, and between them
/// `t² (3 − 2t)` with `t = (x − low)/(high − low)`, whose slope is zero at both ends (Hermite).
/// Where `low` is not below `high` it jumps at `low`. Both ends are finite; NaN stays NaN.
///
/// ```
/// use ga_runtime::scalar::smooth_step;
/// let step = |x: f64| smooth_step(2.0, 4.0, x);
/// assert_eq!([step(1.0), step(2.5), step(3.0), step(9.0)], [0.0, 0.15625, 0.5, 1.0]);
/// ```
#[inline]
#[must_use]
pub fn smooth_step<S: Real>(low: S, high: S, x: S) -> S {
    let (zero, one) = (S::zero(), S::one());
    let is_wide = low.less_than(high);
    let width = S::select(is_wide, high - low, one);
    // Where the width overflows, everything is halved.
    let scale = S::select(width.is_finite(), one, S::from_ratio(1, 2));
    let (low_end, high_end) = (low * scale, high * scale);
    let width = S::select(is_wide, high_end - low_end, one);
    let t = ((x * scale - low_end) / width).max(zero).min(one);
    let smooth = t * t * (S::from_integer(3) - S::from_integer(2) * t);
    // At the jump itself 1, and NaN for NaN.
    let at_jump = one + (x - low) * zero;
    let above = S::select(low.less_than(x), one, at_jump);
    let jump = S::select(x.less_than(low), zero, above);
    S::select(is_wide, smooth, jump)
}
