//! Values that exist for some inputs only.

#[cfg(doc)]
use super::{Lanes, Real};
use super::{Mask, Select};

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
