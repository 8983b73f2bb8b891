//! Computer vision against independent formulas, other libraries and scenes that are known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod arrangement;
mod calibration;
mod capture;
mod capture_surface;
mod capture_tables;
mod chessboard;
mod circle_grid;
mod contour;
mod coverage;
mod deep_views;
mod dense;
mod diagnosis;
mod disparity;
mod feature;
mod gradient_vector_flow;
mod homography;
mod matcher;
mod modelling_points;
mod perspective_n_point;
mod rectification;
mod relative_pose;
mod space_curve;
mod surface;
mod synthetic_scene;
mod tag;
mod texture;
mod texture_blend;

use ga_runtime::cga3::{Motor, Rotor, Translator};
use proptest::prelude::*;
fn motor(axis: [f64; 3], angle: f64, displacement: [f64; 3]) -> Motor<f64> {
    Translator::from_displacement(displacement)
        * Rotor::from_axis_angle(axis, angle).unwrap_or_default()
}

fn vector(size: f64) -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-size..size)
}
