//! The calibration of two cameras of a rig.

use super::board_view::BoardView;
use super::error::{CalibrationError, LEAST_POINTS};
use super::many_cameras::{JointIntrinsics, RigOptions, calibrate_rig};
use super::one_camera::CameraOptions;
use super::outlier::Outlier;
use ga_camera::Intrinsics;
use ga_camera::frame::{Board, LeftCamera, Pose};
use ga_camera::rig::StereoRig;
use ga_runtime::cga3::Point;

/// How a rig is calibrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoOptions {
    /// The calibrations of the left and the right camera.
    pub cameras: [CameraOptions; 2],
    /// What the joint calibration varies.
    pub joint: JointIntrinsics,
    /// A pair is left out where its root mean square distance is more than this times the median of
    /// all pairs; `None` keeps all pairs.
    pub outlier_ratio: Option<f64>,
}

impl Default for StereoOptions {
    /// Free intrinsic parameters, and pairs up to 4 times the median.
    fn default() -> Self {
        Self {
            cameras: [CameraOptions::default(); 2],
            joint: JointIntrinsics::default(),
            outlier_ratio: Some(4.0),
        }
    }
}

/// A rig and the boards that it sees.
#[derive(Clone, Debug, PartialEq)]
pub struct StereoCalibration {
    /// The cameras. The world is the left camera's frame.
    pub rig: StereoRig,
    /// For the left and the right camera the standard deviations of the intrinsic parameters, in
    /// the order of [`Intrinsics::parameters`], 0 for those that did not vary. With
    /// [`JointIntrinsics::Fixed`] they are those of each camera by itself, and the deviations of
    /// the rig do not contain them.
    pub deviations: [[f64; Intrinsics::MAX_PARAMETERS]; 2],
    /// The standard deviations of the twist of the motor from the left frame to the right one:
    /// three of the angular velocity ω in radians, and three of the velocity u of the origin in
    /// metres. The translation t varies by `ω × t + u`, so that only its length varies by u alone.
    pub rig_deviations: [f64; 6],
    /// The standard deviation of the baseline in metres.
    pub baseline_deviation: f64,
    /// The pairs that were used.
    pub used: Vec<usize>,
    /// The pairs that were left out.
    pub outliers: Vec<Outlier>,
    /// For each pair that was used the motor that takes the board into the left camera's frame.
    pub boards: Vec<Pose<Board, LeftCamera>>,
    /// The root mean square distance of all corners in both views from the projections of their
    /// places, in pixels, as OpenCV's `stereoCalibrate` returns it.
    pub rms: f64,
    /// The same for the corners of the left views, and of the right ones.
    pub camera_rms: [f64; 2],
    /// The same for each pair that was used.
    pub pair_rms: Vec<f64>,
}

/// Calibrates a rig from the corners of boards that both cameras see.
///
/// `views` has the left views and the right ones, pair by pair, of which the points count that both
/// show; otherwise as [`calibrate_rig`].
///
/// # Errors
///
/// [`CalibrationError`]. A view is counted in the pairs as they were given.
///
/// ```
/// use ga_runtime::cga3::{Motor, Rotor, Translator};
/// use ga_vision::calibration::{BoardView, StereoOptions, calibrate_stereo};
/// use ga_camera::{Camera, Intrinsics};
/// use ga_vision::chessboard::BoardSize;
///
/// // Two equal cameras, the right one 12 cm to the right, see four boards.
/// let places = BoardSize::new(9, 6)?.places(0.025);
/// let intrinsics = Intrinsics::new([810.0, 805.0], [322.0, 238.0])?;
/// let left_to_right: Motor<f64> = Translator::from_displacement([-0.12, 0.0, 0.0]).into();
/// let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5], [-1.0, 2.0, 0.0]];
/// let mut views = [Vec::new(), Vec::new()];
/// for axis in axes {
///     let rotor = Rotor::from_axis_angle(axis, 0.5).ok_or("no axis")?;
///     let board: Motor<f64> = Translator::from_displacement([-0.1, -0.06, 0.6]) * rotor;
///     for (views, world_to_camera) in views.iter_mut().zip([board, left_to_right * board]) {
///         let camera = Camera { intrinsics, world_to_camera };
///         let pixels = camera.project_all(&places).map_err(|(_, error)| error)?;
///         views.push(BoardView::complete(&pixels));
///     }
/// }
/// let views = [&views[0][..], &views[1][..]];
/// let found = calibrate_stereo(views, &places, [640, 480], &StereoOptions::default())?;
/// assert!((found.rig.baseline() - 0.12).abs() < 1e-6 && found.rms < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn calibrate_stereo(
    views: [&[BoardView]; 2],
    places: &[Point<f64>],
    size: [usize; 2],
    options: &StereoOptions,
) -> Result<StereoCalibration, CalibrationError> {
    let [left, right] = views.map(<[_]>::len);
    if left != right {
        return Err(CalibrationError::Counts { left, right });
    }
    let mut shared = [Vec::new(), Vec::new()];
    for (view, (left, right)) in views[0].iter().zip(views[1]).enumerate() {
        let [left, right] = left.shared(right);
        let found = left.points().len();
        if found < LEAST_POINTS {
            return Err(CalibrationError::TooFewPoints { view, found });
        }
        shared[0].push(left);
        shared[1].push(right);
    }
    let found = calibrate_rig(
        &shared,
        places,
        &[size; 2],
        &RigOptions {
            cameras: options.cameras.to_vec(),
            joint: options.joint,
            outlier_ratio: options.outlier_ratio,
        },
    );
    let found = found.map_err(|error| match error {
        CalibrationError::OfCamera { error, .. } => *error,
        other => other,
    })?;
    let side = |k: usize| found.cameras[k];
    let rig = StereoRig {
        left: side(0),
        right: side(1),
    };
    if found.is_where_the_first_is(1) {
        return Err(CalibrationError::Baseline {
            metres: rig.baseline(),
        });
    }
    Ok(StereoCalibration {
        rig,
        deviations: [found.deviations[0], found.deviations[1]],
        rig_deviations: found.motion_deviations[1],
        baseline_deviation: found.distance_deviations[1],
        used: found.used,
        outliers: found.outliers,
        boards: found.boards,
        rms: found.rms,
        camera_rms: [found.camera_rms[0], found.camera_rms[1]],
        pair_rms: found.frame_rms,
    })
}
