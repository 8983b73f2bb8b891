//! What masks choose between.

use super::Mask;
#[cfg(doc)]
use super::{Dual, Lanes, Real};

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
