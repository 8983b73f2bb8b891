//! Files of cameras and rigs.
//!
//! - [`yaml`]: named numbers, texts and matrices in the YAML that OpenCV's `FileStorage` writes.
//! - [`camera`]: one camera in that format, and [`rig`]: two of them.
//! - [`views`]: pictures with their cameras, as JSON.
//! - [`calib`]: the `calib.txt` of the Middlebury and ETH3D stereo data.
//!
//! Cameras themselves know no files. Errors name the line, and [`ga_files::ReadError`] the file.

pub mod calib;
pub mod camera;
pub mod rig;
pub mod views;
pub mod yaml;
