//! Real numbers with a bound on their error, by which the compiler decides signs.

use std::ops::{Add, Mul, Neg, Sub};

use super::{Function, ResidueSequence};
use crate::algebra::Ratio;

/// A real number in double precision, and how far it may be from the exact one.
///
/// Every operation adds its own rounding to the bound, so that two results are different for
/// certain where they differ by more than their bounds. A number may be *unknown*, since nothing
/// was computed or its sign could not be decided, and it may *not exist*, as the root of −1.
#[derive(Clone, Copy, Debug)]
pub struct Real {
    value: f64,
    /// Infinite for an unknown number, NaN for one that does not exist.
    error: f64,
}

/// A bound on the relative rounding of one operation, with room for that of the bound itself.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The same of a function of the standard library.
const ROUNDING_OF_FUNCTIONS: f64 = 16.0 * f64::EPSILON;

/// The largest error, relative to the number or to 1, with which it still says something.
const LARGEST_ERROR: f64 = 1e-4;

impl Real {
    /// A number of which nothing is known.
    pub const UNKNOWN: Self = Self {
        value: 0.0,
        error: f64::INFINITY,
    };
    /// What does not exist.
    pub const NONE: Self = Self {
        value: 0.0,
        error: f64::NAN,
    };

    /// A number that is exact.
    #[must_use]
    pub const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// The nearest number to a fraction.
    #[must_use]
    pub fn from_ratio(ratio: Ratio) -> Self {
        if ratio.is_out_of_range() {
            return Self::UNKNOWN;
        }
        let value = ratio.to_f64();
        // Whole numbers of 53 bits are exact.
        if ratio.is_integer() && value.abs() < 9e15 {
            return Self::exact(value);
        }
        Self::with_error(value, ROUNDING * value.abs())
    }

    /// A random number of one of several magnitudes and of either sign, exact.
    pub fn random(sequence: &mut ResidueSequence) -> Self {
        let bits = sequence.next_residue().residue();
        let fraction =
            1.0 + (bits >> 8 & 0xffff_ffff) as f64 / f64::from(1 << 16) / f64::from(1 << 16);
        let size = fraction * f64::powi(2.0, (bits & 7) as i32 - 4);
        Self::exact(if bits & 8 == 0 { size } else { -size })
    }

    fn with_error(value: f64, error: f64) -> Self {
        if value.is_finite() && error <= LARGEST_ERROR * value.abs().max(1.0) {
            Self { value, error }
        } else {
            Self::UNKNOWN
        }
    }

    /// Whether a number is there, with a bound on its error.
    #[must_use]
    pub const fn is_known(self) -> bool {
        self.error.is_finite()
    }

    /// Whether the number certainly does not exist.
    #[must_use]
    pub const fn is_none(self) -> bool {
        self.error.is_nan()
    }

    /// Whether a number may be zero.
    #[must_use]
    pub fn may_be_zero(self) -> bool {
        !self.is_known() || self.value.abs() <= self.error
    }

    /// Whether two numbers may be equal.
    #[must_use]
    pub fn may_equal(self, other: Self) -> bool {
        !self.is_known()
            || !other.is_known()
            || (self.value - other.value).abs() <= self.error + other.error
    }

    /// What an operation on known numbers gives; else what is missing.
    fn of_two(self, other: Self, of: impl FnOnce(Self, Self) -> Self) -> Self {
        if self.is_known() && other.is_known() {
            of(self, other)
        } else if self.is_none() || other.is_none() {
            Self::NONE
        } else {
            Self::UNKNOWN
        }
    }

    fn of_one(self, of: impl FnOnce(Self) -> Self) -> Self {
        if self.is_known() { of(self) } else { self }
    }

    /// The inverse; none of zero, unknown where it may be zero.
    #[must_use]
    pub fn recip(self) -> Self {
        self.of_one(|x| {
            let size = x.value.abs();
            if size <= x.error {
                return if x.error == 0.0 {
                    Self::NONE
                } else {
                    Self::UNKNOWN
                };
            }
            let value = 1.0 / x.value;
            let error = x.error / (size * (size - x.error)) + ROUNDING * value.abs();
            Self::with_error(value, error)
        })
    }

