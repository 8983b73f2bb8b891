//! The product of two motors, in the registers of the processor.

#[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
pub(crate) mod registers;

use crate::cga3::Motor;
use crate::scalar::Real;

impl<S: Real> Motor<S> {
    /// The product `self · first`, the motion `first` followed by `self`: the same as `*` to
    /// rounding, and quicker where each product waits for the one before it, as along the joints of
    /// a skeleton. One product at a time leaves most of a vector register empty if it is computed
    /// coefficient by coefficient; for `f32` on `x86_64` four coefficients are computed at once.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let [near, far] =
    ///     [2.0_f32, 6.0].map(|x| Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
    /// assert_eq!(near.compose(far).translator().displacement(), [8.0, 0.0, 0.0]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn compose(self, first: Self) -> Self {
        S::compose_motors(self, first)
    }
}

/// The product of single-precision motors in the form for the target.
#[inline(always)]
pub(crate) fn compose_single(left: Motor<f32>, right: Motor<f32>) -> Motor<f32> {
    #[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
    {
        crate::unsafe_code::instructions::compose_in_registers(left, right)
    }
    #[cfg(not(all(target_arch = "x86_64", target_feature = "sse")))]
    {
        left * right
    }
}
