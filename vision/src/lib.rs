//! Stereo vision on conformal geometric algebra, after Y. Cui, "Geometric algebra-based modeling
//! techniques for 3D animation and their application to visual communication", which the modules
//! cite as "Cui".
//!
//! - [`attention`]: which parts of a frame people look at.
//! - `body`: poses of bodies from their joints in pictures (feature `body`).
//! - [`camera`]: cameras with lenses; the pixel of a point, and the [ray] of a pixel.
//! - [`frame`]: frames of reference in types.
//! - [`chessboard`]: the inner corners of chessboards in pictures.
//! - [`calibration`]: cameras and rigs from pictures of chessboards.
//! - [`homography`](mod@homography): maps between a plane and its picture.
//! - [`rig`]: two cameras and the motor between them.
//! - [`rectification`]: views in which the images of a point are in the same row.
//! - [`diagnosis`]: what is wrong with a pair of views that should be rectified.
//! - [`format`](mod@format): files of cameras and rigs.
//! - [`marker`]: painted discs that say which point they are.
//! - [`matcher`]: the disparity of every pixel of a rectified pair.
//! - [`triangulation`]: the point that two or more rays determine.
//! - [`disparity`]: disparity maps of rectified views, their files and their errors.
//! - [`surface`]: points, triangles and meshes from disparity maps.
//! - [`texture`]: textures of meshes from calibrated views.
//! - [`least_squares`]: nonlinear least squares over any unknowns, with covariances.
//! - [`comfort`]: how comfortable stereoscopic video is to watch.
//! - [`conjugate_gradient`]: linear equations whose matrix is too large to be stored.
//! - [`feature`]: corners, descriptors and matches of two views.
//! - [`relative_pose`]: the motion between two cameras from pairs of pixels.
//! - [`perspective_n_point`]: where a camera is that sees known points.
//! - [`capture`]: the pose of a head, its expression, and the motion of its whole surface.
//! - [`contour`]: borders of regions, snakes, and figures fitted to points.
//! - [`ransac`]: models that most observations agree with.
//! - [`modelling_points`]: points at several levels, with a depth and its deviation.
//! - [`keyframe`]: cuts, shots and key frames of videos.
//! - [`quality`]: how much pictures and videos differ from a reference, and where people look.
//! - [`video`]: frames one after another, as luma and colour differences.
//! - [`opinion`]: how well a measure of quality predicts what people say, and tables of ratings.
//! - [`observation`]: simulated observations with noise, for tests and demonstrations.
//! - [`pose_error`]: how far reconstructed joints are from the true ones.
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
//! use ga_vision::camera::Intrinsics;
//! use ga_vision::rig::StereoRig;
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

pub mod attention;
#[cfg(feature = "body")]
pub mod body;
pub mod calibration;
pub mod camera;
pub mod capture;
pub mod chessboard;
pub mod comfort;
pub mod conjugate_gradient;
pub mod contour;
pub mod diagnosis;
pub mod disparity;
pub mod feature;
pub mod format;
pub mod frame;
pub mod homography;
pub mod keyframe;
pub mod least_squares;
pub mod marker;
pub mod matcher;
pub mod modelling_points;
mod normalisation;
pub mod observation;
pub mod opinion;
pub mod perspective_n_point;
mod polynomial;
pub mod pose_error;
pub mod quality;
pub mod ransac;
pub mod rectification;
pub mod relative_pose;
pub mod rig;
pub mod surface;
pub mod texture;
pub mod triangulation;
pub mod video;
