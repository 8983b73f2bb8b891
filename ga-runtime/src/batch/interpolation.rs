//! Interpolation between motors, pair by pair.

use super::error::same_length;
use super::{Batch, LengthMismatch};
use crate::cga3::Motor;
use crate::scalar::{Lanes, Real};
use crate::unsafe_code::{Work, run};

impl Batch {
    /// See [`interpolate`](super::interpolate).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn interpolate<S: Real<Mask = bool>>(
        self,
        from: &[Motor<S>],
        to: &[Motor<S>],
        t: &[S],
        between: &mut [Motor<S>],
    ) -> Result<(), LengthMismatch> {
        same_length(from.len(), to.len())?;
        same_length(from.len(), t.len())?;
        same_length(from.len(), between.len())?;
        run(
            self.instruction_set,
            AlongScrews(Pairs {
                from,
                to,
                t,
                between,
            }),
        );
        Ok(())
    }

    /// See [`nlerp`](super::nlerp).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn nlerp<S: Real>(
        self,
        from: &[Motor<S>],
        to: &[Motor<S>],
        t: &[S],
        between: &mut [Motor<S>],
    ) -> Result<(), LengthMismatch> {
        same_length(from.len(), to.len())?;
        same_length(from.len(), t.len())?;
        same_length(from.len(), between.len())?;
        run(
            self.instruction_set,
            Linear(Pairs {
                from,
                to,
                t,
                between,
            }),
        );
        Ok(())
    }
}

struct Pairs<'a, S> {
    from: &'a [Motor<S>],
    to: &'a [Motor<S>],
    t: &'a [S],
    between: &'a mut [Motor<S>],
}

/// Nlerp, in a loop that the compiler vectorises.
struct Linear<'a, S>(Pairs<'a, S>);

impl<S: Real> Work for Linear<'_, S> {
    #[inline(always)]
    fn run(self) {
        let Pairs {
            from,
            to,
            t,
            between,
        } = self.0;
        for (((from, to), t), between) in from.iter().zip(to).zip(t).zip(between) {
            *between = from.nlerp(*to, *t);
        }
    }
}

/// Slerp. Its branch to a careful method keeps the compiler from vectorising a loop, so the motors
/// are transposed into lanes.
struct AlongScrews<'a, S>(Pairs<'a, S>);

impl<S: Real<Mask = bool>> Work for AlongScrews<'_, S> {
    #[inline(always)]
    fn run(self) {
        if size_of::<S>() <= size_of::<f32>() {
            in_lanes::<S, 8>(self.0);
        } else {
            in_lanes::<S, 4>(self.0);
        }
    }
}

#[inline(always)]
fn in_lanes<S: Real<Mask = bool>, const N: usize>(pairs: Pairs<'_, S>) {
    let (from, from_rest) = pairs.from.as_chunks::<N>();
    let (to, to_rest) = pairs.to.as_chunks::<N>();
    let (t, t_rest) = pairs.t.as_chunks::<N>();
    let (between, between_rest) = pairs.between.as_chunks_mut::<N>();
    for (((from, to), t), between) in from.iter().zip(to).zip(t).zip(between) {
        let motor =
            Motor::from_lanes(from).interpolate(Motor::from_lanes(to), Lanes::from_array(*t));
        *between = motor.to_lanes();
    }
    let rest = from_rest.iter().zip(to_rest).zip(t_rest);
    for (((from, to), t), between) in rest.zip(between_rest) {
        *between = from.interpolate(*to, *t);
    }
}
