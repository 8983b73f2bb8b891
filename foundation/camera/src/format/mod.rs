//! Files of cameras and rigs.
//!
//! [`read`] makes a [`CameraFile`] of a file of any format, which its contents tell:
//!
//! - [`camera`]: one camera in the YAML of OpenCV, and [`rig`]: two of them.
//! - [`json`]: one camera, or a list of views, which are pictures with their cameras.
//! - [`calib`]: the `calib.txt` of the Middlebury and ETH3D stereo data.
//! - [`yaml`]: named numbers, texts and matrices in the YAML that OpenCV's `FileStorage` writes.
//!
//! Cameras themselves know no files. Errors name line, view and key, and [`ga_files::ReadError`]
//! the file.

pub mod calib;
pub mod camera;
mod camera_file;
mod error;
pub mod json;
mod read;
pub mod rig;
mod rotation;
mod text;
pub mod yaml;

pub use camera_file::{CameraFile, NamedCamera, NamedRig, Rectified};
pub use error::{CameraFileError, PictureSizeError, Place};
pub use read::{decode, read};
