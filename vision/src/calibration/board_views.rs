//! One camera from pictures of a board.

use ga_camera::Intrinsics;
use ga_image::plane::Plane;
use ga_image::pyramid::halved;
use ga_image::sample::Sample;
use serde::Serialize;

use super::board_view::BoardView;
use super::error::{CalibrationError, LEAST_VIEWS};
use super::lens_choice::{TriedLens, calibrate_lens};
use super::lens_terms::{LensTerms, parameter_name};
use super::one_camera::CameraCalibration;
use crate::board::{Board, or_reason};
use crate::found_board::FoundBoard;

/// The boards of pictures of one camera, in the order in which they are added.
#[derive(Clone, Debug)]
pub struct BoardViews {
    board: Board,
    /// The names and sizes of all pictures.
    pictures: Vec<(String, [usize; 2])>,
    /// The number of each picture in which the board was found, and the board.
    found: Vec<(usize, FoundBoard)>,
    rejected: Vec<RejectedView>,
    /// A small picture with a board.
    shown: Option<Plane<u8>>,
}

/// A picture that is left out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RejectedView {
    /// Its name.
    pub picture: String,
    /// Why.
    pub reason: String,
}

/// What remains of a board.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ViewResidual {
    /// The name of the picture.
    pub picture: String,
    /// How many of its corners are seen.
    pub points: usize,
    /// The root mean square distance of its corners from their projections.
    pub rms_px: f64,
}

/// A corner and how far its projection is from it, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerResidual {
    /// Where it was found.
    pub corner: [f64; 2],
    /// From there to its projection.
    pub difference: [f64; 2],
}

/// A number of a camera with its standard deviation, 0 for one that did not vary.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// Its name in OpenCV.
    pub name: &'static str,
    /// Its value, in pixels or without a unit.
    pub value: f64,
    /// Its standard deviation.
    pub deviation: f64,
}

/// One camera from pictures of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraOfBoards {
    /// The camera.
    pub camera: CameraCalibration,
    /// The lens, and which of its terms were determined.
    pub terms: LensTerms,
    /// The lenses that were tried.
    pub tried: Vec<TriedLens>,
    /// A lens that would fit decisively better.
    pub better: Option<TriedLens>,
    /// Columns and rows of the pictures.
    pub size: [usize; 2],
    /// What remains of each board that was used, the worst first.
    pub views: Vec<ViewResidual>,
    /// The other pictures.
    pub rejected: Vec<RejectedView>,
    /// All corners of the boards that were used.
    pub corners: Vec<CornerResidual>,
    /// One of the pictures, small.
    pub picture: Option<Plane<u8>>,
}

/// What makes the calibration of one camera doubtful.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CameraDoubt {
    /// Few boards were used.
    #[error("{used} boards were used, and {ENOUGH_BOARDS} are recommended")]
    FewBoards {
        /// How many.
        used: usize,
    },
    /// The camera does not explain the corners well.
    #[error(
        "the corners are {rms:.3} px from their projections (root mean square), more than \
         {MOST_RMS} px"
    )]
    LargeRms {
        /// The root mean square distance in pixels.
        rms: f64,
    },
    /// A lens of another kind, or with more terms, fits much better.
    #[error("the lens seems to be another: {lens} leaves {other:.3} px, not {rms:.3} px")]
    OtherLens {
        /// The other lens.
        lens: String,
        /// What it leaves.
        other: f64,
        /// What remains.
        rms: f64,
    },
    /// A camera of a rig is where the first one is.
    #[error(
        "it cannot be told from the first camera by its place, {metres:.3e} m from it: are these \
         the views of two cameras?"
    )]
    SamePlace {
        /// The distance from the first camera in metres.
        metres: f64,
    },
    /// Parts of the picture have no corners.
    #[error(
        "corners are in {percent:.0} % of the parts of the picture; show the board at its borders too"
    )]
    SmallCoverage {
        /// In how many of the parts.
        percent: f64,
    },
    /// A board is much worse than the others.
    #[error("the corners of {picture} are {rms:.3} px off, those of the boards {median:.3} px")]
    OutlyingBoard {
        /// The picture.
        picture: String,
        /// Its root mean square distance.
        rms: f64,
        /// The median of all.
        median: f64,
    },
}

