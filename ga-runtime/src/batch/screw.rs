//! Logarithms and exponentials of slices. Their time goes into elementary functions, which no path makes faster.

use super::{Batch, LengthMismatch, same_length};
use crate::cga3::{Motor, MotorGenerator};
use crate::scalar::Real;

impl Batch {
    /// See [`log`](super::log).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn log<S: Real<Mask = bool>>(
        self,
        motors: &[Motor<S>],
        generators: &mut [MotorGenerator<S>],
    ) -> Result<(), LengthMismatch> {
        same_length(motors.len(), generators.len())?;
        for (motor, generator) in motors.iter().zip(generators) {
            *generator = motor.log();
        }
        Ok(())
    }

    /// See [`exp`](super::exp).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn exp<S: Real<Mask = bool>>(
        self,
        generators: &[MotorGenerator<S>],
        motors: &mut [Motor<S>],
    ) -> Result<(), LengthMismatch> {
        same_length(generators.len(), motors.len())?;
        for (generator, motor) in generators.iter().zip(motors) {
            *motor = generator.exp();
        }
        Ok(())
    }
}
