//! Logarithms and exponentials of slices.

use super::error::same_length;
use super::{Batch, LengthMismatch};
use crate::cga3::{Motor, MotorGenerator};
use crate::scalar::Real;
use crate::unsafe_code::{Work, run};

impl Batch {
    /// See [`log`](super::log).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn log<S: Real>(
        self,
        motors: &[Motor<S>],
        generators: &mut [MotorGenerator<S>],
    ) -> Result<(), LengthMismatch> {
        same_length(motors.len(), generators.len())?;
        run(self.instruction_set, Logarithms { motors, generators });
        Ok(())
    }

    /// See [`exp`](super::exp).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn exp<S: Real>(
        self,
        generators: &[MotorGenerator<S>],
        motors: &mut [Motor<S>],
    ) -> Result<(), LengthMismatch> {
        same_length(generators.len(), motors.len())?;
        run(self.instruction_set, Exponentials { generators, motors });
        Ok(())
    }
}

struct Logarithms<'a, S> {
    motors: &'a [Motor<S>],
    generators: &'a mut [MotorGenerator<S>],
}

impl<S: Real> Work for Logarithms<'_, S> {
    #[inline(always)]
    fn run(self) {
        for (motor, generator) in self.motors.iter().zip(self.generators) {
            *generator = motor.log();
        }
    }
}

struct Exponentials<'a, S> {
    generators: &'a [MotorGenerator<S>],
    motors: &'a mut [Motor<S>],
}

impl<S: Real> Work for Exponentials<'_, S> {
    #[inline(always)]
    fn run(self) {
        for (generator, motor) in self.generators.iter().zip(self.motors) {
            *motor = generator.exp();
        }
    }
}
