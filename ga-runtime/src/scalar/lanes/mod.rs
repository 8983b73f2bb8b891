//! Several numbers side by side.

mod real;

use core::fmt;
use core::ops::{
    Add, AddAssign, Div, DivAssign, Index, IndexMut, Mul, MulAssign, Neg, Sub, SubAssign,
};

#[cfg(doc)]
use super::Real;
use super::{ConstRing, Field, LaneMask, Ring, Select};

/// N numbers side by side; every operation is applied to each of them.
///
/// The operations are loops over an array. The compiler translates them into vector instructions of
/// the width that is enabled in the function into which they are inlined: a `Lanes<f32, 8>` is one
/// register with AVX, and two with SSE2 only. So the same generic function can be compiled for the
/// baseline and inside a function with `#[target_feature(enable = "avx2")]`, with bit-identical
/// results.
///
/// Each lane holds what the same operation gives on a single number, bit for bit; elementary
/// functions are called lane by lane. Multiplications and additions are fused only if the whole
/// program is built for a processor with that instruction, as for a single number. `==` is true if
/// all lanes are equal; [`Real::less_than`] compares each lane.
///
/// Lanes can be the scalar of any type of an algebra. Where a result may not exist, it is a
/// [`Maybe`](super::Maybe), which says for each lane whether it does: unit elements, what is read
/// of primitives, distances, angles and incidence, the projection of points, reflections, what
/// [rays](crate::geometry::ray) hit, and what is read of products: `(sphere & line).endpoints()` is
/// the meet. What has results of several kinds, or is searched step by step, is there for single
/// numbers only: `meet` and `join`, which tell the kinds apart, distances, angles and incidence of
/// circles and of sums such as [`Trivector`](crate::cga3::Trivector) with anything but a point,
/// [`Kind`](crate::geometry::Kind), fits, conversions from matrices.
///
/// Eight points in one value:
///
/// ```
/// use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
/// use ga_runtime::scalar::Lanes;
///
/// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0_f32], std::f32::consts::FRAC_PI_2).unwrap();
/// let motor = Translator::from_displacement([0.0, 0.0, 1.0]) * quarter;
/// let same = Motor::new_unchecked(
///     Lanes::splat(motor.scalar()),
///     Lanes::splat(motor.e12()),
///     Lanes::splat(motor.e13()),
///     Lanes::splat(motor.e23()),
///     Lanes::splat(motor.e1i()),
///     Lanes::splat(motor.e2i()),
///     Lanes::splat(motor.e3i()),
///     Lanes::splat(motor.e123i()),
/// );
///
/// let x = Lanes::from_array([0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
/// let moved = same.transform(Point::new(x, Lanes::splat(0.0), Lanes::splat(0.5)));
/// for lane in 0..8 {
///     let alone = motor.transform(Point::new(lane as f32, 0.0, 0.5));
///     assert_eq!(moved.e2()[lane], alone.e2());
/// }
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[repr(transparent)]
pub struct Lanes<T, const N: usize>([T; N]);

impl<T: Copy, const N: usize> Lanes<T, N> {
    /// The same number in every lane.
    #[inline(always)]
    #[must_use]
    pub const fn splat(value: T) -> Self {
        Self([value; N])
    }

    /// The lanes with the given numbers.
    #[inline(always)]
    #[must_use]
    pub const fn from_array(lanes: [T; N]) -> Self {
        Self(lanes)
    }

    /// The number in each lane.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(self) -> [T; N] {
        self.0
    }

    /// A reference to the numbers.
    #[inline(always)]
    #[must_use]
    pub const fn as_array(&self) -> &[T; N] {
        &self.0
    }

    /// Applies a function to each lane.
    ///
    /// ```
    /// use ga_runtime::scalar::Lanes;
    /// let x = Lanes::from_array([0.25_f64, 2.5]);
    /// assert_eq!(x.map(f64::floor).to_array(), [0.0, 2.0]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn map(mut self, function: impl Fn(T) -> T) -> Self {
        for lane in &mut self.0 {
            *lane = function(*lane);
        }
        self
    }

    #[inline(always)]
    fn zip(mut self, other: Self, function: impl Fn(T, T) -> T) -> Self {
        for (lane, other) in self.0.iter_mut().zip(&other.0) {
            *lane = function(*lane, *other);
        }
        self
    }
}

impl<T: ConstRing, const N: usize> ConstRing for Lanes<T, N> {
    const ZERO: Self = Self::splat(T::ZERO);
    const ONE: Self = Self::splat(T::ONE);
}

