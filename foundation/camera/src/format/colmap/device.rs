//! What a model of COLMAP consists of.

use ga_runtime::cga3::Motor;

use crate::Intrinsics;

/// A camera of a model, which may have taken several images.
#[derive(Clone, Debug)]
pub(super) struct Device {
    pub(super) id: u32,
    pub(super) size: [usize; 2],
    pub(super) intrinsics: Intrinsics,
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
