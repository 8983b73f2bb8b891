//! Cameras on conformal geometric algebra: what they see, the rays of their pixels, and the points
//! that rays determine.
//!
//! - [`Camera`]: a pose and [`Intrinsics`] with a [`Lens`]; the pixel of a point, and the [ray] of
//!   a pixel.
//! - [`frame`]: frames of reference in types.
//! - [`rig`]: two cameras and the motor between them, as they stand and rectified.
//! - [`triangulation`]: the point that two or more rays determine.
//! - [`format`](mod@format): files of cameras and rigs.
//! - [`observation`]: simulated observations with noise, for tests and demonstrations.
//!
//! [ray]: ga_runtime::geometry::ray::Ray
//!
//! # Conventions
//!
//! Lengths are in metres, pictures in pixels. A camera's frame has x to the right, y down and z
//! forward along the optical axis. A pose is the motor that takes the world into the camera's
//! frame, `x_camera = M x ~M`. Pixel coordinates `[u, v]` count from the centre of the top left
//! pixel, u to the right and v down.
//!
//! ```
//! use ga_runtime::cga3::Point;
//! use ga_camera::Intrinsics;
//! use ga_camera::rig::StereoRig;
//!
//! // Two cameras side by side, 20 cm apart, looking the same way.
//! let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
//! let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let rig = StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.2, 0.0, 0.0])?;
//!
//! let point = Point::new(0.1, -0.2, 3.0);
//! let (left, right) = (rig.left.project(point)?, rig.right.project(point)?);
//! let seen = rig.triangulate(left, right)?;
//! assert!(seen.position.distance(point) < 1e-12 && seen.gap < 1e-12);
//! assert!(seen.is_in_front());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod camera;
pub mod format;
pub mod frame;
pub mod observation;
pub mod rig;
pub mod triangulation;

pub use camera::{
    Camera, CameraError, Fisheye, FrameProjection, Intrinsics, Lens, LensModel, RadialTangential,
    by_twist,
};
