//! A rig from pairs of pictures of a board.

use ga_image::plane::Plane;
use ga_image::sample::Sample;
use serde::Serialize;

use super::board_view::BoardView;
use super::board_views::{ENOUGH_BOARDS, MOST_RMS};
use super::error::{CalibrationError, LEAST_FOUND, LEAST_VIEWS};
use super::pair_names::PairNames;
use super::square_edges::{SquareEdges, square_edges};
use super::stereo::{StereoCalibration, StereoOptions, calibrate_stereo};
use crate::board::{Board, or_reason};
use crate::found_board::FoundBoard;

/// The boards of pairs of pictures of one size, in the order in which they are added.
#[derive(Clone, Debug)]
pub struct BoardPairs {
    board: Board,
    size: [usize; 2],
    /// All pairs.
    names: Vec<PairNames>,
    /// The number of each pair in which the board was found, and the boards.
    found: Vec<(usize, [FoundBoard; 2])>,
    rejected: Vec<RejectedPair>,
}

/// A pair that is left out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RejectedPair {
    /// Its names.
    #[serde(flatten)]
    pub names: PairNames,
    /// Why: the pictures in which the board was not found, how few points are in both, or how far
    /// the pair is from the others.
    pub reason: String,
}

/// A rig from pairs of pictures of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct BoardCalibration {
    /// The rig.
    pub stereo: StereoCalibration,
    /// What it says of the edges of the squares.
    pub edges: SquareEdges,
    /// Columns and rows of the pictures.
    pub size: [usize; 2],
    /// All pairs.
    pub pairs: Vec<PairNames>,
    /// Which pairs were used, from 0.
    pub used: Vec<usize>,
    /// The others.
    pub rejected: Vec<RejectedPair>,
}

/// What makes a calibration doubtful.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CalibrationDoubt {
    /// Few pairs were used.
    #[error("{used} pairs were used, and {ENOUGH_BOARDS} are recommended")]
    FewPairs {
        /// How many.
        used: usize,
    },
    /// The rig does not explain the corners well.
    #[error(
        "the corners are {rms:.3} px from their projections (root mean square), more than \
         {MOST_RMS} px"
    )]
    LargeRms {
        /// The root mean square distance in pixels.
        rms: f64,
    },
}

impl BoardPairs {
    /// No pairs yet, of a board.
    #[must_use]
    pub fn new(board: Board) -> Self {
        Self {
            board,
            size: [0; 2],
            names: Vec::new(),
            found: Vec::new(),
            rejected: Vec::new(),
        }
    }

    /// Looks for the board in the next pair of pictures, and returns the boards where both show
    /// enough of the same points, with these in the same order.
    ///
    /// # Errors
    /// [`CalibrationError::PictureSizes`] for pictures of other sizes than the first.
    pub fn add<T: Sample>(
        &mut self,
        pictures: &[Plane<T>; 2],
        names: PairNames,
    ) -> Result<Option<&[FoundBoard; 2]>, CalibrationError> {
        self.check_sizes(pictures, &names)?;
        let pair = self.names.len();
        let mut reasons = Vec::new();
        let mut boards = Vec::new();
        let [left, right] = pictures;
        let found = rayon::join(|| self.board.find(left), || self.board.find(right));
        for (found, name) in [(found.0, &names.left), (found.1, &names.right)] {
            match or_reason(found)? {
                Ok(board) => boards.push(board),
                Err(reason) => reasons.push(format!("{name}: {reason}")),
            }
        }
        self.names.push(names.clone());
        let [left, right] = boards.as_slice() else {
            let reason = reasons.join("; ");
            self.rejected.push(RejectedPair { names, reason });
            return Ok(None);
        };
        let boards = [left.clone(), right.ordered_like(left)];
        let [shared, _] = boards[0].view().shared(boards[1].view());
        if !self.board.places_a_board(&shared) {
            let reason = format!(
                "the views have {} points in common, and {LEAST_FOUND} are needed, with four around \
                 a square or a tag among them",
                shared.points().len()
            );
            self.rejected.push(RejectedPair { names, reason });
            return Ok(None);
        }
        self.found.push((pair, boards));
        Ok(self.found.last().map(|(_, boards)| boards))
    }

