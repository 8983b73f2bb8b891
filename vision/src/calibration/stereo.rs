//! The calibration of two cameras of a rig.

use super::outlier::Outlier;

use ga_numerics::order_statistics::median;
use ga_runtime::cga3::{Motor, Point};

use super::board_view::BoardView;
use super::bundle::{Bundle, BundleState, TWIST};
use super::error::{LEAST_POINTS, LEAST_VIEWS};
use super::one_camera::{
    CameraCalibration, CameraOptions, calibrate_camera, covariance, deviations,
};
use crate::calibration::CalibrationError;
use ga_camera::frame::{Board, Frame, LeftCamera, Pose};
use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Intrinsics};
use ga_numerics::least_squares::{Covariance, Loss, Options, minimise};

/// What becomes of the intrinsic parameters when both cameras are calibrated together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum JointIntrinsics {
    /// They vary with the motors. The views of one camera then help to determine the other.
    #[default]
    Free,
    /// They stay as the calibration of each camera by itself has found them, as with OpenCV's flag
    /// `CALIB_FIX_INTRINSIC`.
    Fixed,
}

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
/// show; otherwise as [`calibrate_camera`].
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
    let mut used: Vec<usize> = (0..left).collect();
    let mut outliers = Vec::new();
    loop {
        let chosen = shared
            .each_ref()
            .map(|views| used.iter().map(|&k| views[k].clone()).collect());
        let rig = Rig::new(&chosen, places, size, options);
        let rig = rig.map_err(|error| error.in_pairs(&used))?;
        // A pair with a board in another place than the rest would keep the rest from converging.
        let before = rig.pair_rms(&rig.state);
        let rough = options.outlier_ratio.map(|ratio| 5.0 * ratio);
        if let Some(outlier) = worst(&before, &used, rough) {
            check_majority(outlier, used.len(), left)?;
            used.retain(|pair| *pair != outlier.pair);
            outliers.push(outlier);
            continue;
        }
        if let Some(unseen) = before.iter().position(|rms| rms.is_infinite()) {
            return Err(CalibrationError::Unseen { pair: used[unseen] });
        }
        let after = rig.pair_rms(&rig.robust_state());
        let Some(outlier) = worst(&after, &used, options.outlier_ratio) else {
            let found = rig.adjusted(&used)?;
            return Ok(StereoCalibration { outliers, ..found });
        };
        check_majority(outlier, used.len(), left)?;
        used.retain(|pair| *pair != outlier.pair);
        outliers.push(outlier);
    }
}

impl CalibrationError {
    /// The error of chosen views with the index that a view has among all.
    fn in_pairs(self, used: &[usize]) -> Self {
        match self {
            Self::View { view } => Self::View { view: used[view] },
            Self::NoSuchPoint { view, point, count } => Self::NoSuchPoint {
                view: used[view],
                point,
                count,
            },
            Self::Pixel { view, point, error } => Self::Pixel {
                view: used[view],
                point,
                error,
            },
            Self::NotFinite { view, point } => Self::NotFinite {
                view: used[view],
                point,
            },
            other => other,
        }
    }
}

/// Checks that more than half of all pairs are left without an outlier.
fn check_majority(outlier: Outlier, used: usize, pairs: usize) -> Result<(), CalibrationError> {
    match 2 * (used - 1) > pairs {
        true => Ok(()),
        false => Err(CalibrationError::Disagreement { pairs, outlier }),
    }
}

/// The pair with the greatest distance, where that is too great. As many pairs as a calibration
/// needs are kept.
fn worst(pair_rms: &[f64], used: &[usize], ratio: Option<f64>) -> Option<Outlier> {
    /// Distances up to this are not those of outliers, however small the others are.
    const NEGLIGIBLE: f64 = 0.1;
    let mut sorted = pair_rms.to_vec();
    sorted.retain(|rms| rms.is_finite());
    let median = median(&mut sorted)?;
    let (place, rms) = (pair_rms.iter().enumerate()).max_by(|a, b| a.1.total_cmp(b.1))?;
    let is_outlier = *rms > ratio? * median.max(NEGLIGIBLE) && used.len() > LEAST_VIEWS;
    is_outlier.then(|| Outlier {
        pair: used[place],
        rms: *rms,
        median,
    })
}

/// The joint calibration of pairs, and where it begins.
struct Rig<'a> {
    bundle: Bundle<'a>,
    state: BundleState,
    /// The deviations of the cameras by themselves.
    deviations: [[f64; Intrinsics::MAX_PARAMETERS]; 2],
}

impl<'a> Rig<'a> {
    /// Both cameras calibrated by themselves, and the motor between them that fits most boards.
    fn new(
        views: &'a [Vec<BoardView>; 2],
        places: &'a [Point<f64>],
        size: [usize; 2],
        options: &StereoOptions,
    ) -> Result<Self, CalibrationError> {
        let calibrate = |k: usize| calibrate_camera(&views[k], places, size, &options.cameras[k]);
        let [left, right] = [calibrate(0)?, calibrate(1)?];
        let free = options.cameras.map(|camera| match options.joint {
            JointIntrinsics::Free => camera.free(),
            JointIntrinsics::Fixed => Vec::new(),
        });
        let bundle = Bundle {
            places,
            views: views.iter().map(|views| views.iter().collect()).collect(),
            free: free.into(),
        };
        let rig = median_motion(&left, &right, places);
        let from_left = BundleState {
            cameras: vec![left.intrinsics, right.intrinsics],
            rig,
            boards: motors(&left.boards),
        };
        let right_boards = motors(&right.boards).into_iter();
        let from_right = BundleState {
            boards: right_boards.map(|board| rig.reverse() * board).collect(),
            ..from_left.clone()
        };
        let mut found = Self {
            bundle,
            state: from_left,
            deviations: [left.deviations, right.deviations],
        };
        // One camera may see a board almost alike in two poses; both cameras tell which is right.
        let errors = [&found.state, &from_right].map(|state| found.pair_rms(state));
        for (pair, board) in from_right.boards.into_iter().enumerate() {
            if errors[0][pair].is_finite() && errors[1][pair] < errors[0][pair] {
                found.state.boards[pair] = board;
            }
        }
        Ok(found)
    }

