//! Medians and other quantiles.
//!
//! There is one definition. The quantile of a share p of n sorted values is linear between the
//! value of index ⌊h⌋ and the next, for h = (n − 1) p, from 0: type 7 of R. J. Hyndman and Y. Fan,
//! "Sample quantiles in statistical packages", The American Statistician 50, 1996, which is also
//! that of numpy and R. The median is the quantile of one half: the mean of the two values in the
//! middle where their number is even. Where a result has to be one of the values, as for whole
//! numbers, it is [`median_element`].

use std::cmp::Ordering;

/// A number whose quantiles are taken.
pub trait Number: Copy + PartialEq {
    /// The total order of IEEE 754.
    fn compare(&self, other: &Self) -> Ordering;

    /// Whether it is NaN.
    fn is_not_a_number(self) -> bool;

    /// `self + part (other − self)`, and `self` where both are equal.
    #[must_use]
    fn towards(self, other: Self, part: f64) -> Self;
}

macro_rules! number {
    ($($float:ident),*) => {$(
        impl Number for $float {
            fn compare(&self, other: &Self) -> Ordering {
                self.total_cmp(other)
            }

            fn is_not_a_number(self) -> bool {
                self.is_nan()
            }

            fn towards(self, other: Self, part: f64) -> Self {
                // The difference of two infinite numbers is NaN.
                match self == other || part == 0.0 {
                    true => self,
                    false => self + (other - self) * part as $float,
                }
            }
        }
    )*};
}

number!(f32, f64);

/// Values in rising order, at least one of them, and none of them NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sorted<'a, T>(&'a [T]);

impl<'a, T: Number> Sorted<'a, T> {
    /// Sorts values; `None` where there are none or one is NaN.
    ///
    /// ```
    /// use ga_numerics::order_statistics::Sorted;
    ///
    /// let mut values = [4.0, 1.0, 2.0];
    /// let sorted = Sorted::new(&mut values).ok_or("no values")?;
    /// assert_eq!(sorted.median(), 2.0);
    /// assert_eq!(sorted.quantile(0.75), 3.0);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn new(values: &'a mut [T]) -> Option<Self> {
        values.sort_unstable_by(T::compare);
        // In the total order, NaN is before or after all other values.
        let ends = [*values.first()?, *values.last()?];
        let is_number = !ends.into_iter().any(T::is_not_a_number);
        is_number.then_some(Self(values))
    }

    /// The values.
    #[must_use]
    pub fn values(self) -> &'a [T] {
        self.0
    }

    /// The value below which a share of the values lies: see the [module](self). A share below 0
    /// counts as 0, one above 1 as 1.
    #[must_use]
    pub fn quantile(self, share: f64) -> T {
        let last = self.0.len() - 1;
        let place = last as f64 * share.clamp(0.0, 1.0);
        let index = place as usize;
        self.0[index].towards(self.0[(index + 1).min(last)], place.fract())
    }

    /// The quantile of one half.
    #[must_use]
    pub fn median(self) -> T {
        self.quantile(0.5)
    }
}

/// The median, for which the values are sorted; `None` where there are none or one is NaN.
///
/// ```
/// use ga_numerics::order_statistics::median;
///
/// assert_eq!(median(&mut [3.0, 1.0, 2.0, 10.0]), Some(2.5));
/// assert_eq!(median::<f64>(&mut []), None);
/// ```
#[must_use]
pub fn median<T: Number>(values: &mut [T]) -> Option<T> {
    Sorted::new(values).map(Sorted::median)
}

/// The value in the middle, the greater one of two; `None` where there are none.
///
/// ```
/// use ga_numerics::order_statistics::median_element;
///
/// assert_eq!(median_element(&mut [3, 1, 2, 10]), Some(3));
/// ```
#[must_use]
pub fn median_element<T: Copy + Ord>(values: &mut [T]) -> Option<T> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable(middle).1)
}
