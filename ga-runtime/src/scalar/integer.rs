//! Machine integers: a ring without fractions.

use super::{ConstRing, Ring};

impl Ring for i64 {
    #[inline]
    fn zero() -> Self {
        0
    }
    #[inline]
    fn one() -> Self {
        1
    }
    #[inline]
    fn from_integer(value: i64) -> Self {
        value
    }
}

impl ConstRing for i64 {
    const ZERO: Self = 0;
    const ONE: Self = 1;
}