    /// For each pair the root mean square distance of the corners of both views.
    /// It is infinite where a camera cannot see the board.
    fn pair_rms(&self, state: &BundleState) -> Vec<f64> {
        let errors = self.bundle.squared_errors(state);
        let pairs = errors[0].iter().zip(&errors[1]).zip(self.bundle.counts(0));
        pairs
            .map(|((left, right), count)| ((left + right) / (2 * count) as f64).sqrt())
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

    fn adjusted(self, used: &[usize]) -> Result<StereoCalibration, CalibrationError> {
        let minimum = minimise(&self.bundle, self.state.clone(), &Options::default())?;
        let covariance = covariance(&self.bundle, &minimum)?;
        let state = &minimum.state;
        let errors = self.bundle.squared_errors(state);
        let count = self.bundle.counts(0).sum::<usize>() as f64;
        let camera_rms = |k: usize| (errors[k].iter().sum::<f64>() / count).sqrt();
        let camera = |k: usize, world_to_camera| Camera {
            intrinsics: state.cameras[k],
            world_to_camera,
        };
        let column = self.bundle.rig_column();
        let baseline_deviation = baseline_deviation(state, &covariance, column)?;
        let own = |k: usize| match self.bundle.free[k].is_empty() {
            true => Ok(self.deviations[k]),
            false => deviations(&self.bundle, state, k, &covariance),
        };
        Ok(StereoCalibration {
            rig: StereoRig {
                left: camera(0, Motor::default()),
                right: camera(1, state.rig),
            },
            deviations: [own(0)?, own(1)?],
            rig_deviations: std::array::from_fn(|k| covariance.standard_deviation(column + k)),
            baseline_deviation,
            used: used.to_vec(),
            outliers: Vec::new(),
            boards: state.boards.iter().copied().map(Pose::new).collect(),
            rms: (minimum.cost / (2.0 * count)).sqrt(),
            camera_rms: [camera_rms(0), camera_rms(1)],
            pair_rms: self.pair_rms(state),
        })
    }
}

/// The standard deviation of the length of the rig's translation t: it varies by `u · t / |t|`. An
/// error where the length cannot be told from 0.
fn baseline_deviation(
    state: &BundleState,
    covariance: &Covariance,
    column: usize,
) -> Result<f64, CalibrationError> {
    /// The least baseline as a part of the distance to the farthest board.
    const LEAST_PART: f64 = 1e-6;
    /// The least baseline in standard deviations.
    const LEAST_DEVIATIONS: f64 = 3.0;
    let translation = state.rig.translator().displacement();
    let squared: f64 = translation.iter().map(|x| x * x).sum();
    let metres = squared.sqrt();
    let distance =
        |board: &Motor<f64>| board.transform(Point::default()).distance(Point::default());
    let farthest = state.boards.iter().map(distance).fold(0.0, f64::max);
    if metres <= LEAST_PART * farthest {
        return Err(CalibrationError::Baseline { metres });
    }
    let first = column + TWIST / 2;
    let mut sum = 0.0;
    for (i, x) in translation.iter().enumerate() {
        for (j, y) in translation.iter().enumerate() {
            sum += x * y * covariance.shared(first + i, first + j);
        }
    }
    let deviation = (sum / squared).max(0.0).sqrt();
    match metres > LEAST_DEVIATIONS * deviation {
        true => Ok(deviation),
        false => Err(CalibrationError::Baseline { metres }),
    }
}

fn motors<F: Frame>(boards: &[Pose<Board, F>]) -> Vec<Motor<f64>> {
    boards.iter().map(|board| board.motor).collect()
}

/// Of the motors from the left frame to the right one that single boards give, the one that is
/// nearest to the others: the sum of the distances between corners in space is least.
fn median_motion(
    left: &CameraCalibration,
    right: &CameraCalibration,
    places: &[Point<f64>],
) -> Motor<f64> {
    let [left, right] = [left, right].map(|side| motors(&side.boards));
    let boards = || left.iter().zip(&right);
    let motions: Vec<Motor<f64>> = boards().map(|(l, r)| *r * l.reverse()).collect();
    // The first and the last corner, and one beside the line between them.
    let middle = places.len() / 2;
    let probes = [0, middle, places.len() - 1].map(|index| places[index]);
    let distance = |motion: &Motor<f64>| -> f64 {
        let distances = boards().map(|(left, right)| {
            let apart = |probe: &Point<f64>| {
                let through = motion.transform(left.transform(*probe));
                through.distance(right.transform(*probe))
            };
            probes.iter().map(apart).sum::<f64>()
        });
        distances.sum()
    };
    let distances: Vec<f64> = motions.iter().map(distance).collect();
    let best = (0..motions.len()).min_by(|a, b| distances[*a].total_cmp(&distances[*b]));
    let best = best.map_or_else(Motor::default, |best| motions[best]);
    // Of a motor and its negative, which move alike, the one that rotates by the smaller angle.
    match best.rotor().scalar() < 0.0 {
        true => -best,
        false => best,
    }
}
