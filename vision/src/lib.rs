//! Stereo vision on conformal geometric algebra, after Y. Cui, "Geometric algebra-based modeling
//! techniques for 3D animation and their application to visual communication", which the modules
//! cite as "Cui".
//!
//! - [`chessboard`]: the inner corners of chessboards in pictures.
//! - [`tag`]: ArUco markers, AprilTags and boards of them in pictures.
//! - [`circle_grid`]: the centres of grids of circles in pictures.
//! - [`board`]: boards of every kind, and where their points are.
//! - [`calibration`]: cameras and rigs from pictures of boards.
//! - [`homography`](mod@homography): maps between a plane and its picture.
//! - [`rectification`]: views in which the images of a point are in the same row.
//! - [`diagnosis`]: what is wrong with a pair of views that should be rectified.
//! - [`matcher`]: the disparity of every pixel of a rectified pair.
//! - [`disparity`]: disparity maps of rectified views, their files and their errors.
//! - [`surface`]: points, triangles and meshes from disparity maps.
//! - [`texture`]: textures of meshes from calibrated views.
//! - [`feature`]: corners, descriptors and matches of two views.
//! - [`relative_pose`]: the motion between two cameras from pairs of pixels.
//! - [`perspective_n_point`]: where a camera is that sees known points.
//! - [`capture`]: the pose of a head, its expression, and the motion of its whole surface.
//! - [`contour`]: borders of regions, snakes, and figures fitted to points.
//! - [`modelling_points`]: points at several levels, with a depth and its deviation.
//!
//! Cameras, rigs and triangulation are in [`ga_camera`], whose conventions hold here: lengths are
//! in metres, pictures in pixels, and a camera looks along z, with x to the right and y down.

pub mod board;
pub mod calibration;
pub mod capture;
pub mod chessboard;
pub mod circle_grid;
pub mod contour;
pub mod diagnosis;
pub mod disparity;
pub mod feature;
mod found_board;
mod geometry_error;
pub mod homography;
pub mod matcher;
pub mod modelling_points;
mod normalisation;
pub mod perspective_n_point;
pub mod rectification;
pub mod relative_pose;
mod rival;
pub mod surface;
pub mod tag;
pub mod texture;

pub use found_board::FoundBoard;
pub use geometry_error::ViewGeometryError;
