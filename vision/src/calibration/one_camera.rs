//! The calibration of one camera.

use super::error::{LEAST_POINTS, LEAST_VIEWS};
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;

use super::board_view::{BoardView, SeenPoint};
use super::bundle::{Bundle, BundleState};
use super::lens_terms::{LensTerms, parameter_name};
use crate::calibration::CalibrationError;
use crate::homography::{Homography, in_plane};
use crate::perspective_n_point;
use ga_camera::frame::{Board, CameraFrame, Pose};
use ga_camera::{CameraError, Intrinsics};
use ga_numerics::least_squares::{
    Covariance, Loss, Minimum, Options, Region, minimise, region_factor,
};

/// Where the intrinsic parameters of a camera come from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Start {
    /// The homographies of the boards.
    #[default]
    Boards,
    /// A guess, which the calibration improves. A lens of another kind than the terms ask for is
    /// replaced.
    Guess(Intrinsics),
    /// Numbers that are known: only the motors of the boards are determined.
    Fixed(Intrinsics),
}

/// How a camera is calibrated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraOptions {
    /// Where the intrinsic parameters come from.
    pub start: Start,
    /// The kind of the lens, and which of its coefficients vary.
    pub terms: LensTerms,
}

/// A camera and the boards that it sees.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraCalibration {
    /// The camera.
    pub intrinsics: Intrinsics,
    /// The standard deviations of the intrinsic parameters, in the order of
    /// [`Intrinsics::parameters`], 0 for those that did not vary: 1.96 of them to either side hold
    /// 95 % of all errors of a parameter, for independent errors of the corners of the size that
    /// the remaining distances show.
    pub deviations: [f64; Intrinsics::MAX_PARAMETERS],
    /// For each view the motor that takes the board into the camera's frame.
    pub boards: Vec<Pose<Board, CameraFrame>>,
    /// The root mean square distance of all corners from the projections of their places, in
    /// pixels, as OpenCV's `calibrateCamera` returns it.
    pub rms: f64,
    /// The same for each view.
    pub view_rms: Vec<f64>,
    /// The views whose board is seen as well, within noise, in another pose, as small or distant
    /// boards are: their motors may be those of the other.
    pub ambiguous: Vec<usize>,
}

impl CameraOptions {
    /// The camera at which the search begins, and its parameters that vary.
    fn start(
        &self,
        views: &[BoardView],
        places: &[Point<f64>],
        size: [usize; 2],
    ) -> Result<(Intrinsics, Vec<usize>), CalibrationError> {
        let lens = self.terms.lens()?;
        Ok(match self.start {
            Start::Fixed(intrinsics) => (intrinsics, Vec::new()),
            Start::Guess(intrinsics) => {
                let kinds = [lens, intrinsics.lens()].map(|lens| std::mem::discriminant(&lens));
                let intrinsics = match kinds[0] == kinds[1] {
                    true => intrinsics,
                    false => intrinsics.with_lens(lens),
                };
                (intrinsics, self.terms.free())
            }
            Start::Boards => {
                let pinhole = initial_pinhole(views, places, size)?;
                (pinhole.with_lens(lens), self.terms.free())
            }
        })
    }

    /// The parameters that vary in a joint calibration.
    pub(super) fn free(&self) -> Vec<usize> {
        match self.start {
            Start::Fixed(_) => Vec::new(),
            _ => self.terms.free(),
        }
    }
}

