//! Facial capture: the pose of a head, its expression, and the motion of its whole surface (Cui,
//! §2.1.1).
//!
//! The motion of points on a face is that of the head as a rigid body, followed by what the muscles
//! add to it. Three or more calibrated points, which no expression moves, separate the two:
//!
//! - [`rigid_pose`]: the motor of the head, by least squares or robust against gross errors;
//! - [`Capture`]: frames of points, each as a pose and an expression in the frame of the head at
//!   rest, with its [`CaptureMatrix`];
//! - [`description_constant`]: the paper's eq. 1. Its eq. 2 is
//!   [`predicted_distance`](crate::modelling_points::predicted_distance).
//!
//! A few key points show how the whole surface moves:
//!
//! - [`SphericalParameterisation`]: the surface as seen from its centre of gravity;
//! - [`SurfaceMotion`]: the displacement of every vertex from those of the key points, by a
//!   [`SphericalSpline`];
//! - [`LocalArea`]: a part of the surface that moves while the rest stays, with its centre of
//!   gravity;
//! - [`PrincipalShapes`]: a sequence of expressions as morph targets with weights;
//! - [`HeadSurface`]: the mesh of a head that does all this, and its motion as glTF.
//!
//! [`table`] reads points and keys, and writes poses and expressions; [`summary`] says how far
//! points and surface move.
//!
//! Where the points are known only as pixels of one camera, [`estimate`] finds the pose.
//!
//! [`estimate`]: crate::perspective_n_point::estimate

mod area;
mod description;
mod error;
mod head;
mod pose;
mod principal;
mod sequence;
mod sphere;
mod spline;
pub mod summary;
mod surface_mesh;
mod surface_motion;
pub mod table;

pub use area::LocalArea;
pub use description::description_constant;
pub use error::{CaptureError, KeyProblem, PointSet};
pub use head::{HeadMotion, HeadSurface, KeyArea, KeyFit};
pub use pose::{PoseOptions, RigidPose, rigid_pose};
pub use principal::PrincipalShapes;
pub use sequence::{Capture, CaptureMatrix, CapturedFrame, FrameOutcome};
pub use sphere::SphericalParameterisation;
pub use spline::SphericalSpline;
pub use surface_mesh::SurfaceMesh;
pub use surface_motion::SurfaceMotion;
