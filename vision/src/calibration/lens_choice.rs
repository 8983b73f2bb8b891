//! Which lens a camera has, by what remains of boards.

use ga_camera::{Intrinsics, LensModel};
use ga_runtime::cga3::Point;
use serde::Serialize;

use super::board_view::BoardView;
use super::error::CalibrationError;
use super::lens_terms::LensTerms;
use super::one_camera::{CameraCalibration, CameraOptions, Start, calibrate_camera};

/// A lens that was tried.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TriedLens {
    /// Its terms, as options name them.
    pub lens: String,
    /// What remains, in pixels; `None` where the boards do not determine such a camera.
    pub rms_px: Option<f64>,
    /// Schwarz's criterion, which is less for a lens that is more likely:
    /// `n ln(sum of squares / n) + k ln n` for n coordinates of corners and k parameters.
    pub schwarz: Option<f64>,
}

/// A camera with the lens that was given or chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct LensFit {
    /// The lens, and which of its terms were determined.
    pub terms: LensTerms,
    /// The camera.
    pub camera: CameraCalibration,
    /// All lenses that were tried.
    pub tried: Vec<TriedLens>,
    /// A lens that fits decisively better.
    pub better: Option<TriedLens>,
}

/// By how much Schwarz's criterion must be less to be very strong evidence (Kass and Raftery,
/// 1995).
const DECISIVE: f64 = 10.0;

/// A lens of another kind must also leave less than this part of the distances: a fisheye has no
/// tangential terms, and so is a little more likely for many an ordinary lens.
const DECISIVE_PART: f64 = 0.9;

/// Calibrates a camera with a lens that is given, or with the likelier one of a radial–tangential
/// lens and a fisheye: a fisheye is chosen where Schwarz's criterion is very strong evidence for it
/// and it leaves less than nine tenths of the distances. Arguments are those of
/// [`calibrate_camera`].
///
/// # Errors
///
/// As [`calibrate_camera`].
pub fn calibrate_lens(
    views: &[BoardView],
    places: &[Point<f64>],
    size: [usize; 2],
    given: Option<LensTerms>,
) -> Result<LensFit, CalibrationError> {
    let usual = LensTerms::radial_tangential();
    let first = given.unwrap_or(usual);
    let mut kinds = vec![first];
    let others = [usual, LensTerms::fisheye(), LensTerms::rational()];
    kinds.extend(others.into_iter().filter(|terms| *terms != first));
    let mut found = kinds
        .into_iter()
        .map(|terms| Fit::new(views, places, size, terms));
    let first = found
        .next()
        .unwrap_or_else(|| Fit::new(views, places, size, usual));
    let others: Vec<Fit> = found.collect();
    let mut tried = vec![first.tried()];
    tried.extend(others.iter().map(Fit::tried));
    let best = others
        .iter()
        .filter(|other| other.is_decisively_better_than(&first))
        .min_by(|a, b| a.schwarz().total_cmp(&b.schwarz()));
    let chosen = match (given, best) {
        // More terms are not chosen unasked: they are wild where there are no corners.
        (None, Some(other)) if other.terms.model() != first.terms.model() => other,
        _ => &first,
    };
    let better = best
        .filter(|best| best.terms != chosen.terms)
        .map(Fit::tried);
    let camera = chosen.camera.clone().map_err(|error| match &better {
        Some(TriedLens {
            lens,
            rms_px: Some(rms),
            ..
        }) => CalibrationError::OtherLens {
            error: Box::new(error),
            lens: lens.clone(),
            rms: *rms,
        },
        _ => error,
    })?;
    Ok(LensFit {
        terms: chosen.terms,
        camera,
        tried,
        better,
    })
}

/// A camera with one lens.
struct Fit {
    terms: LensTerms,
    camera: Result<CameraCalibration, CalibrationError>,
    /// The number of coordinates of corners, and that of parameters.
    counts: [f64; 2],
}

impl Fit {
    fn new(views: &[BoardView], places: &[Point<f64>], size: [usize; 2], terms: LensTerms) -> Self {
        let parameters = terms.free().len() + 6 * views.len();
        let points = views.iter().map(|view| view.points().len());
        Self {
            terms,
            camera: calibrate(views, places, size, terms),
            counts: [2 * points.sum::<usize>(), parameters].map(|count| count as f64),
        }
    }

    fn schwarz(&self) -> f64 {
        let [coordinates, parameters] = self.counts;
        match &self.camera {
            // Half of the mean square distance is the mean square of a coordinate.
            Ok(camera) => {
                let square = (0.5 * camera.rms * camera.rms).max(f64::MIN_POSITIVE);
                coordinates * square.ln() + parameters * coordinates.ln()
            }
            Err(_) => f64::INFINITY,
        }
    }

    fn tried(&self) -> TriedLens {
        let camera = self.camera.as_ref().ok();
        TriedLens {
            lens: self.terms.to_string(),
            rms_px: camera.map(|camera| camera.rms),
            schwarz: camera.map(|_| self.schwarz()),
        }
    }

    fn is_decisively_better_than(&self, other: &Self) -> bool {
        let Ok(camera) = &self.camera else {
            return false;
        };
        let Ok(against) = &other.camera else {
            return true;
        };
        // Below this, in pixels, corners are as good as exact.
        const NEGLIGIBLE: f64 = 1e-3;
        against.rms > NEGLIGIBLE
            && self.schwarz() + DECISIVE < other.schwarz()
            && camera.rms < DECISIVE_PART * against.rms
    }
}

/// The camera with a lens. That of a fisheye is searched from several focal lengths: the
/// homographies of its boards are those of no plane.
fn calibrate(
    views: &[BoardView],
    places: &[Point<f64>],
    size: [usize; 2],
    terms: LensTerms,
) -> Result<CameraCalibration, CalibrationError> {
    let side = size[0].max(size[1]) as f64;
    let principal = size.map(|side| 0.5 * (side as f64 - 1.0));
    let mut starts = vec![Start::Boards];
    if terms.model() == LensModel::Fisheye {
        // The longer side sees this angle.
        for angle in [120.0_f64, 180.0, 90.0, 60.0] {
            let focal = [side / angle.to_radians(); 2];
            starts.push(Start::Guess(Intrinsics::new(focal, principal)?));
        }
    }
    let mut best: Option<Result<CameraCalibration, CalibrationError>> = None;
    for start in starts {
        let found = calibrate_camera(views, places, size, &CameraOptions { start, terms });
        let is_better = match (&found, &best) {
            (_, None) | (Ok(_), Some(Err(_))) => true,
            (Ok(new), Some(Ok(old))) => new.rms < old.rms,
            (Err(_), Some(_)) => false,
        };
        if is_better {
            best = Some(found);
        }
    }
    best.unwrap_or(Err(CalibrationError::TooFewViews { found: views.len() }))
}
