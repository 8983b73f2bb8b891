//! Calibration of one camera, of two, and of the cameras of a rig, from pictures of a chessboard.
//!
//! Each picture gives a [homography](crate::homography) from the board. From these come focal
//! lengths (Z. Zhang, "A flexible new technique for camera calibration", 2000, with the principal
//! point in the middle) and the motor of each board. A bundle adjustment then varies intrinsic
//! parameters and motors together until the sum of the squared distances between corners and
//! projections, in pixels, is least.
//!
//! ```
//! use ga_runtime::cga3::{Rotor, Translator};
//! use ga_vision::calibration::{BoardView, CameraOptions, calibrate_camera};
//! use ga_camera::{Camera, Intrinsics};
//! use ga_vision::chessboard::BoardSize;
//!
//! // A camera sees four boards, rotated about different axes.
//! let places = BoardSize::new(9, 6)?.places(0.025);
//! let intrinsics = Intrinsics::new([810.0, 805.0], [322.0, 238.0])?;
//! let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5], [-1.0, 2.0, 0.0]];
//! let mut views = Vec::new();
//! for axis in axes {
//!     let rotor = Rotor::from_axis_angle(axis, 0.5).ok_or("no axis")?;
//!     let world_to_camera = Translator::from_displacement([-0.1, -0.06, 0.6]) * rotor;
//!     let camera = Camera { intrinsics, world_to_camera };
//!     let pixels = camera.project_all(&places).map_err(|(_, error)| error)?;
//!     views.push(BoardView::complete(&pixels));
//! }
//! let found = calibrate_camera(&views, &places, [640, 480], &CameraOptions::default())?;
//! assert!((found.intrinsics.focal()[0] - 810.0).abs() < 1e-6 && found.rms < 1e-8);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod board_pairs;
mod board_rig;
mod board_view;
mod board_views;
mod bundle;
mod camera_graph;
mod camera_page;
mod error;
mod lens_choice;
mod lens_terms;
mod many_cameras;
mod one_camera;
mod outlier;
mod pair_names;
mod square_edges;
mod stereo;
mod summary;

pub use board_pairs::{BoardCalibration, BoardPairs, CalibrationDoubt, RejectedPair};
pub use board_rig::{BoardRig, RigCameraSummary, RigOfBoards};
pub use board_view::{BoardView, SeenPoint};
pub use board_views::{
    BoardViews, CameraDoubt, CameraOfBoards, CornerResidual, Parameter, RejectedView, ViewResidual,
};
pub(crate) use error::LEAST_FOUND;
pub use error::{CalibrationError, LEAST_POINTS, LEAST_VIEWS};
pub use lens_choice::{LensFit, TriedLens, calibrate_lens};
pub use lens_terms::LensTerms;
pub use many_cameras::{JointIntrinsics, RigCalibration, RigOptions, calibrate_rig};
pub use one_camera::{CameraCalibration, CameraOptions, Start, calibrate_camera};
pub use outlier::Outlier;
pub use pair_names::PairNames;
pub use square_edges::{SquareEdges, square_edges};
pub use stereo::{StereoCalibration, StereoOptions, calibrate_stereo};
pub use summary::{CameraParameters, Residuals, RigSummary};
