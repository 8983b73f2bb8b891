//! The calibration of the cameras of a rig, which see a board one after the other or together.

use ga_numerics::least_squares::{Covariance, Loss, Options, minimise};
use ga_numerics::order_statistics::median;
use ga_runtime::cga3::{Motor, Point};

use super::LEAST_VIEWS;
use super::board_view::BoardView;
use super::bundle::{Bundle, BundleState, TWIST};
use super::camera_graph::motions_from_first;
use super::error::CalibrationError;
use super::one_camera::{
    CameraCalibration, CameraOptions, calibrate_camera, covariance, deviations,
};
use super::outlier::Outlier;
use ga_camera::frame::{Board, LeftCamera, Pose};
use ga_camera::{Camera, Intrinsics};

/// What becomes of the intrinsic parameters when all cameras are calibrated together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum JointIntrinsics {
    /// They vary with the motors. The views of one camera then help to determine the others.
    #[default]
    Free,
    /// They stay as the calibration of each camera by itself has found them, as with OpenCV's flag
    /// `CALIB_FIX_INTRINSIC`.
    Fixed,
}

/// How the cameras of a rig are calibrated.
#[derive(Clone, Debug, PartialEq)]
pub struct RigOptions {
    /// The calibration of each camera.
    pub cameras: Vec<CameraOptions>,
    /// What the joint calibration varies.
    pub joint: JointIntrinsics,
    /// A frame is left out where its root mean square distance is more than this times the median
    /// of all frames; `None` keeps all frames.
    pub outlier_ratio: Option<f64>,
}

impl RigOptions {
    /// Free intrinsic parameters of a number of cameras, and frames up to 4 times the median.
    #[must_use]
    pub fn new(cameras: usize) -> Self {
        Self {
            cameras: vec![CameraOptions::default(); cameras],
            joint: JointIntrinsics::default(),
            outlier_ratio: Some(4.0),
        }
    }
}

/// The cameras of a rig and the boards that they see.
#[derive(Clone, Debug, PartialEq)]
pub struct RigCalibration {
    /// The cameras. The world is the first camera's frame.
    pub cameras: Vec<Camera>,
    /// For each camera the standard deviations of the intrinsic parameters, in the order of
    /// [`Intrinsics::parameters`], 0 for those that did not vary. With [`JointIntrinsics::Fixed`]
    /// they are those of each camera by itself, and the deviations of the motions do not contain
    /// them.
    pub deviations: Vec<[f64; Intrinsics::MAX_PARAMETERS]>,
    /// For each camera the standard deviations of the twist of the motor from the first frame to
    /// its own: three of the angular velocity ω in radians, and three of the velocity u of the
    /// origin in metres; 0 for the first one. The translation t varies by `ω × t + u`, so that only
    /// its length varies by u alone.
    pub motion_deviations: Vec<[f64; 6]>,
    /// For each camera the standard deviation of its distance from the first one in metres.
    pub distance_deviations: Vec<f64>,
    /// The frames that were used.
    pub used: Vec<usize>,
    /// The frames that were left out.
    pub outliers: Vec<Outlier>,
    /// For each frame that was used the motor that takes the board into the first camera's frame.
    pub boards: Vec<Pose<Board, LeftCamera>>,
    /// The root mean square distance of all corners from the projections of their places, in
    /// pixels.
    pub rms: f64,
    /// The same for each camera.
    pub camera_rms: Vec<f64>,
    /// The same for each frame that was used.
    pub frame_rms: Vec<f64>,
}

impl RigCalibration {
    /// Whether the distance of a camera other than the first one from that cannot be told from 0,
    /// as where views of one camera are given twice.
    #[must_use]
    pub fn is_where_the_first_is(&self, camera: usize) -> bool {
        /// The least distance as a part of that to the farthest board.
        const LEAST_PART: f64 = 1e-6;
        /// The least distance in standard deviations.
        const LEAST_DEVIATIONS: f64 = 3.0;
        let first = self.cameras[0].centre();
        let metres = first.distance(self.cameras[camera].centre());
        let boards = self.boards.iter().map(|board| {
            let origin = board.motor.transform(Point::default());
            origin.distance(Point::default())
        });
        let least = LEAST_PART * boards.fold(0.0, f64::max);
        // A deviation that is not a number says as little.
        let is_elsewhere =
            metres > least && metres > LEAST_DEVIATIONS * self.distance_deviations[camera];
        camera > 0 && !is_elsewhere
    }
}