/// OpenCV's guide to calibration asks for at least this number of views of the board.
pub(super) const ENOUGH_BOARDS: usize = 10;
/// Calibrations of usual cameras are below this, in pixels: boards that are not flat, lenses with
/// other distortion and wrong corners are above it.
pub(super) const MOST_RMS: f64 = 1.0;
/// The parts of the picture in which corners are counted: columns and rows.
pub(super) const PARTS: [usize; 2] = [8, 6];
/// In less than this, in percent, the lens is a guess at the borders.
const LEAST_COVERAGE: f64 = 50.0;
/// A board with so many times the median distance does not agree with the others.
const OUTLYING: f64 = 3.0;

impl BoardViews {
    /// No pictures yet, of a board.
    #[must_use]
    pub fn new(board: Board) -> Self {
        Self {
            board,
            pictures: Vec::new(),
            found: Vec::new(),
            rejected: Vec::new(),
            shown: None,
        }
    }

    /// Looks for the board in the next picture.
    ///
    /// # Errors
    /// Those of [`Board::find_part`] other than that there is no board.
    pub fn add<T: Sample>(
        &mut self,
        picture: &Plane<T>,
        name: String,
    ) -> Result<(), CalibrationError> {
        let size = [picture.width(), picture.height()];
        let index = self.pictures.len();
        self.pictures.push((name.clone(), size));
        if self.pictures[0].1 != size {
            // The pictures will be refused, with all names and sizes.
            return Ok(());
        }
        match or_reason(self.board.find_part(picture))? {
            Ok(board) => {
                self.shown.get_or_insert_with(|| small(picture));
                self.found.push((index, board));
            }
            Err(reason) => self.rejected.push(RejectedView {
                picture: name,
                reason,
            }),
        }
        Ok(())
    }

    /// The camera that sees the boards, with a lens that is given, or the likelier one of a
    /// radial–tangential lens and a fisheye.
    ///
    /// # Errors
    /// [`CalibrationError::MixedSizes`] for pictures of several sizes,
    /// [`CalibrationError::TooFewPictures`] where the board was found in fewer than are needed,
    /// [`CalibrationError::Picture`] with what is wrong in one, and as
    /// [`calibrate_camera`](super::calibrate_camera).
    pub fn calibrate(self, lens: Option<LensTerms>) -> Result<CameraOfBoards, CalibrationError> {
        self.check_sizes()?;
        if self.found.len() < LEAST_VIEWS {
            return Err(CalibrationError::TooFewPictures {
                found: self.found.len(),
                pictures: self.pictures.len(),
                first: self
                    .rejected
                    .first()
                    .map(|view| format!("{}: {}", view.picture, view.reason)),
            });
        }
        let size = self.pictures[0].1;
        let places = self.board.places();
        let seen = self.found.iter();
        let seen: Vec<BoardView> = seen.map(|(_, board)| board.view().clone()).collect();
        let name = |view: usize| self.pictures[self.found[view].0].0.clone();
        let fitted = calibrate_lens(&seen, &places, size, lens);
        let fitted = fitted.map_err(|error| match error.view() {
            Some(view) => CalibrationError::Picture {
                name: name(view),
                error: Box::new(error),
            },
            None => error,
        })?;
        let camera = fitted.camera;
        let mut views: Vec<ViewResidual> = (camera.view_rms.iter().enumerate())
            .map(|(view, rms)| ViewResidual {
                picture: name(view),
                points: seen[view].points().len(),
                rms_px: *rms,
            })
            .collect();
        views.sort_by(|a, b| b.rms_px.total_cmp(&a.rms_px));
        let boards = seen.iter().zip(&camera.boards);
        let residuals = boards.flat_map(|(seen, board)| {
            seen.points().iter().filter_map(|seen| {
                let place = board.motor.transform(places[seen.point]);
                let projected = camera.intrinsics.project(place).ok()?;
                Some(CornerResidual {
                    corner: seen.pixel,
                    difference: [0, 1].map(|k| projected[k] - seen.pixel[k]),
                })
            })
        });
        Ok(CameraOfBoards {
            corners: residuals.collect(),
            terms: fitted.terms,
            tried: fitted.tried,
            better: fitted.better,
            size,
            views,
            rejected: self.rejected,
            picture: self.shown,
            camera,
        })
    }

