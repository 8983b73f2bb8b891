//! Views as the cameras of files, and pictures with their cameras.
//!
//! [`from_camera`] and [`to_camera`] lead from a [`NamedCamera`](ga_camera::format::NamedCamera) to
//! a [`View`](crate::View) and back; [`ViewFiles`] are pictures in one folder with the file of
//! their cameras.
//!
//! ```
//! use ga_render::{View, view_file};
//!
//! let view = View::look_at([0.0, 0.0, 4.0], [0.0; 3], [0.0, 1.0, 0.0], 0.8, 0.1)?;
//! let camera = view_file::to_camera("front", &view, [640, 480])?;
//! let again = view_file::from_camera(&camera)?;
//! let [column, row, depth] = again.project([0.0; 3], 640, 480).ok_or("not seen")?;
//! assert!((column - 320.0).abs() < 1e-9 && (row - 240.0).abs() < 1e-9 && depth == 4.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod camera;
mod error;
mod folder;

pub use camera::{from_camera, to_camera};
pub use error::ViewFileError;
pub use folder::{ViewFiles, names};
