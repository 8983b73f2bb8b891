//! Cameras as JSON: one of them, or a list of views, which are pictures with their cameras.
//!
//! A camera, as `nullcone render --camera-out` writes it:
//!
//! ```json
//! {"width": 640, "height": 480, "fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5,
//!  "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 2]}
//! ```
//!
//! Views, as `nullcone render --views` writes them:
//!
//! ```json
//! {"views": [
//!   {"picture": "front.png",
//!    "camera": {"width": 640, "height": 480, "fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5},
//!    "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 2]},
//!   {"picture": "side.jpg", "camera": "side.yml",
//!    "quaternion_wxyz": [0, 0.707107, 0, 0.707107], "translation": [0, 0.1, 2]},
//!   {"picture": "top.png", "camera": "top.json"}
//! ]}
//! ```
//!
//! Paths are relative to the file. Of each view:
//!
//! - `picture`: the path of the picture.
//! - `camera`: an object as below, or the path of a `.json` file with such an object, or that of
//!   [OpenCV's YAML or XML](super::camera).
//! - `rotation`: the rotation R from the world to the camera, three rows.
//! - `quaternion_wxyz`: the same as a quaternion, the scalar first, in place of `rotation`.
//! - `translation`: the translation t, in the unit of the mesh.
//!
//! A point p of the world is at x = R p + t in the camera's frame, with x to the right, y down and
//! z forward. The pose of a view stands beside the camera or in its object; a camera that is a file
//! of its own need not have one. In the object of a camera:
//!
//! - `width`, `height`: the size of the picture in pixels.
//! - `fx`, `fy`, `cx`, `cy`: focal lengths and principal point in pixels; (0, 0) is the middle of
//!   the top left pixel.
//! - `distortion`: 4, 5, 8, 12 or 14 coefficients in OpenCV's order, 4 for a fisheye; none for a
//!   pinhole.
//! - `lens`: `"pinhole"`, `"radial-tangential"` or `"fisheye"`, where the coefficients do not say
//!   it, as four of them do not.
//! - `skew`: in pixels, 0 by default. [`NamedCamera::intrinsics`] refuses another one.
//! - `near`, `far`: the depths between which a renderer draws.
//!
//! A rotation that has few digits is replaced by the nearest one.
//!
//! [`NamedCamera::intrinsics`]: super::NamedCamera::intrinsics

mod object;
mod read;
mod write;

pub(super) use read::{decode, is_own};
pub use write::{encode, encode_views};

/// The name of the file in a folder of views.
pub const VIEWS: &str = "views.json";