    /// The root; none of a negative number.
    fn square_root(self) -> Self {
        self.of_one(|x| {
            if x.value < -x.error {
                return Self::NONE;
            }
            if x.value <= x.error {
                // The root of zero up to rounding.
                return Self::with_error(0.0, (x.value.abs() + x.error).sqrt());
            }
            let value = x.value.sqrt();
            Self::with_error(value, x.error / value + ROUNDING * value)
        })
    }

    fn absolute(self) -> Self {
        self.of_one(|x| Self::with_error(x.value.abs(), x.error))
    }

    /// A function that is smooth about its argument.
    fn mapped(self, of: impl Fn(f64) -> f64) -> Self {
        self.of_one(|x| {
            let value = of(x.value);
            let change = |at: f64| (of(at) - value).abs();
            let error = change(x.value + x.error) + change(x.value - x.error);
            Self::with_error(value, error + ROUNDING_OF_FUNCTIONS * (value.abs() + 1.0))
        })
    }

    /// A number as a condition, for comparisons.
    const fn condition(holds: bool) -> Self {
        Self::exact(if holds { 1.0 } else { 0.0 })
    }

    /// Whether a condition holds.
    #[must_use]
    pub fn holds(self) -> bool {
        self.value > 0.5
    }

    /// `cos √−x` and `sin √−x / √−x`, for x > 0 `cosh √x` and `sinh √x / √x`.
    fn stumpff(self) -> (Self, Self) {
        let root = |x: f64| x.abs().sqrt();
        let cosine = |x: f64| {
            if x < 0.0 {
                root(x).cos()
            } else {
                root(x).cosh()
            }
        };
        let sine = |x: f64| match root(x) {
            small if small < 1e-3 => 1.0 + x / 6.0 + x * x / 120.0,
            size if x < 0.0 => size.sin() / size,
            size => size.sinh() / size,
        };
        (self.mapped(cosine), self.mapped(sine))
    }

    /// S(x) and x from C(x) and `S(x)² x`, for the logarithm.
    fn versor_angle(cosine: Self, square: Self) -> (Self, Self) {
        // The angle θ of x = −θ², or the u of x = u².
        let of = |c: f64, y: f64| {
            let size = y.abs().sqrt();
            if y < 0.0 {
                let angle = size.atan2(c);
                (size / angle, -angle * angle)
            } else {
                let angle = size.asinh();
                (size / angle, angle * angle)
            }
        };
        let unknown = (Self::UNKNOWN, Self::UNKNOWN);
        if !cosine.is_known() || !square.is_known() {
            return unknown;
        }
        if square.value > square.error && cosine.value < -cosine.error {
            return (Self::NONE, Self::NONE);
        }
        if square.value.abs() <= square.error {
            return unknown;
        }
        let (sine, x) = of(cosine.value, square.value);
        let (mut error_of_sine, mut error_of_x) = (0.0, 0.0);
        for (c, y) in [
            (cosine.value + cosine.error, square.value),
            (cosine.value - cosine.error, square.value),
            (cosine.value, square.value + square.error),
            (cosine.value, square.value - square.error),
        ] {
            let other = of(c, y);
            error_of_sine += (other.0 - sine).abs();
            error_of_x += (other.1 - x).abs();
        }
        let rounded = |value: f64, error: f64| {
            Self::with_error(value, error + ROUNDING_OF_FUNCTIONS * (value.abs() + 1.0))
        };
        (rounded(sine, error_of_sine), rounded(x, error_of_x))
    }

