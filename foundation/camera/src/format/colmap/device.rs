//! What a model of COLMAP consists of.

use std::collections::HashSet;

use ga_runtime::cga3::Motor;

use crate::Intrinsics;
use crate::format::error::{CameraFileError, Place};

/// A camera of a model, which may have taken several images.
#[derive(Clone, Debug)]
pub(super) struct Device {
    pub(super) id: u32,
    pub(super) size: [usize; 2],
    pub(super) intrinsics: Intrinsics,
    /// Its line in a text; 0 in a binary file.
    pub(super) line: usize,
}

/// An image of a model.
#[derive(Clone, Debug)]
pub(super) struct Shot {
    pub(super) device: u32,
    pub(super) name: String,
    pub(super) pose: Motor<f64>,
    /// Its line in a text; 0 in a binary file.
    pub(super) place: usize,
}

/// The devices, of which no two have one number: images would be of any of them.
pub(super) fn distinct(devices: Vec<Device>) -> Result<Vec<Device>, CameraFileError> {
    let mut ids = HashSet::new();
    let twice = devices.iter().find(|device| !ids.insert(device.id));
    match twice {
        None => Ok(devices),
        Some(device) => Err(CameraFileError::Duplicate(Place::on_line(
            device.line,
            format!("camera {}", device.id),
        ))),
    }
}
