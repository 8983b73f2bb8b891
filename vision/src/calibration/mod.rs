//! Calibration of one camera, and of two cameras of a rig, from pictures of a chessboard.
//!
//! Each picture gives a [homography](crate::homography) from the board. From these come focal
//! lengths (Z. Zhang, "A flexible new technique for camera calibration", 2000, with the principal
//! point in the middle) and the motor of each board. A bundle adjustment then varies intrinsic
//! parameters and motors together until the sum of the squared distances between corners and
//! projections, in pixels, is least.
//!
//! ```
//! use ga_runtime::cga3::{Rotor, Translator};
//! use ga_vision::calibration::{CameraSettings, calibrate_camera};
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
//!     views.push(camera.project_all(&places).map_err(|(_, error)| error)?);
//! }
//! let found = calibrate_camera(&views, &places, [640, 480], &CameraSettings::default())?;
//! assert!((found.intrinsics.focal()[0] - 810.0).abs() < 1e-6 && found.rms < 1e-8);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bundle;
mod lens_terms;
mod one_camera;
mod square_edges;
mod stereo;

pub use lens_terms::{LensTerms, LensTermsError};
pub use one_camera::{CameraCalibration, CameraSettings, Start, calibrate_camera};
pub use square_edges::{SquareEdges, square_edges};
pub use stereo::{JointIntrinsics, Outlier, StereoCalibration, StereoSettings, calibrate_stereo};

use ga_runtime::cga3::Point;

use ga_camera::CameraError;
use ga_numerics::least_squares::LeastSquaresError;

/// The least number of boards from which a camera is calibrated.
pub const LEAST_VIEWS: usize = 3;

/// Why a calibration failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// Too few boards were found.
    #[error("a calibration needs {LEAST_VIEWS} boards or more, not {found}")]
    TooFewViews {
        /// How many there are.
        found: usize,
    },
    /// The two cameras see different numbers of boards.
    #[error("{left} boards in the left views, {right} in the right ones")]
    Counts {
        /// Boards of the left camera.
        left: usize,
        /// Boards of the right camera.
        right: usize,
    },
    /// A view has another number of corners than the board.
    #[error("view {view} has {found} corners, not {expected}")]
    Corners {
        /// The view, from 0.
        view: usize,
        /// Its corners.
        found: usize,
        /// Those of the board.
        expected: usize,
    },
    /// A corner or a place on the board is not finite.
    #[error("corner {corner} of view {view} is not finite")]
    NotFinite {
        /// The view, from 0.
        view: usize,
        /// The corner, from 0.
        corner: usize,
    },
    /// The corners of a view lie on one line, or do not belong to a board in front of the camera.
    #[error("the corners of view {view} are not those of a board in front of the camera")]
    View {
        /// The view, from 0.
        view: usize,
    },
    /// The motion between the cameras that fits most pairs moves the board of a pair to where the
    /// right camera cannot see it.
    #[error("the board of pair {pair} lies where the right camera cannot see it")]
    Unseen {
        /// The pair, from 0.
        pair: usize,
    },
    /// At least half of the pairs do not agree with the others.
    #[error(
        "at least half of the {pairs} pairs do not agree with the others; pair {}: {outlier}",
        outlier.pair
    )]
    Disagreement {
        /// How many pairs there are.
        pairs: usize,
        /// The outlier after which no more than half of the pairs would be left.
        outlier: Outlier,
    },
    /// A corner lies where the lens that is given sees nothing.
    #[error("corner {corner} of view {view}: {error}")]
    Pixel {
        /// The view, from 0.
        view: usize,
        /// The corner, from 0.
        corner: usize,
        /// What is wrong with it.
        error: CameraError,
    },
    /// The size of the pictures does not form a camera.
    #[error("no camera to begin with: {0}")]
    Camera(#[from] CameraError),
    /// The bundle adjustment failed.
    #[error("the calibration failed: {0}")]
    LeastSquares(#[from] LeastSquaresError),
    /// The distance between the cameras cannot be told from 0, as where both cameras have the same
    /// pictures.
    #[error("the baseline of {metres:.3e} m cannot be told from 0: are the views of two cameras?")]
    Baseline {
        /// The distance that was found, in metres.
        metres: f64,
    },
    /// The views do not determine a parameter: boards that are all parallel do not determine the
    /// focal length.
    #[error("the views do not determine {parameter}: show the board at more angles")]
    Undetermined {
        /// The name of the parameter.
        parameter: &'static str,
    },
}

impl CalibrationError {
    /// The view, or the pair, that is to blame, from 0.
    #[must_use]
    pub fn view(&self) -> Option<usize> {
        match *self {
            Self::Corners { view, .. }
            | Self::NotFinite { view, .. }
            | Self::Pixel { view, .. }
            | Self::View { view }
            | Self::Unseen { pair: view } => Some(view),
            Self::Disagreement { outlier, .. } => Some(outlier.pair),
            _ => None,
        }
    }
}

/// Checks the corners of views of a board.
fn check(views: &[Vec<[f64; 2]>], places: &[Point<f64>]) -> Result<(), CalibrationError> {
    if views.len() < LEAST_VIEWS {
        return Err(CalibrationError::TooFewViews { found: views.len() });
    }
    for (view, corners) in views.iter().enumerate() {
        let (found, expected) = (corners.len(), places.len());
        if found != expected {
            return Err(CalibrationError::Corners {
                view,
                found,
                expected,
            });
        }
        let is_finite = |index: usize| {
            let [u, v] = corners[index];
            u.is_finite()
                && v.is_finite()
                && places[index].coordinates().iter().all(|x| x.is_finite())
        };
        if let Some(corner) = (0..found).find(|&index| !is_finite(index)) {
            return Err(CalibrationError::NotFinite { view, corner });
        }
    }
    Ok(())
}
