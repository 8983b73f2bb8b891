//! Numbers with derivatives.

mod real;

use alloc::format;
use core::fmt;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

#[cfg(doc)]
use super::Real;
use super::{ConstRing, Field, Ring};

/// A dual number: a value and its N derivatives, `x + x₁ ε₁ + … + x_N ε_N` with `ε_i ε_j = 0`.
///
/// Arithmetic on dual numbers computes derivatives by the chain rule, exactly and without
/// differences of close values (forward-mode automatic differentiation: Griewank and Walther,
/// Evaluating Derivatives, 2008, chapter 3). So any function that is generic over its scalar can be
/// differentiated: `N = 3` gives the Jacobian with respect to the coordinates of a point, `N = 1`,
/// the default, one derivative, `Dual<Dual<f64>>` the second derivative. The value is, bit for bit,
/// what the function gives without derivatives.
///
/// ```
/// use ga_runtime::scalar::{Dual, Real};
/// fn wave<S: Real>(t: S) -> S {
///     (t * t).sin()
/// }
/// let at_two = wave(Dual::variable(2.0_f64));
/// assert_eq!(at_two.value, 4.0_f64.sin());
/// assert_eq!(at_two.derivative(), 4.0 * 4.0_f64.cos());
/// ```
///
/// The gradient of the distance of two points is the unit vector from one to the other:
///
/// ```
/// use ga_runtime::{cga3::Point, scalar::Dual};
/// let p = Point::from(Dual::variables([4.0_f64, 0.0, 3.0]));
/// let distance = p.distance(Point::from([0.0, 0.0, 0.0].map(Dual::constant)));
/// let [x, y, z] = distance.derivatives;
/// assert_eq!(distance.value, 5.0);
/// assert!((x - 0.8).abs() < 1e-15 && y == 0.0 && (z - 0.6).abs() < 1e-15);
/// ```
///
/// # Rules
///
/// | function | derivative | where that is singular |
/// | --- | --- | --- |
/// | `a b` | `a' b + a b'` | |
/// | `a / b` | `(a' − (a/b) b')/b` | `b = 0`: infinite or NaN, as the value is |
/// | `√x` | `x'/(2√x)` | `x = 0`: infinite; `x < 0`: NaN, as the value is |
/// | `abs x` | `x'` with the sign of x | `x = 0`: zero, midway between the two sides |
/// | `sin x`, `cos x` | `x' cos x`, `−x' sin x` | |
/// | `exp x` | `x' exp x` | |
/// | `ln x` | `x'/x` | `x = 0`: infinite; `x < 0`: NaN, as the value is |
/// | `atan2(y, x)` | `(x y' − y x')/(x² + y²)` | `x = y = 0`: +∞, since the angle jumps there |
/// | `max`, `min`, `select` | that of the number chosen | where both are equal, that of the first |
///
/// In these elementary functions a derivative of zero stays zero, even where the slope is infinite:
/// an argument that does not vary contributes nothing. So the length of a vector that is zero has
/// the derivative zero, and a NaN comes only from a NaN, from a value that is NaN or infinite
/// itself, or from the difference of two infinite derivatives. In nested dual numbers, an argument
/// counts as varying as soon as its own derivative varies: `√x` at zero is NaN if x varies only to
/// second order.
///
/// # Comparisons
///
/// [`Real::less_than`] compares values, so that a program takes the same branches as without
/// derivatives; at the boundary of a branch the derivative is that of the branch taken.
/// [`Real::is_finite`] checks the value and every derivative, and so detects the results of
/// singular points. `==` and [`Real::is_zero`] compare all of them too, so a guard against division
/// by zero calls [`Field::is_invertible`], which tests the value alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(C)]
pub struct Dual<S, const N: usize = 1> {
    /// The number itself.
    pub value: S,
    /// Its derivatives in N directions.
    pub derivatives: [S; N],
}

impl<S, const N: usize> Dual<S, N> {
    /// The value with its derivatives.
    #[inline(always)]
    #[must_use]
    pub const fn new(value: S, derivatives: [S; N]) -> Self {
        Self { value, derivatives }
    }
}

impl<S: Ring, const N: usize> Dual<S, N> {
    /// A constant: all its derivatives are zero.
    #[inline(always)]
    #[must_use]
    pub fn constant(value: S) -> Self {
        Self::new(value, [S::zero(); N])
    }

    /// N independent variables, the k-th with derivative 1 in the k-th direction: the derivatives
    /// of what is computed from them are its gradient.
    ///
    /// ```
    /// use ga_runtime::scalar::Dual;
    /// let [x, y] = Dual::variables([3, 5]);
    /// assert_eq!(x * x * y, Dual::new(45, [30, 9]));
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn variables(values: [S; N]) -> [Self; N] {
        let mut variables = values.map(Self::constant);
        for (direction, variable) in variables.iter_mut().enumerate() {
            variable.derivatives[direction] = S::one();
        }
        variables
    }

