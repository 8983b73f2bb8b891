//! ga-runtime without the standard library: its types, compiled functions and batches.
#![no_std]

use ga_runtime::batch::{Batch, Path};
use ga_runtime::cga3::{Motor, MotorGenerator, Point, Rotor, Translator};

ga_runtime::ga! { ga_runtime::cga3;
    /// The point moved.
    pub fn moved(m: Motor, p: Point) -> Point { m * p * reverse(m) }
}

/// A screw motion about the third axis; `None` where a number is not finite.
#[must_use]
pub fn screw(angle: f64, shift: f64) -> Option<Motor<f64>> {
    let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], angle)?;
    Some(Translator::from_displacement([0.0, 0.0, shift]) * rotor)
}

/// A part of a motion.
#[must_use]
pub fn part(motor: Motor<f64>, t: f64) -> Motor<f64> {
    let generator: MotorGenerator<f64> = motor.log() * t;
    generator.exp()
}

/// Moves all points by the instructions that every processor has.
pub fn move_all(motor: &Motor<f32>, points: &mut [Point<f32>]) {
    Batch::on(Path::Baseline).transform(motor, points);
}