/// Calibrates the cameras of a rig from the corners of boards.
///
/// `views` has for each camera and each frame the corners of the board, none where the camera does
/// not see it. Each camera needs three boards, and boards that two cameras see at once must join
/// all cameras, one with the next: no board needs to be seen by all. `sizes` has the columns and
/// rows of the pictures of each camera; otherwise as [`calibrate_camera`](super::calibrate_camera).
///
/// Each camera is calibrated by itself. The motions between cameras are those of the boards that
/// both see, along the tree of pairs with the most common boards; then all is adjusted together.
///
/// # Errors
///
/// [`CalibrationError`]: a view is counted in the frames as they were given, and
/// [`CalibrationError::OfCamera`] names the camera.
///
/// ```
/// use ga_camera::{Camera, Intrinsics};
/// use ga_runtime::cga3::{Motor, Rotor, Translator};
/// use ga_vision::calibration::{BoardView, RigOptions, calibrate_rig};
/// use ga_vision::chessboard::BoardSize;
///
/// // Three equal cameras in a row. The first and the last never see the board together.
/// let places = BoardSize::new(9, 6)?.places(0.025);
/// let intrinsics = Intrinsics::new([810.0, 805.0], [322.0, 238.0])?;
/// let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5], [-1.0, 2.0, 0.0]];
/// let mut views = vec![Vec::new(); 3];
/// for frame in 0..8 {
///     let side = if frame < 4 { 0.0 } else { 0.3 };
///     let rotor = Rotor::from_axis_angle(axes[frame % 4], 0.5).ok_or("no axis")?;
///     let board: Motor<f64> = Translator::from_displacement([side - 0.1, -0.06, 0.8]) * rotor;
///     for (camera, views) in views.iter_mut().enumerate() {
///         let away = Translator::from_displacement([-0.15 * camera as f64, 0.0, 0.0]);
///         let seen = Camera { intrinsics, world_to_camera: away * board };
///         let sees = camera != if frame < 4 { 2 } else { 0 };
///         views.push(match sees {
///             true => BoardView::complete(&seen.project_all(&places).map_err(|(_, e)| e)?),
///             false => BoardView::default(),
///         });
///     }
/// }
/// let found = calibrate_rig(&views, &places, &[[640, 480]; 3], &RigOptions::new(3))?;
/// let last = found.cameras[2].centre().coordinates();
/// assert!((last[0] - 0.3).abs() < 1e-6 && found.rms < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn calibrate_rig<V: AsRef<[BoardView]>>(
    views: &[V],
    places: &[Point<f64>],
    sizes: &[[usize; 2]],
    options: &RigOptions,
) -> Result<RigCalibration, CalibrationError> {
    let views: Vec<&[BoardView]> = views.iter().map(AsRef::as_ref).collect();
    let frames = views.first().map_or(0, |views| views.len());
    let counts = [sizes.len(), options.cameras.len()];
    if let Some(other) = counts.into_iter().find(|count| *count != views.len()) {
        return Err(CalibrationError::CameraCounts {
            views: views.len(),
            other,
        });
    }
    if let Some(other) = views.iter().find(|views| views.len() != frames) {
        return Err(CalibrationError::Counts {
            left: frames,
            right: other.len(),
        });
    }
    let is_seen = |frame: &usize| views.iter().any(|views| sees(&views[*frame]));
    let mut used: Vec<usize> = (0..frames).filter(is_seen).collect();
    let frames = used.len();
    let mut outliers = Vec::new();
    loop {
        let chosen = |views: &&[BoardView]| used.iter().map(|&k| views[k].clone()).collect();
        let chosen: Vec<Vec<BoardView>> = views.iter().map(chosen).collect();
        let rig = Rig::new(&chosen, places, sizes, options);
        let rig = rig.map_err(|error| error.in_frames(&used))?;
        // A frame with a board in another place than the rest would keep the rest from converging.
        let before = rig.frame_rms(&rig.state);
        let rough = options.outlier_ratio.map(|ratio| 5.0 * ratio);
        if let Some(outlier) = worst(&before, &used, rough) {
            check_majority(outlier, used.len(), frames)?;
            used.retain(|frame| *frame != outlier.pair);
            outliers.push(outlier);
            continue;
        }
        if let Some(unseen) = before.iter().position(|rms| rms.is_infinite()) {
            return Err(CalibrationError::Unseen { pair: used[unseen] });
        }
        let after = rig.frame_rms(&rig.robust_state());
        let Some(outlier) = worst(&after, &used, options.outlier_ratio) else {
            let found = rig.adjusted(&used)?;
            return Ok(RigCalibration { outliers, ..found });
        };
        check_majority(outlier, used.len(), frames)?;
        used.retain(|frame| *frame != outlier.pair);
        outliers.push(outlier);
    }
}

