//! Masks of lanes, and values that exist in some lanes only.

use core::ops::{BitAnd, BitOr, Index, Not};

use super::{Mask, Optional, Select};

/// The outcome of a comparison of [`Lanes`](super::Lanes).
///
/// ```
/// use ga_runtime::scalar::{Lanes, Mask, Real};
/// let mask = Lanes::from_array([1.0, f64::NAN, 3.0]).less_than(Lanes::splat(2.0));
/// assert_eq!(mask.to_array(), [true, false, false]);
/// assert!(mask.any() && !mask.all() && (!mask)[1]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(transparent)]
pub struct LaneMask<const N: usize>([bool; N]);

impl<const N: usize> LaneMask<N> {
    /// The mask with the given outcomes.
    #[inline(always)]
    #[must_use]
    pub const fn from_array(lanes: [bool; N]) -> Self {
        Self(lanes)
    }

    /// The outcome in each lane.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(self) -> [bool; N] {
        self.0
    }
}

impl<const N: usize> Mask for LaneMask<N> {
    type Maybe<T> = Masked<T, Self>;

    #[inline(always)]
    fn splat(value: bool) -> Self {
        Self([value; N])
    }
    #[inline(always)]
    fn any(self) -> bool {
        // No early exit, so that it compiles to one instruction.
        self.0.iter().fold(false, |any, &lane| any | lane)
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.0.iter().fold(true, |all, &lane| all & lane)
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> bool {
        self.0[lane]
    }
    #[inline(always)]
    fn when<T>(self, value: T) -> Masked<T, Self> {
        Masked::new(self, value)
    }
}

impl<const N: usize> BitAnd for LaneMask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitand(mut self, other: Self) -> Self {
        for (lane, other) in self.0.iter_mut().zip(&other.0) {
            *lane &= other;
        }
        self
    }
}

impl<const N: usize> BitOr for LaneMask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitor(mut self, other: Self) -> Self {
        for (lane, other) in self.0.iter_mut().zip(&other.0) {
            *lane |= other;
        }
        self
    }
}

impl<const N: usize> Not for LaneMask<N> {
    type Output = Self;
    #[inline(always)]
    fn not(mut self) -> Self {
        for lane in &mut self.0 {
            *lane = !*lane;
        }
        self
    }
}

impl<const N: usize> Index<usize> for LaneMask<N> {
    type Output = bool;
    #[inline(always)]
    fn index(&self, lane: usize) -> &bool {
        &self.0[lane]
    }
}

/// A value in lanes together with a mask that says in which of them it exists; built by
/// [`Mask::when`]. What the other lanes contain has no meaning, so the value is read through
/// [`lane`](Self::lane) or through [`unwrap_or`](Optional::unwrap_or).
///
/// ```
/// use ga_runtime::scalar::{Lanes, Optional};
/// use ga_runtime::vga3::Vector;
/// let x = Lanes::from_array([3.0, 0.0]);
/// let unit = Vector::new(x, x, Lanes::splat(0.0)).normalized();
/// assert_eq!(unit.is_some().to_array(), [true, false]);
/// assert_eq!(unit.lane(0).map(|unit| unit.e1[0]), Some(0.5_f64.sqrt()));
/// assert_eq!(unit.lane(1), None);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Masked<T, M> {
    mask: M,
    value: T,
}

impl<T, M: Mask> Masked<T, M> {
    #[inline(always)]
    pub(super) fn new(mask: M, value: T) -> Self {
        Self { mask, value }
    }

    /// The value, all lanes of it, if it exists in one lane, counted from 0.
    ///
    /// # Panics
    /// If there is no such lane.
    #[inline]
    #[must_use]
    pub fn lane(self, lane: usize) -> Option<T> {
        self.mask.lane(lane).then_some(self.value)
    }
}

impl<T, M: Mask> Optional<T> for Masked<T, M> {
    type Mask = M;

    #[inline(always)]
    fn is_some(&self) -> M {
        self.mask
    }
    #[inline(always)]
    fn map<U>(self, function: impl FnOnce(T) -> U) -> M::Maybe<U> {
        self.mask.when(function(self.value))
    }
    #[inline(always)]
    fn and_then<U>(self, function: impl FnOnce(T) -> M::Maybe<U>) -> M::Maybe<U> {
        function(self.value).filter(|_| self.mask)
    }
    #[inline(always)]
    fn filter(mut self, test: impl FnOnce(&T) -> M) -> Self {
        self.mask = self.mask & test(&self.value);
        self
    }
    #[inline(always)]
    fn or_else_of<A>(self, arguments: A, other: impl FnOnce(A) -> Self) -> Self
    where
        T: Select<Mask = M>,
    {
        if self.mask.all() {
            return self;
        }
        let other = other(arguments);
        Self {
            mask: self.mask | other.mask,
            value: T::select(self.mask, self.value, other.value),
        }
    }
    #[inline(always)]
    fn unwrap_or(self, other: T) -> T
    where
        T: Select<Mask = M>,
    {
        T::select(self.mask, self.value, other)
    }
}
