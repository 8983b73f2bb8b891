//! Machine integers: a ring without fractions.

use super::Ring;

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