    fn check_sizes(&self) -> Result<(), CalibrationError> {
        let mut groups: Vec<([usize; 2], Vec<String>)> = Vec::new();
        for (name, size) in &self.pictures {
            match groups.iter_mut().find(|(other, _)| other == size) {
                Some((_, names)) => names.push(name.clone()),
                None => groups.push((*size, vec![name.clone()])),
            }
        }
        match groups.len() {
            0 | 1 => Ok(()),
            _ => Err(CalibrationError::MixedSizes { groups }),
        }
    }
}

/// A picture of at most 800 columns.
fn small<T: Sample>(picture: &Plane<T>) -> Plane<u8> {
    let mut small = picture.map(|value| u8::from_unit(value.to_unit()));
    while small.width() > 800 {
        small = halved(&small);
    }
    small
}

impl CameraDoubt {
    /// What is doubtful of a camera by how many boards were used, and their root mean square
    /// distance in pixels.
    pub(super) fn of_boards(used: usize, rms: f64) -> impl Iterator<Item = Self> {
        let few = (used < ENOUGH_BOARDS).then_some(Self::FewBoards { used });
        let large = (rms > MOST_RMS).then_some(Self::LargeRms { rms });
        few.into_iter().chain(large)
    }

    /// One word for programs.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::FewBoards { .. } => "few_boards",
            Self::LargeRms { .. } => "large_rms",
            Self::OtherLens { .. } => "other_lens",
            Self::SamePlace { .. } => "same_place",
            Self::SmallCoverage { .. } => "small_coverage",
            Self::OutlyingBoard { .. } => "outlying_board",
        }
    }
}

impl CameraOfBoards {
    /// How many corners are in each of 8 × 6 parts of the picture, by rows.
    #[must_use]
    pub fn coverage(&self) -> Vec<usize> {
        let mut counts = vec![0; PARTS[0] * PARTS[1]];
        for CornerResidual { corner, .. } in &self.corners {
            let [column, row] = [0, 1].map(|k| {
                let part = (corner[k] + 0.5) / self.size[k] as f64 * PARTS[k] as f64;
                (part.max(0.0) as usize).min(PARTS[k] - 1)
            });
            counts[row * PARTS[0] + column] += 1;
        }
        counts
    }

    /// In how many of these parts corners are, in percent.
    #[must_use]
    pub fn coverage_percent(&self) -> f64 {
        let counts = self.coverage();
        let seen = counts.iter().filter(|count| **count > 0).count();
        100.0 * seen as f64 / counts.len() as f64
    }

    /// Focal lengths, principal point and the coefficients that were determined.
    #[must_use]
    pub fn parameters(&self) -> Vec<Parameter> {
        let intrinsics: &Intrinsics = &self.camera.intrinsics;
        let values = intrinsics.parameters();
        let free = self.terms.free().into_iter();
        let parameters = free.map(|k| Parameter {
            name: parameter_name(intrinsics, k),
            value: values[k],
            deviation: self.camera.deviations[k],
        });
        parameters.collect()
    }

    /// What makes the result doubtful.
    #[must_use]
    pub fn doubts(&self) -> Vec<CameraDoubt> {
        let (used, rms, percent) = (self.views.len(), self.camera.rms, self.coverage_percent());
        let other = self.better.as_ref().map(|better| CameraDoubt::OtherLens {
            lens: better.lens.clone(),
            other: better.rms_px.unwrap_or(0.0),
            rms,
        });
        let small = percent < LEAST_COVERAGE;
        let small = small.then_some(CameraDoubt::SmallCoverage { percent });
        let median = self.views.get(used / 2).map_or(0.0, |view| view.rms_px);
        let outlying = self
            .views
            .iter()
            .filter(|view| view.rms_px > OUTLYING * median.max(0.1));
        let outlying = outlying.map(|view| CameraDoubt::OutlyingBoard {
            picture: view.picture.clone(),
            rms: view.rms_px,
            median,
        });
        let all = CameraDoubt::of_boards(used, rms).chain(other).chain(small);
        all.chain(outlying).collect()
    }
}