/// Checks that more than half of all frames are left without an outlier.
fn check_majority(outlier: Outlier, used: usize, frames: usize) -> Result<(), CalibrationError> {
    match 2 * (used - 1) > frames {
        true => Ok(()),
        false => Err(CalibrationError::Disagreement {
            pairs: frames,
            outlier,
        }),
    }
}

/// The frame with the greatest distance, where that is too great. As many frames as a calibration
/// needs are kept.
fn worst(frame_rms: &[f64], used: &[usize], ratio: Option<f64>) -> Option<Outlier> {
    /// Distances up to this are not those of outliers, however small the others are.
    const NEGLIGIBLE: f64 = 0.1;
    let mut sorted = frame_rms.to_vec();
    sorted.retain(|rms| rms.is_finite());
    let median = median(&mut sorted)?;
    let (place, rms) = (frame_rms.iter().enumerate()).max_by(|a, b| a.1.total_cmp(b.1))?;
    let is_outlier = *rms > ratio? * median.max(NEGLIGIBLE) && used.len() > LEAST_VIEWS;
    is_outlier.then(|| Outlier {
        pair: used[place],
        rms: *rms,
        median,
    })
}

/// The joint calibration of all frames, and where it begins.
struct Rig<'a> {
    bundle: Bundle<'a>,
    state: BundleState,
    /// The deviations of the cameras by themselves.
    deviations: Vec<[f64; Intrinsics::MAX_PARAMETERS]>,
}

impl<'a> Rig<'a> {
    /// All cameras calibrated by themselves, and the motors between them that fit most boards.
    fn new(
        views: &'a [Vec<BoardView>],
        places: &'a [Point<f64>],
        sizes: &[[usize; 2]],
        options: &RigOptions,
    ) -> Result<Self, CalibrationError> {
        let mut alone = Vec::new();
        for (camera, views) in views.iter().enumerate() {
            alone.push(Alone::new(camera, views, places, sizes[camera], options)?);
        }
        let boards: Vec<_> = alone.iter().map(|alone| alone.boards.as_slice()).collect();
        let motions = motions_from_first(&boards, places)?;
        let free = options.cameras.iter().map(|camera| match options.joint {
            JointIntrinsics::Free => camera.free(),
            JointIntrinsics::Fixed => Vec::new(),
        });
        let bundle = Bundle {
            places,
            views: views.iter().map(|views| views.iter().collect()).collect(),
            free: free.collect(),
        };
        // One camera may see a board almost alike in two poses; the others tell which is right.
        let by_camera = |camera: usize, frame: usize| {
            let back = match camera {
                0 => Motor::default(),
                other => motions[other - 1].reverse(),
            };
            alone[camera].boards[frame].map(|board| back * board)
        };
        let frames = 0..views[0].len();
        let cameras = || 0..views.len();
        let first = frames.clone().map(|frame| {
            let found = cameras().find_map(|camera| by_camera(camera, frame));
            found.unwrap_or_default()
        });
        let mut found = Self {
            bundle,
            state: BundleState {
                cameras: alone.iter().map(|alone| alone.intrinsics).collect(),
                motions: motions.clone(),
                boards: first.collect(),
            },
            deviations: alone.iter().map(|alone| alone.deviations).collect(),
        };
        let mut errors = found.frame_rms(&found.state);
        for camera in cameras().skip(1) {
            let mut other = found.state.clone();
            for (frame, board) in other.boards.iter_mut().enumerate() {
                *board = by_camera(camera, frame).unwrap_or(*board);
            }
            let others = found.frame_rms(&other);
            for frame in frames.clone() {
                if errors[frame].is_finite() && others[frame] < errors[frame] {
                    found.state.boards[frame] = other.boards[frame];
                    errors[frame] = others[frame];
                }
            }
        }
        Ok(found)
    }

    /// For each frame the root mean square distance of the corners of all views. It is infinite
    /// where a camera cannot see the board that its view shows.
    fn frame_rms(&self, state: &BundleState) -> Vec<f64> {
        let errors = self.bundle.squared_errors(state);
        let mut sums = vec![(0.0, 0); state.boards.len()];
        for (camera, errors) in errors.iter().enumerate() {
            let of_frames = sums.iter_mut().zip(errors).zip(self.bundle.counts(camera));
            for ((sum, error), count) in of_frames {
                *sum = (sum.0 + error, sum.1 + count);
            }
        }
        let rms = sums.into_iter();
        rms.map(|(sum, count)| (sum / count as f64).sqrt())
            .collect()
    }