    /// A function of real numbers.
    #[must_use]
    pub fn function(function: Function, arguments: &[Self]) -> Self {
        let x = arguments[0];
        let second = || arguments[1];
        let two = Self::exact(2.0);
        // (C − S)/(2x), the derivative of S.
        let slope = |x: Self, cosine: Self, sine: Self| (cosine - sine) * (two * x).recip();
        match function {
            Function::SquareRoot => x.square_root(),
            Function::Absolute => x.absolute(),
            Function::Sine => x.mapped(f64::sin),
            Function::Cosine => x.mapped(f64::cos),
            Function::ArcTangent => {
                let y = x;
                y.of_two(second(), |y, x| {
                    // The angle jumps at the negative axis.
                    if y.value.abs() <= y.error && x.value <= x.error {
                        return Self::UNKNOWN;
                    }
                    let value = y.value.atan2(x.value);
                    let square = y.value * y.value + x.value * x.value;
                    let change = (y.value.abs() * x.error + x.value.abs() * y.error) / square;
                    Self::with_error(value, 2.0 * change + ROUNDING_OF_FUNCTIONS)
                })
            }
            Function::Hypotenuse => (x * x + second() * second()).square_root(),
            Function::Reciprocal => x.recip(),
            Function::Divisor => x,
            Function::HyperbolicSine => x.mapped(f64::sinh),
            Function::HyperbolicCosine => x.mapped(f64::cosh),
            Function::HyperbolicTangent => x.mapped(f64::tanh),
            Function::Exponential => x.mapped(f64::exp),
            Function::NaturalLogarithm => x.of_one(|x| {
                if x.value <= -x.error {
                    Self::NONE
                } else if x.value <= x.error {
                    Self::UNKNOWN
                } else {
                    x.mapped(f64::ln)
                }
            }),
            Function::StumpffCosine => x.stumpff().0,
            Function::StumpffSine => x.stumpff().1,
            Function::StumpffSineSlope => {
                let (cosine, sine) = x.stumpff();
                slope(x, cosine, sine)
            }
            Function::VersorAngle => Self::versor_angle(x, second()).0.recip(),
            Function::VersorAngleSlope => {
                let (sine, at) = Self::versor_angle(x, second());
                let inverse = sine.recip();
                -two * slope(at, x, sine) * inverse * inverse * inverse
            }
            Function::Minimum => x.of_two(second(), |x, y| x.one_of(y, x.value <= y.value)),
            Function::Maximum => x.of_two(second(), |x, y| x.one_of(y, x.value >= y.value)),
            // At random numbers what may be equal is equal.
            Function::Less => x.of_two(second(), |x, y| {
                Self::condition(!x.may_equal(y) && x.value < y.value)
            }),
            Function::LessOrEqual => x.of_two(second(), |x, y| {
                Self::condition(x.may_equal(y) || x.value < y.value)
            }),
            Function::Equal => x.of_two(second(), |x, y| Self::condition(x.may_equal(y))),
            Function::And => x.of_two(second(), |x, y| Self::condition(x.holds() && y.holds())),
            Function::Or => x.of_two(second(), |x, y| Self::condition(x.holds() || y.holds())),
            Function::Not => x.of_one(|x| Self::condition(!x.holds())),
            Function::Select => x.of_one(|x| arguments[if x.holds() { 1 } else { 2 }]),
        }
    }

    /// One of two numbers, or either where they may be equal.
    fn one_of(self, other: Self, is_first: bool) -> Self {
        let (chosen, rest) = if is_first {
            (self, other)
        } else {
            (other, self)
        };
        let error = match chosen.may_equal(rest) {
            true => chosen.error + rest.error,
            false => chosen.error,
        };
        Self::with_error(chosen.value, error)
    }
}

impl Add for Real {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.of_two(other, |a, b| {
            let value = a.value + b.value;
            let is_exact = a.error == 0.0 && b.error == 0.0 && value == 0.0;
            let rounding = if is_exact {
                0.0
            } else {
                ROUNDING * value.abs()
            };
            Self::with_error(value, a.error + b.error + rounding)
        })
    }
}

