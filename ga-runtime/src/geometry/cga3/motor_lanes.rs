//! Motors side by side in the lanes of one motor, and back.

use crate::cga3::Motor;
use crate::scalar::{Lanes, Ring};

impl<T: Ring, const N: usize> Motor<Lanes<T, N>> {
    /// N motors side by side: each lane of the result is one of them. What is computed with it is
    /// computed for all of them, in vector instructions where the target or
    /// [`Batch::run`](crate::batch::Batch::run) has them.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// use ga_runtime::scalar::Lanes;
    /// let steps =
    ///     [1.0_f32, 2.0].map(|x| Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
    /// let both = Motor::from_lanes(&steps);
    /// let twice: [Motor<f32>; 2] = (both * both).to_lanes();
    /// assert_eq!(twice.map(|m| m.translator().displacement()[0]), [2.0, 4.0]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn from_lanes(motors: &[Motor<T>; N]) -> Self {
        Self::new_unchecked(
            lanes(motors, |motor| motor.scalar()),
            lanes(motors, |motor| motor.e12()),
            lanes(motors, |motor| motor.e13()),
            lanes(motors, |motor| motor.e23()),
            lanes(motors, |motor| motor.e1i()),
            lanes(motors, |motor| motor.e2i()),
            lanes(motors, |motor| motor.e3i()),
            lanes(motors, |motor| motor.e123i()),
        )
    }

    /// The motor in each lane.
    #[inline(always)]
    #[must_use]
    pub fn to_lanes(self) -> [Motor<T>; N] {
        core::array::from_fn(|lane| self.lane(lane))
    }

    /// The motor in one lane, from 0 to N − 1.
    ///
    /// # Panics
    /// There is no such lane.
    #[inline(always)]
    #[must_use]
    pub fn lane(self, lane: usize) -> Motor<T> {
        Motor::new_unchecked(
            self.scalar()[lane],
            self.e12()[lane],
            self.e13()[lane],
            self.e23()[lane],
            self.e1i()[lane],
            self.e2i()[lane],
            self.e3i()[lane],
            self.e123i()[lane],
        )
    }
}

#[inline(always)]
fn lanes<T: Ring, const N: usize>(
    motors: &[Motor<T>; N],
    coefficient: impl Fn(&Motor<T>) -> T,
) -> Lanes<T, N> {
    Lanes::from_array(core::array::from_fn(|lane| coefficient(&motors[lane])))
}