    /// The state where the losses of Huber are least, to which outliers matter less.
    fn robust_state(&self) -> BundleState {
        let options = Options {
            loss: Loss::Huber(0.5),
            relative_tolerance: 1e-3,
            ..Options::default()
        };
        let found = minimise(&self.bundle, self.state.clone(), &options);
        found.map_or_else(|_| self.state.clone(), |minimum| minimum.state)
    }

    fn adjusted(self, used: &[usize]) -> Result<RigCalibration, CalibrationError> {
        let minimum = minimise(&self.bundle, self.state.clone(), &Options::default())?;
        let covariance = covariance(&self.bundle, &minimum)?;
        let state = &minimum.state;
        let errors = self.bundle.squared_errors(state);
        let mut found = RigCalibration {
            cameras: Vec::new(),
            deviations: Vec::new(),
            motion_deviations: vec![[0.0; TWIST]],
            distance_deviations: vec![0.0],
            used: used.to_vec(),
            outliers: Vec::new(),
            boards: state.boards.iter().copied().map(Pose::new).collect(),
            rms: 0.0,
            camera_rms: Vec::new(),
            frame_rms: self.frame_rms(state),
        };
        let mut corners = 0;
        for (camera, intrinsics) in state.cameras.iter().enumerate() {
            let world_to_camera = match camera {
                0 => Motor::default(),
                other => state.motions[other - 1],
            };
            found.cameras.push(Camera {
                intrinsics: *intrinsics,
                world_to_camera,
            });
            found
                .deviations
                .push(match self.bundle.free[camera].is_empty() {
                    true => self.deviations[camera],
                    false => deviations(&self.bundle, state, camera, &covariance)?,
                });
            if camera > 0 {
                let column = self.bundle.motion_column(camera);
                let of_motion = |k| covariance.standard_deviation(column + k);
                found.motion_deviations.push(std::array::from_fn(of_motion));
                let deviation = distance_deviation(&world_to_camera, &covariance, column);
                found.distance_deviations.push(deviation);
            }
            let count: usize = self.bundle.counts(camera).sum();
            let sum: f64 = errors[camera].iter().sum();
            found.camera_rms.push((sum / count as f64).sqrt());
            corners += count;
        }
        found.rms = (minimum.cost / corners as f64).sqrt();
        Ok(found)
    }
}

/// The standard deviation of the length of a motion's translation t, which varies by `u · t/|t|`.
fn distance_deviation(motion: &Motor<f64>, covariance: &Covariance, column: usize) -> f64 {
    let translation = motion.translator().displacement();
    let squared: f64 = translation.iter().map(|x| x * x).sum();
    let velocity = column + TWIST / 2;
    let mut sum = 0.0;
    for (i, x) in translation.iter().enumerate() {
        for (j, y) in translation.iter().enumerate() {
            sum += x * y * covariance.shared(velocity + i, velocity + j);
        }
    }
    (sum / squared).max(0.0).sqrt()
}

/// Whether a view shows the board.
pub(super) fn sees(view: &BoardView) -> bool {
    !view.points().is_empty()
}

/// A camera calibrated by itself.
struct Alone {
    intrinsics: Intrinsics,
    deviations: [f64; Intrinsics::MAX_PARAMETERS],
    /// For each frame the board, where the camera sees it.
    boards: Vec<Option<Motor<f64>>>,
}

impl Alone {
    fn new(
        camera: usize,
        views: &[BoardView],
        places: &[Point<f64>],
        size: [usize; 2],
        options: &RigOptions,
    ) -> Result<Self, CalibrationError> {
        let seen: Vec<usize> = (0..views.len()).filter(|&k| sees(&views[k])).collect();
        let own: Vec<BoardView> = seen.iter().map(|&k| views[k].clone()).collect();
        let CameraCalibration {
            intrinsics,
            deviations,
            boards: found,
            ..
        } = calibrate_camera(&own, places, size, &options.cameras[camera])
            .map_err(|error| error.in_frames(&seen).of_camera(camera))?;
        let mut boards = vec![None; views.len()];
        for (frame, board) in seen.into_iter().zip(found) {
            boards[frame] = Some(board.motor);
        }
        Ok(Self {
            intrinsics,
            deviations,
            boards,
        })
    }
}