/// Calibrates a camera from the points of boards.
///
/// `views` has the points that are seen of each board, all or some, `places` the places of all
/// points on it, in the plane z = 0, and `size` the width and height of the pictures.
///
/// # Errors
///
/// [`CalibrationError`].
pub fn calibrate_camera(
    views: &[BoardView],
    places: &[Point<f64>],
    size: [usize; 2],
    options: &CameraOptions,
) -> Result<CameraCalibration, CalibrationError> {
    check(views, places)?;
    let (intrinsics, free) = options.start(views, places, size)?;
    let boards = initial_boards(views, places, &intrinsics)?;
    let bundle = Bundle {
        places,
        views: vec![views.iter().collect()],
        free: vec![free],
    };
    let mut state = BundleState {
        cameras: vec![intrinsics],
        motions: Vec::new(),
        boards,
    };
    // While the distortion is not known, far corners would drag the motors away.
    let rough = Options {
        loss: Loss::Huber(2.0),
        relative_tolerance: 1e-3,
        ..Options::default()
    };
    if let Ok(found) = minimise(&bundle, state.clone(), &rough) {
        state = found.state;
    }
    let ambiguous = choose_boards(views, places, &mut state);
    let minimum = minimise(&bundle, state, &Options::default())?;
    let covariance = covariance(&bundle, &minimum)?;
    let deviations = deviations(&bundle, &minimum.state, 0, &covariance)?;
    let errors = bundle.squared_errors(&minimum.state);
    let view_rms = errors[0].iter().zip(bundle.counts(0));
    let view_rms = view_rms.map(|(sum, count)| (sum / count as f64).sqrt());
    let count = bundle.counts(0).sum::<usize>() as f64;
    Ok(CameraCalibration {
        intrinsics: minimum.state.cameras[0],
        deviations,
        rms: (minimum.cost / count).sqrt(),
        view_rms: view_rms.collect(),
        ambiguous,
        boards: minimum.state.boards.into_iter().map(Pose::new).collect(),
    })
}

/// The covariance of the unknowns with the variance that the residuals show, such that 95 % of all
/// errors of a parameter of a camera are within 1.96 of its standard deviations.
pub(super) fn covariance(
    bundle: &Bundle<'_>,
    minimum: &Minimum<BundleState>,
) -> Result<Covariance, CalibrationError> {
    let redundancy = minimum.residuals.saturating_sub(minimum.unknowns) as f64;
    let factor = region_factor(1, redundancy).unwrap_or(1.0);
    let variance = factor * minimum.variance().unwrap_or(0.0);
    let covariance = minimum.curved_covariance(bundle, variance, Region::Intervals);
    covariance.ok_or_else(|| {
        let column = minimum.undetermined().unwrap_or_default();
        let parameter = bundle.unknown_name(&minimum.state, column);
        CalibrationError::Undetermined { parameter }
    })
}

/// The standard deviations of a camera's parameters.
pub(super) fn deviations(
    bundle: &Bundle<'_>,
    state: &BundleState,
    camera: usize,
    covariance: &Covariance,
) -> Result<[f64; Intrinsics::MAX_PARAMETERS], CalibrationError> {
    /// A focal length that is less certain is not determined.
    const GREATEST_PART: f64 = 0.5;
    let mut deviations = [0.0; Intrinsics::MAX_PARAMETERS];
    let own = &state.cameras[camera];
    for (k, &parameter) in bundle.free[camera].iter().enumerate() {
        let deviation = covariance.standard_deviation(bundle.first_column(camera) + k);
        if parameter < 2
            && (deviation.is_nan() || deviation >= GREATEST_PART * own.focal()[parameter])
        {
            let parameter = parameter_name(own, parameter);
            return Err(CalibrationError::Undetermined { parameter });
        }
        deviations[parameter] = deviation;
    }
    Ok(deviations)
}

/// A pinhole with the principal point in the middle of the picture, and with the focal lengths that
/// make the images of the axes of all boards as nearly as possible perpendicular and of equal
/// length. Where the boards do not show that, they are the longer side of the picture.
fn initial_pinhole(
    views: &[BoardView],
    places: &[Point<f64>],
    size: [usize; 2],
) -> Result<Intrinsics, CameraError> {
    let principal = size.map(|side| 0.5 * (side as f64 - 1.0));
    let unit = size[0].max(size[1]) as f64;
    let homographies = views.iter().filter_map(|view| {
        let shifted = |[u, v]: [f64; 2]| [(u - principal[0]) / unit, (v - principal[1]) / unit];
        let pixels: Vec<[f64; 2]> = view.pixels().into_iter().map(shifted).collect();
        Homography::from_pairs(&in_plane(&view.places(places)?), &pixels)
    });
    // Rows a·X + b·Y = c for X = 1/f_x² and Y = 1/f_y², in units of the picture.
    let mut rows: Vec<[f64; 3]> = Vec::new();
    for homography in homographies {
        let [first, second] = [0, 1].map(|column| homography.column(column));
        let scale = 1.0 / (first.length() * second.length()).sqrt();
        let [a, b] = [first * scale, second * scale];
        let product = |a: Vector<f64>, b: Vector<f64>| [a.e1 * b.e1, a.e2 * b.e2, -(a.e3 * b.e3)];
        let [squares, others] = [product(a, a), product(b, b)];
        rows.push(product(a, b));
        rows.push([0, 1, 2].map(|k| squares[k] - others[k]));
    }
    let sum = |a: usize, b: usize| rows.iter().map(|row| row[a] * row[b]).sum::<f64>();
    let determinant = sum(0, 0) * sum(1, 1) - sum(0, 1).powi(2);
    let both = [
        (sum(0, 2) * sum(1, 1) - sum(1, 2) * sum(0, 1)) / determinant,
        (sum(1, 2) * sum(0, 0) - sum(0, 2) * sum(0, 1)) / determinant,
    ];
    let total = |k: usize| {
        rows.iter()
            .map(|row| (row[0] + row[1]) * row[k])
            .sum::<f64>()
    };
    let one = total(2) / (total(0) + total(1));
    // From an angle of view of 170° to one of 3°.
    let is_possible = |squares: &[f64; 2]| squares.iter().all(|x| (0.0025..400.0).contains(x));
    let candidates = [both, [one; 2]];
    let squares = candidates.into_iter().find(is_possible).unwrap_or([1.0; 2]);
    Intrinsics::new(squares.map(|square| unit / square.sqrt()), principal)
}

