//! Real numbers, and the functions of those that bring none of their own: exponentials of
//! bivectors, hyperbolic functions and the hypotenuse.

use super::half_angle::{self, Constant};
use super::{ArcFactors, Field, Lanes, Mask, Select, arc};
use crate::cga3::Motor;

/// A field with roots, angles and an order: floating-point numbers, single, in lanes or with
/// derivatives.
///
/// Comparisons return a [`Mask`](Select::Mask), and [`select`](Select::select) chooses by it, so
/// that the same code runs on one number and on lanes. A result that may not exist is a
/// [`Maybe`](super::Maybe).
///
/// ```
/// use ga_runtime::scalar::Real;
/// fn clamp_below<S: Real>(x: S, least: S) -> S {
///     S::select(x.less_than(least), least, x)
/// }
/// assert_eq!(clamp_below(-1.0, 0.0), 0.0);
/// ```
pub trait Real: Field + Select {
    /// The constant as a scalar, rounded.
    fn from_f64(value: f64) -> Self;
    /// The distance from 1 to the next larger number.
    fn epsilon() -> Self;
    /// `√self`.
    fn sqrt(self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The angle in radians, in (−π, π], of the point (`x`, `self`).
    fn atan2(self, x: Self) -> Self;
    /// The exponential function.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// Whether `self < other`; false where either is NaN.
    fn less_than(self, other: Self) -> Self::Mask;
    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> Self::Mask;
    /// Whether the number is zero, and all its derivatives if it has any.
    fn is_zero(self) -> Self::Mask;

    /// Whether `self ≤ other`; false where either is NaN.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// assert!(2.0.less_or_equal(2.0) && !3.0_f64.less_or_equal(2.0));
    /// assert!(!f64::NAN.less_or_equal(f64::NAN));
    /// ```
    #[inline]
    fn less_or_equal(self, other: Self) -> Self::Mask {
        self.less_than(other) | self.equals(other)
    }
    /// Whether `self = other`, without regard to derivatives; false where either is NaN.
    ///
    /// ```
    /// use ga_runtime::scalar::{Dual, Real};
    /// assert!(0.0.equals(-0.0) && f64::INFINITY.equals(f64::INFINITY));
    /// assert!(!f64::NAN.equals(f64::NAN));
    /// assert!(Dual::<f64>::variable(2.0).equals(Dual::constant(2.0)));
    /// ```
    #[inline]
    fn equals(self, other: Self) -> Self::Mask {
        // A number that is not NaN is below 1 or above 0.
        let is_number = |x: Self| x.less_than(Self::one()) | Self::zero().less_than(x);
        let differs = self.less_than(other) | other.less_than(self);
        !differs & is_number(self) & is_number(other)
    }
    /// Sine of an angle in radians.
    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    /// Cosine of an angle in radians.
    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    /// The hyperbolic sine, accurate near zero too.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// assert_eq!(Real::sinh(1e-20_f64), 1e-20);
    /// ```
    #[inline]
    fn sinh(self) -> Self {
        sinh(self)
    }
    /// The hyperbolic cosine.
    #[inline]
    fn cosh(self) -> Self {
        cosh(self)
    }
    /// The hyperbolic tangent, accurate near zero too; ±1 where sine and cosine are infinite.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// assert_eq!(Real::tanh(1e3_f64), 1.0);
    /// ```
    #[inline]
    fn tanh(self) -> Self {
        tanh(self)
    }
    /// `√(self² + other²)`, without overflow or underflow in the squares.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// let length = Real::hypot(3e200_f64, 4e200);
    /// assert!((length / 5e200 - 1.0).abs() < 1e-15);
    /// ```
    #[inline]
    fn hypot(self, other: Self) -> Self {
        hypot(self, other)
    }
    /// `cos φ`, `A = sin φ/φ` and `B = (cos φ − A)/φ²` for `φ² = self` from 0 to 9.95, that is φ up
    /// to a little more than π; outside of that range the results have no meaning. Errors are below
    /// 2 ε. There is no special case at φ = 0, where the results are 1, 1 and −⅓.
    ///
    /// They give the exponential of a rotation by 2φ. B is twice the derivative of A with respect
    /// to φ².
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// let angle = 0.75_f64;
    /// let (cosine, ratio, slope) = (angle * angle).sine_by_angle();
    /// assert!((cosine - angle.cos()).abs() < 2e-16);
    /// assert!((ratio - angle.sin() / angle).abs() < 2e-16);
    /// assert!((slope - (cosine - ratio) / angle.powi(2)).abs() < 1e-15);
    /// ```
    #[inline]
    fn sine_by_angle(self) -> (Self, Self, Self) {
        half_angle::sine_by_angle(self)
    }
    /// `A = φ/sin φ` and `B = (cos φ − A)/sin² φ` for `cos φ = self` from 0 to 1, that is φ up to
    /// π/2; outside of that range the results are inaccurate. Errors are below 2 ε.
    ///
    /// They give the logarithm of a rotation by 2φ. At φ = 0 they are 1 and −2/3.
    /// `−B cos φ = 1 + dA/d(cos φ)`.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// let angle = 0.75_f64;
    /// let (ratio, slope) = angle.cos().angle_by_sine();
    /// assert!((ratio - angle / angle.sin()).abs() < 4e-16);
    /// assert!((slope - (angle.cos() - ratio) / angle.sin().powi(2)).abs() < 1e-15);
    /// assert_eq!(1.0_f64.angle_by_sine().0, 1.0);
    /// ```
    #[inline]
    fn angle_by_sine(self) -> (Self, Self) {
        half_angle::angle_by_sine(self)
    }
    /// [`angle_by_sine`](Self::angle_by_sine) of each lane, with the same result as of one number.
    #[doc(hidden)]
    #[inline(always)]
    fn angle_by_sine_in_lanes<const N: usize>(
        lanes: Lanes<Self, N>,
    ) -> (Lanes<Self, N>, Lanes<Self, N>) {
        angle_by_sine_one_by_one(lanes)
    }
    /// The factors `A = sin (1 − t)φ/sin φ` and `B = sin tφ/sin φ` of spherical linear
    /// interpolation with their derivatives, for `cos φ = self` from 0 to 1, that is φ up to π/2,
    /// and t from −1 to 1; outside of that range the results have no meaning. There is no special
    /// case at φ = 0, where A is 1 − t and B is t. Errors of A and B are below 4 ε for t from 0 to
    /// 1.
    ///
    /// ```
    /// use ga_runtime::scalar::Real;
    /// let (angle, t) = (0.75_f64, 0.25);
    /// let factors = angle.cos().arc_factors(t);
    /// assert!((factors.first - (0.75 * angle).sin() / angle.sin()).abs() < 5e-16);
    /// assert!((factors.second - (0.25 * angle).sin() / angle.sin()).abs() < 5e-16);
    /// assert!((1.0.arc_factors(t).second - 0.25).abs() < 5e-16);
    /// ```
    #[inline]
    fn arc_factors(self, t: Self) -> ArcFactors<Self> {
        arc::arc_factors(self, t)
    }
    /// See [`Motor::compose`].
    #[doc(hidden)]
    #[inline(always)]
    fn compose_motors(left: Motor<Self>, right: Motor<Self>) -> Motor<Self> {
        left * right
    }
    /// The larger of two numbers; `self` where they are equal or one is NaN.
    #[inline]
    fn max(self, other: Self) -> Self {
        Self::select(self.less_than(other), other, self)
    }
    /// The smaller of two numbers; `self` where they are equal or one is NaN.
    #[inline]
    fn min(self, other: Self) -> Self {
        Self::select(other.less_than(self), other, self)
    }
}

impl<S: Real> Constant for S {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        S::from_f64(value)
    }
}