impl<T: Ring, const N: usize> Ring for Lanes<T, N> {
    #[inline(always)]
    fn zero() -> Self {
        Self::splat(T::zero())
    }
    #[inline(always)]
    fn one() -> Self {
        Self::splat(T::one())
    }
    #[inline(always)]
    fn from_integer(value: i64) -> Self {
        Self::splat(T::from_integer(value))
    }
    #[inline(always)]
    fn mul_add(mut self, factor: Self, summand: Self) -> Self {
        for ((lane, factor), summand) in self.0.iter_mut().zip(&factor.0).zip(&summand.0) {
            *lane = lane.mul_add(*factor, *summand);
        }
        self
    }
    #[inline(always)]
    fn mul_sub(mut self, factor: Self, subtrahend: Self) -> Self {
        for ((lane, factor), subtrahend) in self.0.iter_mut().zip(&factor.0).zip(&subtrahend.0) {
            *lane = lane.mul_sub(*factor, *subtrahend);
        }
        self
    }
    #[inline(always)]
    fn neg_mul_add(mut self, factor: Self, summand: Self) -> Self {
        for ((lane, factor), summand) in self.0.iter_mut().zip(&factor.0).zip(&summand.0) {
            *lane = lane.neg_mul_add(*factor, *summand);
        }
        self
    }
}

impl<T: Field, const N: usize> Field for Lanes<T, N> {
    #[inline(always)]
    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Self::splat(T::from_ratio(numerator, denominator))
    }
    #[inline(always)]
    fn recip(self) -> Self {
        self.map(T::recip)
    }
    #[inline(always)]
    fn recip_or_zero(self) -> Self {
        self.map(T::recip_or_zero)
    }
    #[inline(always)]
    fn div_or_zero(self, divisor: Self) -> Self {
        self.zip(divisor, T::div_or_zero)
    }
    #[inline(always)]
    fn is_invertible(self) -> bool {
        self.0.into_iter().all(T::is_invertible)
    }
}

impl<T: Select<Mask = bool> + Copy, const N: usize> Select for Lanes<T, N> {
    type Mask = LaneMask<N>;

    #[inline(always)]
    fn select(mask: LaneMask<N>, mut if_true: Self, if_false: Self) -> Self {
        for ((lane, other), mask) in if_true.0.iter_mut().zip(&if_false.0).zip(mask.to_array()) {
            *lane = T::select(mask, *lane, *other);
        }
        if_true
    }
}

macro_rules! implement_operators {
    ($($trait:ident $method:ident, $assigning:ident $assign:ident;)+) => {$(
        impl<T: Copy + $trait<Output = T>, const N: usize> $trait for Lanes<T, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, T::$method)
            }
        }

        impl<T: Copy + $trait<Output = T>, const N: usize> $assigning for Lanes<T, N> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )+};
}
implement_operators! {
    Add add, AddAssign add_assign;
    Sub sub, SubAssign sub_assign;
    Mul mul, MulAssign mul_assign;
    Div div, DivAssign div_assign;
}

impl<T: Copy + Neg<Output = T>, const N: usize> Neg for Lanes<T, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(T::neg)
    }
}

impl<T: Copy + Default, const N: usize> Default for Lanes<T, N> {
    #[inline(always)]
    fn default() -> Self {
        Self::splat(T::default())
    }
}

impl<T, const N: usize> From<[T; N]> for Lanes<T, N> {
    #[inline(always)]
    fn from(lanes: [T; N]) -> Self {
        Self(lanes)
    }
}

impl<T, const N: usize> From<Lanes<T, N>> for [T; N] {
    #[inline(always)]
    fn from(lanes: Lanes<T, N>) -> Self {
        lanes.0
    }
}

impl<T, const N: usize> Index<usize> for Lanes<T, N> {
    type Output = T;
    #[inline(always)]
    fn index(&self, lane: usize) -> &T {
        &self.0[lane]
    }
}

impl<T, const N: usize> IndexMut<usize> for Lanes<T, N> {
    #[inline(always)]
    fn index_mut(&mut self, lane: usize) -> &mut T {
        &mut self.0[lane]
    }
}

impl<T: fmt::Debug, const N: usize> fmt::Debug for Lanes<T, N> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Lanes")?;
        fmt::Debug::fmt(&self.0, formatter)
    }
}

impl<T: fmt::Display, const N: usize> fmt::Display for Lanes<T, N> {
    /// `[1, 2, 3, 4]`, each number in the requested format.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("[")?;
        for (place, lane) in self.0.iter().enumerate() {
            if place > 0 {
                formatter.write_str(", ")?;
            }
            lane.fmt(formatter)?;
        }
        formatter.write_str("]")
    }
}