impl Sub for Real {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Real {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl Mul for Real {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.of_two(other, |a, b| {
            let value = a.value * b.value;
            let error = a.value.abs() * b.error + b.value.abs() * a.error + a.error * b.error;
            // Small whole numbers are multiplied without rounding.
            let is_whole = |x: f64| x.fract() == 0.0 && x.abs() < 1e7;
            let is_exact = error == 0.0 && is_whole(a.value) && is_whole(b.value);
            let rounding = if is_exact {
                0.0
            } else {
                ROUNDING * value.abs()
            };
            Self::with_error(value, error + rounding)
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A number with a bound, and two numbers within it, the ends.
    fn bounded() -> impl Strategy<Value = (Real, [f64; 2])> {
        let value = prop_oneof![-4.0..-0.1, 0.1..4.0];
        (value, 0.0..1e-6_f64).prop_map(|(value, error)| {
            let real = Real::with_error(value, error);
            (real, [value - error, value + error])
        })
    }

    /// That a result holds all that is possible, and its bound is not more than it needs to be.
    fn check(found: Real, possible: &[f64], excess: f64) -> Result<(), TestCaseError> {
        prop_assert!(found.is_known());
        let low = possible.iter().copied().fold(f64::INFINITY, f64::min);
        let high = possible.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let slack = 1e-14 * (1.0 + high.abs().max(low.abs()));
        prop_assert!(found.value - found.error <= low + slack, "{found:?} {low}");
        prop_assert!(
            found.value + found.error >= high - slack,
            "{found:?} {high}"
        );
        prop_assert!(
            found.error <= excess * (high - low) + slack,
            "{found:?} {low} {high}"
        );
        Ok(())
    }

    proptest! {
        #[test]
        fn bounds_hold_what_is_possible_and_little_more(a in bounded(), b in bounded()) {
            let ((x, xs), (y, ys)) = (a, b);
            let both = |of: fn(f64, f64) -> f64| {
                [of(xs[0], ys[0]), of(xs[0], ys[1]), of(xs[1], ys[0]), of(xs[1], ys[1])]
            };
            check(x + y, &both(|x, y| x + y), 0.51)?;
            check(x - y, &both(|x, y| x - y), 0.51)?;
            check(x * y, &both(|x, y| x * y), 0.51)?;
            check(-x, &xs.map(|x| -x), 0.51)?;
            check(x.recip(), &xs.map(f64::recip), 0.51)?;
            let of = |function| Real::function(function, &[x, y]);
            check(of(Function::Absolute), &xs.map(f64::abs), 0.51)?;
            check(of(Function::Hypotenuse), &both(f64::hypot), 1.1)?;
            check(of(Function::ArcTangent), &both(f64::atan2), 2.1).or_else(|error| {
                // The angle jumps between the ends at the negative axis.
                if xs[0] < 0.0 && ys[0] * ys[1] <= 0.0 { Ok(()) } else { Err(error) }
            })?;
            let [mapped, exponential] = [Function::HyperbolicTangent, Function::Exponential].map(of);
            check(mapped, &xs.map(f64::tanh), 1.1)?;
            check(exponential, &xs.map(f64::exp), 1.1)?;
            if xs[0] > 0.0 {
                check(of(Function::SquareRoot), &xs.map(f64::sqrt), 1.1)?;
                check(of(Function::NaturalLogarithm), &xs.map(f64::ln), 1.1)?;
            }
        }
    }

    #[test]
    fn what_may_be_zero_has_no_known_inverse() {
        assert!(Real::exact(0.0).recip().is_none());
        let near = Real::with_error(1e-6, 2e-6);
        assert!(near.may_be_zero() && !near.recip().is_known() && !near.recip().is_none());
        assert!(!Real::exact(1e-300).may_be_zero());
        assert!(Real::function(Function::SquareRoot, &[Real::exact(-1.0)]).is_none());
        assert!((Real::NONE * Real::UNKNOWN).is_none());
        assert!(Real::exact(1.0).may_equal(Real::with_error(1.0 + 1e-6, 1e-6)));
        assert!(!Real::exact(1.0).may_equal(Real::with_error(1.0 + 3e-6, 1e-6)));
    }
}
