//! Cameras, rigs and triangulation against independent formulas and other libraries.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod camera;
mod colmap;
mod format;
mod format_faults;
mod formats;
mod lens_choice;
mod lens_models;
mod many_views;
mod rig;
mod storage;
mod two_views;
mod views;

use ga_runtime::cga3::{Motor, Rotor, Translator};
use proptest::prelude::*;
fn motor(axis: [f64; 3], angle: f64, displacement: [f64; 3]) -> Motor<f64> {
    Translator::from_displacement(displacement)
        * Rotor::from_axis_angle(axis, angle).unwrap_or_default()
}

fn vector(size: f64) -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-size..size)
}
