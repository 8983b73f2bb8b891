//! `nullcone stereo`: two views of a scene.

mod calibrate;
mod diagnose;
mod evaluate;
mod match_views;
mod matching;
mod pose;
mod reconstruct;
mod rectify;
mod undistort;
pub(super) mod views;

pub(super) use reconstruct::Axes;

use crate::frame::group;

group! {
    /// Two views of a scene: calibration, rectification, motion, disparities and reconstruction.
    Calibrate: calibrate::Arguments,
    Match: match_views::Arguments,
    Evaluate: evaluate::Arguments,
    Pose: pose::Arguments,
    Rectify: rectify::Arguments,
    Undistort: undistort::Arguments,
    Diagnose: diagnose::Arguments,
    Reconstruct: reconstruct::Arguments,
}