    fn check_sizes<T: Copy>(
        &mut self,
        pictures: &[Plane<T>; 2],
        names: &PairNames,
    ) -> Result<(), CalibrationError> {
        let sizes = pictures.each_ref().map(|p| [p.width(), p.height()]);
        if self.names.is_empty() {
            self.size = sizes[0];
        }
        let first = self.names.first().unwrap_or(names);
        let wrong = sizes.iter().zip([&names.left, &names.right]);
        match wrong.into_iter().find(|(size, _)| **size != self.size) {
            Some((&size, name)) => Err(CalibrationError::PictureSizes {
                name: name.clone(),
                size,
                first: first.left.clone(),
                expected: self.size,
            }),
            None => Ok(()),
        }
    }

    /// The rig that sees the boards.
    ///
    /// # Errors
    /// [`CalibrationError::TooFewBoards`] where the board was found in fewer pairs than are needed,
    /// [`CalibrationError::Pair`] with what is wrong in a pair, [`CalibrationError::Edges`] where
    /// the squares cannot be measured, and as [`calibrate_stereo`].
    pub fn calibrate(self, options: &StereoOptions) -> Result<BoardCalibration, CalibrationError> {
        if self.found.len() < LEAST_VIEWS {
            return Err(CalibrationError::TooFewBoards {
                found: self.found.len(),
                pairs: self.names.len(),
                first: self.rejected.first().map(|pair| pair.reason.clone()),
            });
        }
        let corners = [0, 1].map(|side| -> Vec<BoardView> {
            let boards = self.found.iter().map(|(_, boards)| &boards[side]);
            boards.map(|board| board.view().clone()).collect()
        });
        let places = self.board.places();
        let views = corners.each_ref().map(Vec::as_slice);
        let stereo = calibrate_stereo(views, &places, self.size, options);
        let stereo = stereo.map_err(|error| match error.view() {
            Some(view) => CalibrationError::Pair {
                names: self.names[self.found[view].0].clone(),
                error: Box::new(error),
            },
            None => error,
        })?;
        let used = views.map(|views| -> Vec<BoardView> {
            stereo.used.iter().map(|&k| views[k].clone()).collect()
        });
        let used = used.each_ref().map(Vec::as_slice);
        let edges = square_edges(&stereo.rig, used, &self.board);
        let edges = edges.map_err(|error| CalibrationError::Edges(Box::new(error)))?;
        let mut rejected = self.rejected;
        rejected.extend(stereo.outliers.iter().map(|outlier| RejectedPair {
            names: self.names[self.found[outlier.pair].0].clone(),
            reason: outlier.to_string(),
        }));
        Ok(BoardCalibration {
            used: stereo.used.iter().map(|&k| self.found[k].0).collect(),
            size: self.size,
            pairs: self.names,
            rejected,
            edges,
            stereo,
        })
    }
}

impl CalibrationDoubt {
    /// One word for programs.
    #[must_use]
    pub fn kind(self) -> &'static str {
        match self {
            Self::FewPairs { .. } => "few_pairs",
            Self::LargeRms { .. } => "large_rms",
        }
    }
}

impl BoardCalibration {
    /// What makes the result doubtful.
    #[must_use]
    pub fn doubts(&self) -> Vec<CalibrationDoubt> {
        let (used, rms) = (self.used.len(), self.stereo.rms);
        let few = (used < ENOUGH_BOARDS).then_some(CalibrationDoubt::FewPairs { used });
        let large = (rms > MOST_RMS).then_some(CalibrationDoubt::LargeRms { rms });
        few.into_iter().chain(large).collect()
    }
}