    /// A value with its derivatives, each computed from its index.
    #[inline(always)]
    fn with(value: S, derivative: impl Fn(usize) -> S) -> Self {
        let mut derivatives = [S::zero(); N];
        for (direction, place) in derivatives.iter_mut().enumerate() {
            *place = derivative(direction);
        }
        Self::new(value, derivatives)
    }
}

impl<S: Ring> Dual<S> {
    /// The variable of differentiation: its derivative is 1.
    #[inline(always)]
    #[must_use]
    pub fn variable(value: S) -> Self {
        Self::new(value, [S::one()])
    }

    /// The one derivative.
    #[inline(always)]
    #[must_use]
    pub fn derivative(self) -> S {
        self.derivatives[0]
    }
}

impl<S: ConstRing, const N: usize> ConstRing for Dual<S, N> {
    const ZERO: Self = Self::new(S::ZERO, [S::ZERO; N]);
    const ONE: Self = Self::new(S::ONE, [S::ZERO; N]);
}

impl<S: Ring, const N: usize> Ring for Dual<S, N> {
    #[inline(always)]
    fn zero() -> Self {
        Self::constant(S::zero())
    }
    #[inline(always)]
    fn one() -> Self {
        Self::constant(S::one())
    }
    #[inline(always)]
    fn from_integer(value: i64) -> Self {
        Self::constant(S::from_integer(value))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        let value = self.value.mul_add(factor.value, summand.value);
        Self::with(value, |k| {
            let rest = self.derivatives[k].mul_add(factor.value, summand.derivatives[k]);
            self.value.mul_add(factor.derivatives[k], rest)
        })
    }
}

impl<S: Field, const N: usize> Field for Dual<S, N> {
    #[inline(always)]
    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Self::constant(S::from_ratio(numerator, denominator))
    }
    #[inline(always)]
    fn recip(self) -> Self {
        let value = self.value.recip();
        Self::with(value, |k| -(value * self.derivatives[k] * value))
    }
    #[inline(always)]
    fn recip_or_zero(self) -> Self {
        let value = self.value.recip_or_zero();
        Self::with(value, |k| -(value * self.derivatives[k] * value))
    }
    #[inline(always)]
    fn div_or_zero(self, divisor: Self) -> Self {
        let inverse = divisor.value.recip_or_zero();
        let value = self.value.div_or_zero(divisor.value);
        Self::with(value, |k| {
            (self.derivatives[k] - value * divisor.derivatives[k]) * inverse
        })
    }
    #[inline(always)]
    fn is_invertible(self) -> bool {
        self.value.is_invertible()
    }
}

impl<S: Ring, const N: usize> Add for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::with(self.value + other.value, |k| {
            self.derivatives[k] + other.derivatives[k]
        })
    }
}

impl<S: Ring, const N: usize> Sub for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::with(self.value - other.value, |k| {
            self.derivatives[k] - other.derivatives[k]
        })
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the product rule adds")]
impl<S: Ring, const N: usize> Mul for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::with(self.value * other.value, |k| {
            self.derivatives[k] * other.value + self.value * other.derivatives[k]
        })
    }
}

#[allow(
    clippy::suspicious_arithmetic_impl,
    reason = "the quotient rule subtracts and multiplies"
)]
impl<S: Field, const N: usize> Div for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::with(value, |k| {
            (self.derivatives[k] - value * other.derivatives[k]) / other.value
        })
    }
}

impl<S: Ring, const N: usize> Neg for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::with(-self.value, |k| -self.derivatives[k])
    }
}

macro_rules! implement_assignment {
    ($($trait:ident $method:ident $operator:tt $scalar:ident;)+) => {$(
        impl<S: $scalar, const N: usize> $trait for Dual<S, N> {
            #[inline(always)]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )+};
}
implement_assignment! {
    AddAssign add_assign + Ring;
    SubAssign sub_assign - Ring;
    MulAssign mul_assign * Ring;
    DivAssign div_assign / Field;
}

impl<S: Ring, const N: usize> From<S> for Dual<S, N> {
    /// A constant.
    #[inline(always)]
    fn from(value: S) -> Self {
        Self::constant(value)
    }
}

impl<S: Ring + Default, const N: usize> Default for Dual<S, N> {
    #[inline(always)]
    fn default() -> Self {
        Self::constant(S::default())
    }
}

impl<S: fmt::Display, const N: usize> fmt::Display for Dual<S, N> {
    /// `(1 + 2 ε1 - 3 ε2)`, with the requested precision; a single direction is `ε`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = |number: &S| match formatter.precision() {
            Some(digits) => format!("{number:.digits$}"),
            None => format!("{number}"),
        };
        let parts = self.derivatives.each_ref().map(text);
        write!(formatter, "({}", text(&self.value))?;
        for (place, part) in parts.iter().enumerate() {
            let (sign, size) = match part.strip_prefix('-') {
                Some(size) => ('-', size),
                None => ('+', part.as_str()),
            };
            write!(formatter, " {sign} {size} ε")?;
            if N > 1 {
                write!(formatter, "{}", place + 1)?;
            }
        }
        formatter.write_str(")")
    }
}
