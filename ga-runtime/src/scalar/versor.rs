//! The scalar functions in logarithms of versors.

use super::real::{is_tiny, slope_series};
use super::{Mask, Real};

/// 1/S(x) and `−2 S′(x)/S(x)³` from C(x) and `q = S(x)² x`: the factors by which `B = W/S` follows
/// from `exp B = c + W`, where q = W².
///
/// For q < 0 the angle √−x lies in [0, π]. At c = −1, q = 0 the bivector B is not determined, and
/// the factors are those of c = 1. For q > 0 and c < 0 there is no logarithm; the factors are those
/// of the negative versor, which acts in the same way, with the sign of W.
///
/// ```
/// use ga_runtime::scalar::{versor_exponential, versor_logarithm};
/// let x = -2.0_f64;
/// let (c, s, slope) = versor_exponential(x);
/// let (inverse, change) = versor_logarithm(c, s * s * x);
/// assert!((inverse * s - 1.0).abs() < 1e-15 && (change * s * s * s + 2.0 * slope).abs() < 1e-15);
/// ```
#[inline]
pub fn versor_logarithm<S: Real>(c: S, q: S) -> (S, S) {
    let (zero, one) = (S::zero(), S::one());
    let sine = q.abs().sqrt();
    let is_zero = sine.is_zero();
    let divisor = S::select(is_zero, one, sine);
    let mut ratio = sine.atan2(c) / divisor;
    let is_growing = zero.less_than(q);
    if is_growing.any() {
        // arsinh x = ln(1 + y) with y = x + x²/(1 + √(1 + x²)), and ln(1 + y) = y ln u/(u − 1) for
        // u = 1 + y, which is exact to rounding (Higham, Accuracy and Stability of Numerical
        // Algorithms, 2002, 1.14.1).
        let y = sine + q / (one + (one + q).sqrt());
        let u = one + y;
        let difference = u - one;
        let is_lost = !zero_less(difference);
        let quotient = u.ln() / S::select(is_lost, one, difference);
        let length = y * S::select(is_lost, one, quotient);
        let signed = S::select(c.less_than(zero), -length, length);
        ratio = S::select(is_growing, signed / divisor, ratio);
    }
    // If the cosine is NaN, so is the result.
    ratio = S::select(is_zero, one + c * zero, ratio);
    let x = q * ratio * ratio;
    let is_tiny = is_tiny(x);
    // The slope is the coefficient of a product of two parts that change sign together.
    let cube = ratio.abs() * ratio * ratio;
    let slope = S::select(
        is_tiny,
        -(slope_series(x) + slope_series(x)) * cube,
        -(c * ratio - one) / S::select(is_tiny, one, q),
    );
    (ratio, slope)
}

fn zero_less<S: Real>(x: S) -> S::Mask {
    S::zero().less_than(x)
}
