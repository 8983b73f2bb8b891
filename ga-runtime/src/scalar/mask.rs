//! Masks, the outcomes of comparisons, for one number and for lanes; what they choose between; and
//! values that exist for some inputs only.

use core::fmt::Debug;
use core::ops::{BitAnd, BitOr, Not};

#[cfg(doc)]
use super::{Dual, Lanes, Masked, Real};

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

/// Values of which a mask chooses one: numbers, lanes of them, and what is made of those, that is
/// elements of an algebra, arrays and pairs. From lanes it chooses lane by lane.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_runtime::scalar::{Lanes, Real, Select};
/// let x = Lanes::from_array([1.0, 5.0]);
/// let [near, far] = [3.0, 9.0].map(|y| Point::new(x, Lanes::splat(y), Lanes::splat(0.0)));
/// let chosen = Point::select(x.less_than(Lanes::splat(2.0)), near, far);
/// assert_eq!(chosen.y().to_array(), [3.0, 9.0]);
/// ```
pub trait Select: Sized {
    /// The outcome of a comparison: `bool` for one number, one for each lane of several.
    type Mask: Mask;

    /// `if_true` where the mask is set, else `if_false`.
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self;
}

/// A scalar that is one number, not [`Lanes`] and not a [`Dual`] number: its mask is `bool`. All
/// that a type of your own needs beside [`Real`].
///
/// `f32` and `f64` are here by one impl of [`Select`], so that rustc knows the mask of a literal
/// such as `1.0` before it knows which of the two the literal is.
pub trait Single: Sized {}

impl<T: Single> Select for T {
    type Mask = bool;

    #[inline(always)]
    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }
}

impl<T: Select, const N: usize> Select for [T; N] {
    type Mask = T::Mask;

    #[inline(always)]
    fn select(mask: T::Mask, if_true: Self, if_false: Self) -> Self {
        let mut others = if_false.into_iter();
        if_true.map(|value| match others.next() {
            Some(other) => T::select(mask, value, other),
            None => value,
        })
    }
}

impl<T: Select, U: Select<Mask = T::Mask>> Select for (T, U) {
    type Mask = T::Mask;

    #[inline(always)]
    fn select(mask: T::Mask, if_true: Self, if_false: Self) -> Self {
        (
            T::select(mask, if_true.0, if_false.0),
            U::select(mask, if_true.1, if_false.1),
        )
    }
}

/// A value that exists for some inputs only, computed with the scalar S: an `Option<T>` for a
/// single number, [`Masked`] for lanes.
///
/// ```
/// use ga_runtime::cga3::{Plane, Point};
/// use ga_runtime::scalar::{Lanes, Maybe, Optional, Real};
///
/// /// The height of the foot of a point in a plane.
/// fn height<S: Real>(point: Point<S>, plane: Plane<S>) -> Maybe<S, S> {
///     point.project_onto(plane).map(|foot| foot.z())
/// }
///
/// let point = Point::new(0.0, 0.0, 5.0);
/// let ground = Plane::from_point_normal(Point::new(0.0, 0.0, 1.0), [0.0, 0.0, 2.0]);
/// assert_eq!(height(point, ground), Some(1.0));
///
/// // Two planes, the second of weight zero.
/// let all = |x: f64| Lanes::splat(x);
/// let normal = [all(0.0), all(0.0), Lanes::from_array([2.0, 0.0])];
/// let planes = Plane::from_point_normal(Point::from([0.0, 0.0, 1.0].map(all)), normal);
/// let heights = height(Point::from([0.0, 0.0, 5.0].map(all)), planes);
/// assert_eq!(heights.unwrap_or(all(-1.0)).to_array(), [1.0, -1.0]);
/// ```
pub type Maybe<T, S> = <<S as Select>::Mask as Mask>::Maybe<T>;

/// The methods that [`Maybe`] has whatever the scalar is. They are those of `Option`, which a
/// single number has without this trait, with a mask in the place of a `bool`.
///
/// For lanes the functions are called always, also where no lane has a value: they must not panic.
pub trait Optional<T>: Sized {
    /// The outcome of a comparison.
    type Mask: Mask;

    /// Where there is a value.
    fn is_some(&self) -> Self::Mask;

    /// The function of the value.
    fn map<U>(self, function: impl FnOnce(T) -> U) -> <Self::Mask as Mask>::Maybe<U>;

    /// The function of the value, where both exist.
    fn and_then<U>(
        self,
        function: impl FnOnce(T) -> <Self::Mask as Mask>::Maybe<U>,
    ) -> <Self::Mask as Mask>::Maybe<U>;

    /// The value, where a test of it holds.
    #[must_use]
    fn filter(self, test: impl FnOnce(&T) -> Self::Mask) -> Self;

    /// This value, and the other where there is none. The other is computed only where it is
    /// needed.
    #[must_use]
    #[inline(always)]
    fn or_else(self, other: impl FnOnce() -> Self) -> Self
    where
        T: Select<Mask = Self::Mask>,
    {
        self.or_else_of((), |()| other())
    }

    /// The same, with a function of some arguments. Where that is rarely called, they stay in
    /// registers until it is: what a function captures lies in memory before.
    #[must_use]
    fn or_else_of<A>(self, arguments: A, other: impl FnOnce(A) -> Self) -> Self
    where
        T: Select<Mask = Self::Mask>;

    /// This value, and the other where there is none.
    fn unwrap_or(self, other: T) -> T
    where
        T: Select<Mask = Self::Mask>;

    /// Both values, where both exist.
    #[inline(always)]
    fn zip<U>(self, other: <Self::Mask as Mask>::Maybe<U>) -> <Self::Mask as Mask>::Maybe<(T, U)> {
        self.and_then(|value| other.map(|other| (value, other)))
    }

    /// Where there is a value and a test of it holds.
    #[expect(clippy::wrong_self_convention, reason = "as of `Option`")]
    #[inline(always)]
    fn is_some_and(self, test: impl FnOnce(T) -> Self::Mask) -> Self::Mask {
        self.and_then(|value| test(value).when(())).is_some()
    }
}

impl<T> Optional<T> for Option<T> {
    type Mask = bool;

    #[inline(always)]
    fn is_some(&self) -> bool {
        self.is_some()
    }
    #[inline(always)]
    fn map<U>(self, function: impl FnOnce(T) -> U) -> Option<U> {
        self.map(function)
    }
    #[inline(always)]
    fn and_then<U>(self, function: impl FnOnce(T) -> Option<U>) -> Option<U> {
        self.and_then(function)
    }
    #[inline(always)]
    fn filter(self, test: impl FnOnce(&T) -> bool) -> Self {
        self.filter(test)
    }
    #[inline(always)]
    fn or_else_of<A>(self, arguments: A, other: impl FnOnce(A) -> Self) -> Self {
        match self {
            None => other(arguments),
            some => some,
        }
    }
    #[inline(always)]
    fn unwrap_or(self, other: T) -> T {
        self.unwrap_or(other)
    }
}
