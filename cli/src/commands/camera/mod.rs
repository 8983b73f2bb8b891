//! `nullcone camera`: cameras and their files.

mod calibrate;
mod convert;

use crate::frame::group;

group! {
    /// One camera: its calibration, and the conversion of files of cameras.
    Calibrate: calibrate::Arguments,
    Convert: convert::Arguments,
}
