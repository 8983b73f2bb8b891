//! `nullcone camera`: cameras and their files.

mod calibrate;
mod calibrate_rig;
mod convert;

use crate::frame::group;

group! {
    /// Cameras: the calibration of one or of a rig, and the conversion of their files.
    Calibrate: calibrate::Arguments,
    CalibrateRig: calibrate_rig::Arguments,
    Convert: convert::Arguments,
}
