//! Numbers with derivatives.

use alloc::format;
use core::fmt;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::{Field, Real, Ring};

/// A dual number: a value and its N derivatives, `x + x₁ ε₁ + … + x_N ε_N` with `ε_i ε_j = 0`.
///
/// Arithmetic on dual numbers carries derivatives along by the chain rule, exactly and without differences of close
/// values (forward-mode differentiation: Griewank and Walther, Evaluating Derivatives, 2008, chapter 3). So any function that is
/// generic over its scalar differentiates: N = 3 gives the Jacobian by the coordinates of a point, N = 1, the default, one
/// derivative, `Dual<Dual<f64>>` the second one. The value is, bit for bit, what the function gives without derivatives.
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
/// let p = Point::from(Dual::variables([4.0, 0.0, 3.0]));
/// let distance = p.distance(Point::from([0.0, 0.0, 0.0].map(Dual::constant)));
/// assert_eq!(distance, Dual::new(5.0, [0.8, 0.0, 0.6]));
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
/// In every function but the quotient a derivative of zero stays zero, even where the slope is infinite: what does not
/// move has no derivative. So the length of a vector that is zero has the derivative zero, and a NaN comes only from
/// a NaN, from a value that is NaN or infinite itself, or from the difference of two infinite derivatives. For second derivatives
/// a number moves as soon as its own derivative does, so there `√x` at zero is NaN where x moves only to second order.
///
/// # Comparisons
///
/// [`Real::less_than`] compares values, so that a program takes the branch that it takes without derivatives; at the border of a
/// branch the derivative is that of the branch taken. [`Real::is_finite`] asks for the value and every derivative, and thus finds
/// what singular points leave. `==` and [`Real::is_zero`] compare all of them too, so a guard against division by zero asks
/// [`Field::is_invertible`], which looks at the value alone.
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
    /// A number that does not vary: all its derivatives are zero.
    #[inline(always)]
    #[must_use]
    pub fn constant(value: S) -> Self {
        Self::new(value, [S::zero(); N])
    }

    /// N independent variables, the k-th with derivative 1 in the k-th direction: the derivatives of what is computed
    /// from them are its gradient.
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

    /// The derivatives after a function of one or more numbers, each worked out from its place.
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
    /// The variable by which is differentiated: its derivative is 1.
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
    fn is_invertible(self) -> bool {
        self.value.is_invertible()
    }
}

impl<S: Real, const N: usize> Real for Dual<S, N> {
    type Mask = S::Mask;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::constant(S::from_f64(value))
    }
    #[inline(always)]
    fn epsilon() -> Self {
        Self::constant(S::epsilon())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        // Without the sign of √−0, which is −0.
        self.chain(root, (root + root).abs().recip())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        let x = self.value;
        let one = S::one();
        // Neither positive nor negative are zero and NaN. The product with zero keeps them apart.
        let slope = S::select(S::zero().less_than(x), one, x * S::zero());
        let slope = S::select(x.less_than(S::zero()), -one, slope);
        self.chain(x.abs(), slope)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let y = self;
        // Relative to the sum of magnitudes, whose square cannot overflow.
        let size = y.value.abs() + x.value.abs();
        let (sine, cosine) = (y.value / size, x.value / size);
        let is_regular = S::zero().less_than(size) & size.is_finite();
        let divisor = (sine * sine + cosine * cosine) * size;
        let slope = S::select(is_regular, divisor, size).recip();
        Self::with(y.value.atan2(x.value), |k| {
            let (dy, dx) = (y.derivatives[k], x.derivatives[k]);
            let rate = S::select(is_regular, cosine * dy - sine * dx, dy.abs() + dx.abs());
            moved(slope, rate)
        })
    }
    #[inline(always)]
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        let value = self.value.ln();
        let slope = self.value.abs().recip();
        // The logarithm of a negative number is NaN, and so is its slope.
        self.chain(
            value,
            S::select(self.value.less_than(S::zero()), value, slope),
        )
    }
    #[inline(always)]
    fn less_than(self, other: Self) -> S::Mask {
        self.value.less_than(other.value)
    }
    #[inline(always)]
    fn is_finite(self) -> S::Mask {
        self.derivatives
            .iter()
            .fold(self.value.is_finite(), |all, rate| all & rate.is_finite())
    }
    #[inline(always)]
    fn is_zero(self) -> S::Mask {
        self.derivatives
            .iter()
            .fold(self.value.is_zero(), |all, rate| all & rate.is_zero())
    }
    #[inline(always)]
    fn select(mask: S::Mask, if_true: Self, if_false: Self) -> Self {
        Self::with(S::select(mask, if_true.value, if_false.value), |k| {
            S::select(mask, if_true.derivatives[k], if_false.derivatives[k])
        })
    }
}

impl<S: Real, const N: usize> Dual<S, N> {
    /// A function of this number, given its value and its slope here.
    #[inline(always)]
    fn chain(self, value: S, slope: S) -> Self {
        Self::with(value, |k| moved(slope, self.derivatives[k]))
    }
}

/// `slope · rate`, and zero where the rate is zero, however steep the slope.
#[inline(always)]
fn moved<S: Real>(slope: S, rate: S) -> S {
    S::select(rate.is_zero(), S::zero(), slope * rate)
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
    /// A number that does not vary.
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
    /// `(1 + 2 ε1 - 3 ε2)`, to the precision asked for; a single direction is `ε`.
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
