//! The space of a scene: its vectors, how large coordinates may be, and motions in it.

use ga_runtime::cga3::{Motor, Rotor};

/// A vector in the world, or in a camera's frame: right offset, up offset and depth.
pub(crate) type Vector = ga_runtime::vga3::Vector<f64>;

/// Squares and triple products of coordinates up to here stay finite.
pub(crate) const LARGEST_COORDINATE: f64 = 1e30;

/// Whether a motor is one, within rounding.
pub(crate) fn is_rigid(motor: Motor<f64>) -> bool {
    let rotor = motor.rotor();
    Rotor::try_new(rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23(), 1e-6).is_some()
}
