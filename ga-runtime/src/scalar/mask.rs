//! Outcomes of comparisons, for one number and for lanes.

use core::fmt::Debug;
use core::ops::{BitAnd, BitOr, Index, Not};

use super::{Masked, Optional};
#[cfg(doc)]
use super::{Maybe, Select};

/// The outcome of a comparison: `bool` for a single number, one bit for each lane of several.
///
/// Code on lanes cannot branch, since the lanes may differ. It computes both alternatives and
/// chooses with [`Select::select`]; `any` and `all` allow it to skip work that
/// no lane needs.
///
/// ```
/// use ga_runtime::scalar::{Lanes, Mask, Real, Ring};
/// /// The square root, or zero for a negative number.
/// fn root_or_zero<S: Real>(x: S) -> S {
///     let is_negative = x.less_than(S::zero());
///     let root = S::select(is_negative, S::zero(), x).sqrt();
///     if is_negative.any() { S::select(is_negative, S::zero(), root) } else { root }
/// }
/// assert_eq!(root_or_zero(-4.0), 0.0);
/// assert_eq!(root_or_zero(Lanes::from_array([4.0, -4.0])).to_array(), [2.0, 0.0]);
/// ```
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// What has a value where a mask is set: `Option` for one outcome, [`Masked`] for several. In
    /// signatures it is written [`Maybe`].
    type Maybe<T>: Optional<T, Mask = Self>;

    /// The same outcome in every lane.
    fn splat(value: bool) -> Self;
    /// Whether the mask is set in some lane.
    fn any(self) -> bool;
    /// Whether the mask is set in every lane.
    fn all(self) -> bool;
    /// Whether the mask is set in a lane, counted from 0. A single outcome is that of each lane.
    ///
    /// # Panics
    /// If there is no such lane.
    ///
    /// ```
    /// use ga_runtime::scalar::{Lanes, Mask, Real};
    /// let mask = Lanes::from_array([1.0, 3.0]).less_than(Lanes::splat(2.0));
    /// assert_eq!([mask.lane(0), mask.lane(1)], [true, false]);
    /// ```
    fn lane(self, lane: usize) -> bool;
    /// The value where the mask is set, and none elsewhere.
    ///
    /// ```
    /// use ga_runtime::scalar::{Lanes, Mask, Maybe, Optional, Real};
    /// /// The inverse of a number that is not zero.
    /// fn inverse<S: Real>(x: S) -> Maybe<S, S> {
    ///     (!x.is_zero()).when(x.recip())
    /// }
    /// assert_eq!([inverse(4.0), inverse(0.0)], [Some(0.25), None]);
    /// let found = inverse(Lanes::from_array([4.0, 0.0]));
    /// assert_eq!(found.is_some().to_array(), [true, false]);
    /// ```
    fn when<T>(self, value: T) -> Self::Maybe<T>;
}

impl Mask for bool {
    type Maybe<T> = Option<T>;

    #[inline(always)]
    fn splat(value: bool) -> Self {
        value
    }
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn lane(self, _: usize) -> bool {
        self
    }
    #[inline(always)]
    fn when<T>(self, value: T) -> Option<T> {
        self.then_some(value)
    }
}

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
