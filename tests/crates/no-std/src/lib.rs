//! ga-runtime without the standard library: its types, compiled functions and batches, and its
//! conversions to types of other crates.
#![no_std]

use ga_runtime::batch::{Batch, InstructionSet};
use ga_runtime::cga3::{Motor, MotorGenerator, Point, Rotor, Translator};

ga_runtime::ga! { ga_runtime::cga3;
    /// The image of the point.
    pub fn moved(m: Motor, p: Point) -> Point { m * p * reverse(m) }
}

/// A screw motion about the third axis; `None` where a number is not finite.
#[must_use]
pub fn screw(angle: f64, shift: f64) -> Option<Motor<f64>> {
    let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], angle)?;
    Some(Translator::from_displacement([0.0, 0.0, shift]) * rotor)
}

/// A fraction of a motion.
#[must_use]
pub fn part(motor: Motor<f64>, t: f64) -> Motor<f64> {
    let generator: MotorGenerator<f64> = motor.log() * t;
    generator.exp()
}

/// Moves all points with the instructions that every processor supports.
pub fn move_all(motor: &Motor<f32>, points: &mut [Point<f32>]) {
    Batch::on(InstructionSet::Baseline).transform(motor, points);
}

/// The motion of a vector and quaternion of glam, converted by way of nalgebra; `None` where the
/// quaternion is zero or a number is not finite.
#[must_use]
pub fn through_others(turn: glam_034::Quat, shift: glam_034::Vec3) -> Option<Motor<f32>> {
    let motor = Motor::try_from((turn, shift)).ok()?;
    Some(nalgebra_035::Isometry3::from(motor).into())
}

/// Where a motion that is given as text moves the origin; `None` where the text is not a motion.
#[must_use]
pub fn image_of_origin(motion: &str) -> Option<[f64; 3]> {
    let motor: Motor<f64> = motion.parse().ok()?;
    let point = motor.normalized()?.transform(Point::ORIGIN);
    point.is_finite().then(|| point.coordinates())
}

/// The bytes of points, for a vertex buffer.
#[must_use]
pub fn bytes(points: &[Point<f32>]) -> &[u8] {
    bytemuck_1::cast_slice(points)
}

/// Whether a motion is the identity, up to rounding.
#[must_use]
pub fn is_identity(motor: &Motor<f64>) -> bool {
    approx_05::abs_diff_eq!(*motor, num_traits_02::One::one())
}

/// Writes a motion.
///
/// # Errors
/// Those of the serializer.
pub fn write<S: serde_1::Serializer>(motor: &Motor<f64>, to: S) -> Result<S::Ok, S::Error> {
    serde_1::Serialize::serialize(motor, to)
}