/// [`Real::angle_by_sine`] of one lane after the other.
#[inline(always)]
pub(super) fn angle_by_sine_one_by_one<S: Real, const N: usize>(
    lanes: Lanes<S, N>,
) -> (Lanes<S, N>, Lanes<S, N>) {
    let numbers = lanes.to_array();
    let (mut ratio, mut slope) = (numbers, numbers);
    for lane in 0..N {
        (ratio[lane], slope[lane]) = numbers[lane].angle_by_sine();
    }
    (Lanes::from_array(ratio), Lanes::from_array(slope))
}

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

pub(super) fn is_tiny<S: Real>(x: S) -> S::Mask {
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
pub(super) fn slope_series<S: Field>(x: S) -> S {
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

/// `sinh x = x S(x²)`, where S is accurate near zero. `√x²` is |x| exactly.
#[inline]
fn sinh<S: Real>(x: S) -> S {
    x * versor_exponential(x * x).1
}

/// `cosh x = C(x²)`.
#[inline]
fn cosh<S: Real>(x: S) -> S {
    versor_exponential(x * x).0
}

/// `tanh x = x S(x²)/C(x²)`.
#[inline]
fn tanh<S: Real>(x: S) -> S {
    // 1 − tanh x is 2 e⁻²ˣ, which double precision does not see from 19 on; sinh and cosh do not
    // overflow there.
    let limit = S::from_integer(40);
    let bounded = x.min(limit).max(-limit);
    let (cosine, sine, _) = versor_exponential(bounded * bounded);
    bounded * sine / cosine
}

/// `m √(1 + (n/m)²)`, where m is the larger magnitude.
#[inline]
fn hypot<S: Real>(x: S, y: S) -> S {
    let (x, y) = (x.abs(), y.abs());
    // Where one is NaN, the smaller one is `y` and the larger one `x`, so that NaN is kept.
    let (larger, smaller) = (x.max(y), y.min(x));
    let is_regular = S::zero().less_than(larger) & larger.is_finite();
    let divisor = S::select(is_regular, larger, S::one());
    let ratio = S::select(is_regular, smaller / divisor, S::zero());
    larger * (S::one() + ratio * ratio).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{cosh, hypot, sinh, tanh};

    /// Against the functions of the standard library, in units of the last place.
    #[test]
    fn hyperbolic_functions_are_those_of_the_library() {
        let near = |found: f64, expected: f64, what: &str| {
            let unit = (expected.abs() * f64::EPSILON).max(f64::MIN_POSITIVE);
            assert!(
                found == expected || (found - expected).abs() <= 4.0 * unit,
                "{what}: {found:e}, not {expected:e}"
            );
        };
        for size in [
            0.0, 1e-300, 1e-20, 1e-8, 0.1, 0.9, 1.1, 5.0, 19.0, 41.0, 700.0, 1e3,
        ] {
            for x in [size, -size] {
                near(sinh(x), x.sinh(), &format!("sinh {x}"));
                near(cosh(x), x.cosh(), &format!("cosh {x}"));
                near(tanh(x), x.tanh(), &format!("tanh {x}"));
            }
        }
        assert!(tanh(f64::NAN).is_nan());
        assert_eq!((tanh(f64::INFINITY), tanh(f64::NEG_INFINITY)), (1.0, -1.0));
    }

    #[test]
    fn the_hypotenuse_is_that_of_the_library() {
        let sizes = [0.0, 1e-310, 3e-200, 1.0, 4e-9, 0.75, 3e200, f64::MAX];
        for x in sizes {
            for y in sizes {
                let (found, expected) = (hypot(x, -y), x.hypot(y));
                let unit = (expected * f64::EPSILON).max(f64::MIN_POSITIVE * f64::EPSILON);
                let is_near = found == expected || (found - expected).abs() <= 2.0 * unit;
                assert!(is_near, "{x:e}, {y:e}: {found:e}, not {expected:e}");
            }
        }
        let infinity = f64::INFINITY;
        assert_eq!(
            (hypot(infinity, 1.0), hypot(0.0, -infinity)),
            (infinity, infinity)
        );
        assert!(hypot(f64::NAN, 1.0).is_nan() && hypot(1.0, f64::NAN).is_nan());
    }
}
