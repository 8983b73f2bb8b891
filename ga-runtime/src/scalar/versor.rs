//! The scalar functions in exponentials of bivectors and logarithms of versors.

use super::{Field, Mask, Real};

/// C, S and S′ of `exp B = C(B²) + S(B²) B` at `x = B²`.
///
/// For x < 0 a rotation, C = cos √−x and S = sin √−x / √−x; for x > 0 a boost or a scaling, with
/// cosh and sinh; at x = 0 both are 1. `S′ = (C − S)/(2x)` is the derivative of S, for bivectors
/// whose square has a part of square zero besides the scalar. What is too large for a float is +∞.
///
/// ```
/// use ga_runtime::scalar::versor_exponential;
/// let (c, s, slope) = versor_exponential(-std::f64::consts::FRAC_PI_2.powi(2));
/// assert!(c.abs() < 1e-15 && (s - std::f64::consts::FRAC_2_PI).abs() < 1e-15 && slope > 0.0);
/// assert_eq!(versor_exponential(0.0), (1.0, 1.0, 1.0 / 6.0));
/// ```
#[inline]
pub fn versor_exponential<S: Real>(x: S) -> (S, S, S) {
    let one = S::one();
    let angle = x.abs().sqrt();
    let is_tiny = is_tiny(x);
    // Never zero, so that no lane divides by zero.
    let divisor = S::select(is_tiny, one, angle);
    let (sine, cosine) = angle.sin_cos();
    let (mut c, mut s) = (cosine, sine / divisor);
    let is_growing = S::zero().less_than(x);
    let mut is_large = is_growing;
    if is_growing.any() {
        let exponential = angle.exp();
        is_large = is_growing & !exponential.is_finite();
        let inverse = exponential.recip();
        let half = S::from_ratio(1, 2);
        c = S::select(is_growing, half * (exponential + inverse), c);
        s = S::select(is_growing, half * (exponential - inverse) / divisor, s);
    }
    let mut slope = (c - s) / (S::select(is_tiny, one, x) + S::select(is_tiny, one, x));
    if is_tiny.any() {
        s = S::select(is_tiny, sine_series(x), s);
        slope = S::select(is_tiny, slope_series(x), slope);
    }
    if is_large.any() {
        let (large_c, large_s, large_slope) = large(x, angle);
        c = S::select(is_large, large_c, c);
        s = S::select(is_large, large_s, s);
        slope = S::select(is_large, large_slope, slope);
    }
    (c, s, slope)
}

/// C, S and S′ where the exponential of the angle is infinite: `C = eᵃ/2`, `S = C/a` and
/// `S′ = (C − S)/2a²` to rounding. Infinite values come from products of finite numbers, so that a
/// derivative of zero stays zero.
fn large<S: Real>(x: S, angle: S) -> (S, S, S) {
    let (one, half) = (S::one(), S::from_ratio(1, 2));
    let is_single = S::from_f64(1e-10).less_than(S::epsilon());
    let limit = S::select(is_single, S::from_integer(120), S::from_integer(1000));
    // Above the limit all three are infinite, and grow.
    let is_huge = limit.less_than(angle);
    let bounded = S::select(is_huge, limit + (angle / limit).ln(), angle);
    let root = (half * bounded).exp();
    let sine = S::select(is_huge, one, angle.recip());
    let slope = S::select(is_huge, one, half * (one - sine) / x);
    let c = half * root;
    (c * root, sine * c * root, slope * c * root)
}

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

fn is_tiny<S: Real>(x: S) -> S::Mask {
    x.abs().less_than(S::from_ratio(1, 16))
}

/// `S(x) = Σ xᵏ/(2k + 1)!`.
fn sine_series<S: Field>(x: S) -> S {
    let denominators = [6_227_020_800, 39_916_800, 362_880, 5_040, 120, 6, 1];
    denominators
        .into_iter()
        .fold(S::zero(), |sum, d| sum * x + S::from_ratio(1, d))
}

/// `S′(x) = Σ (k + 1) xᵏ/(2k + 3)!`.
fn slope_series<S: Field>(x: S) -> S {
    let coefficients = [
        (7, 1_307_674_368_000),
        (6, 6_227_020_800),
        (5, 39_916_800),
        (4, 362_880),
        (3, 5_040),
        (2, 120),
        (1, 6),
    ];
    coefficients
        .into_iter()
        .fold(S::zero(), |sum, (n, d)| sum * x + S::from_ratio(n, d))
}