/// The motor of each board, from its homography to directions.
fn initial_boards(
    views: &[BoardView],
    places: &[Point<f64>],
    intrinsics: &Intrinsics,
) -> Result<Vec<Motor<f64>>, CalibrationError> {
    let ([fx, fy], [cx, cy]) = (intrinsics.focal(), intrinsics.principal());
    let motor = |(view, board): (usize, &BoardView)| {
        let at_focal_length_1 = |seen: &SeenPoint| {
            let undistorted = intrinsics.undistort(seen.pixel);
            let [u, v] = undistorted.map_err(|error| CalibrationError::Pixel {
                view,
                point: seen.point,
                error,
            })?;
            Ok([(u - cx) / fx, (v - cy) / fy])
        };
        let places = board.places(places);
        let flat = in_plane(&places.ok_or(CalibrationError::View { view })?);
        let images = board.points().iter().map(at_focal_length_1);
        let images = images.collect::<Result<Vec<[f64; 2]>, CalibrationError>>()?;
        let motion = Homography::from_pairs(&flat, &images).and_then(|found| found.motion());
        motion.ok_or(CalibrationError::View { view })
    };
    views.iter().enumerate().map(motor).collect()
}

/// Takes for each board the better of the two poses in which a plane is seen almost alike, and
/// returns the views in which both explain the corners.
fn choose_boards(
    views: &[BoardView],
    places: &[Point<f64>],
    state: &mut BundleState,
) -> Vec<usize> {
    let camera = state.cameras[0];
    let mut ambiguous = Vec::new();
    for (view, (seen, board)) in views.iter().zip(&mut state.boards).enumerate() {
        let options = perspective_n_point::Options::default();
        let Some(places) = seen.places(places) else {
            continue;
        };
        // Where no pose is found, the search goes on from that of the homography.
        let found = perspective_n_point::estimate(&places, &seen.pixels(), &camera, &options);
        if let Ok(found) = found {
            *board = found.world_to_camera;
            if found.is_ambiguous() {
                ambiguous.push(view);
            }
        }
    }
    ambiguous
}

/// Checks the points of views of a board.
fn check(views: &[BoardView], places: &[Point<f64>]) -> Result<(), CalibrationError> {
    if views.len() < LEAST_VIEWS {
        return Err(CalibrationError::TooFewViews { found: views.len() });
    }
    for (view, seen) in views.iter().enumerate() {
        let found = seen.points().len();
        if found < LEAST_POINTS {
            return Err(CalibrationError::TooFewPoints { view, found });
        }
        for &SeenPoint { point, pixel } in seen.points() {
            let count = places.len();
            let place = places.get(point);
            let place = place.ok_or(CalibrationError::NoSuchPoint { view, point, count })?;
            let mut numbers = place.coordinates().into_iter().chain(pixel);
            if numbers.any(|x| !x.is_finite()) {
                return Err(CalibrationError::NotFinite { view, point });
            }
        }
    }
    Ok(())
}
