//! Files of cameras and rigs.
//!
//! [`read`] makes a [`CameraFile`] of a file of any [`Format`], which its contents tell, and
//! [`encode_files`] writes one in a format that is chosen. [`Format`] is the table of them.
//!
//! | format | module | written |
//! | --- | --- | --- |
//! | OpenCV's YAML, XML and JSON of one camera or two | `opencv`; [`camera`], [`rig`] | yes |
//! | JSON of one camera or of views, pictures with their cameras | [`json`] | yes |
//! | `camchain.yaml` of kalibr, `sensor.yaml` of EuRoC | `kalibr` | yes |
//! | ROS' `camera_info`, also as `rostopic echo` prints it | `ros` | yes |
//! | `calib.txt` and `calib_cam_to_cam.txt` of KITTI | `kitti` | yes |
//! | `calib.txt` of Middlebury and ETH3D | [`middlebury`] | yes |
//! | models of COLMAP, as text and binary | `colmap` | as text |
//! | TOML of aniposelib and Pose2Sim | `anipose` | yes |
//! | calibrations of Qualisys | `qualisys` | no |
//! | `transforms.json` of Blender's, instant-ngp's and nerfstudio's data | `transforms` | no |
//!
//! [`storage`] holds named numbers, texts and matrices as OpenCV's `FileStorage` does; `syntax`
//! parses what texts are made of. Cameras themselves know no files. Errors name line, view and key,
//! and [`ga_files::ReadError`] the file.

mod anipose;
pub mod camera;
mod camera_file;
mod colmap;
mod contents;
mod error;
mod fields;
pub mod json;
mod json_line;
mod kalibr;
mod key_values;
mod kitti;
mod lens;
mod lens_name;
pub mod middlebury;
mod named_parameters;
mod node;
mod opencv;
mod picture_size;
mod qualisys;
mod read;
pub mod rig;
mod ros;
mod rotation;
pub mod storage;
mod summary;
mod syntax;
mod table;
mod text;
mod transforms;
mod write;

pub use camera_file::{CameraFile, NamedCamera, NamedRig, Rectified};
pub use error::{CameraFileError, PictureSizeError, Place};
pub use read::{decode, read, read_with_format};
pub use summary::CameraSummary;
pub use table::Format;
pub use write::{Encoded, Omission, encode_files};
