//! Boards for calibration: what is printed on them, how large it is, and where it is in a picture.

use ga_image::plane::Plane;
use ga_image::sample::Sample;
use ga_runtime::cga3::Point;

use crate::calibration::{BoardView, CalibrationError, LEAST_FOUND, SeenPoint};
use crate::chessboard::{self, BoardSize};
use crate::circle_grid::{self, Arrangement};
use crate::found_board::FoundBoard;
use crate::tag::{AprilGrid, CharucoBoard};

/// What is printed on a board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pattern {
    /// Squares, bright and dark in turn; the points are their inner corners.
    #[default]
    Chessboard,
    /// Discs in columns and rows, all dark or all bright; the points are their centres.
    Circles,
    /// Discs of which every other row is moved by half the distance of two neighbours in it.
    AsymmetricCircles,
}

/// A flat board with points in columns and rows, at known places.
///
/// A board with tags, [`CharucoBoard`] or [`AprilGrid`], becomes one by `Board::from`. A picture
/// may show a part of it.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_vision::board::{Board, Pattern};
///
/// let board = Board::new(Pattern::AsymmetricCircles, "4x11".parse()?, 0.02)?;
/// let places = board.places();
/// assert_eq!(places.len(), 44);
/// assert_eq!(places[1], Point::new(0.04, 0.0, 0.0));
/// assert_eq!(places[4], Point::new(0.02, 0.02, 0.0));
/// # Ok::<(), ga_vision::calibration::CalibrationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Board(Kind);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Plain(Pattern, BoardSize, f64),
    Charuco(CharucoBoard),
    AprilGrid(AprilGrid),
}

impl Board {
    /// A board by the numbers of its points in a row and of rows, and a length in metres: the side
    /// of a square, the distance of neighbouring centres of circles, or, where every other row is
    /// moved, the distance of neighbouring rows, which is half that of neighbours in a row.
    ///
    /// # Errors
    /// [`CalibrationError::Spacing`] where the length is not positive and finite.
    pub fn new(pattern: Pattern, size: BoardSize, spacing: f64) -> Result<Self, CalibrationError> {
        match spacing > 0.0 && spacing.is_finite() {
            true => Ok(Self(Kind::Plain(pattern, size, spacing))),
            false => Err(CalibrationError::Spacing { metres: spacing }),
        }
    }

    /// The length in metres by which it was made; of tags without squares, the side of a tag.
    #[must_use]
    pub fn spacing(&self) -> f64 {
        match self.0 {
            Kind::Plain(_, _, spacing) => spacing,
            Kind::Charuco(board) => board.square(),
            Kind::AprilGrid(grid) => grid.side(),
        }
    }

    /// Where its points are in metres: in the plane z = 0, from the origin along x, then along y.
    /// With every other row moved, point j of row i is at `((2 j + i mod 2) s, i s)`, as OpenCV has
    /// it. Boards with tags have their own places: [`CharucoBoard::points`],
    /// [`AprilGrid::points`].
    #[must_use]
    pub fn places(&self) -> Vec<Point<f64>> {
        match self.0 {
            Kind::Plain(Pattern::AsymmetricCircles, size, spacing) => {
                let place = |index: usize| {
                    let (column, row) = (index % size.columns(), index / size.columns());
                    let x = (2 * column + row % 2) as f64 * spacing;
                    Point::new(x, row as f64 * spacing, 0.0)
                };
                (0..size.count()).map(place).collect()
            }
            Kind::Plain(_, size, spacing) => size.places(spacing),
            Kind::Charuco(board) => board.points(),
            Kind::AprilGrid(grid) => grid.points(),
        }
    }

    /// Pairs of neighbouring points: those that follow each other in a row, or in a column, and
    /// where tags stand alone are corners of one tag.
    #[must_use]
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let (columns, count) = (self.columns(), self.places().len());
        // With every other row moved, the row after the next is the one above.
        let stride = match self.0 {
            Kind::Plain(Pattern::AsymmetricCircles, ..) => 2 * columns,
            _ => columns,
        };
        let along = (1..count).filter(|index| index % columns > 0);
        let along = along.map(|index| [index - 1, index]);
        let down = (stride..count).map(|index| [index - stride, index]);
        // The first point of an edge of a tag is in an even column, or row.
        let has_gaps = matches!(self.0, Kind::AprilGrid(_));
        let is_edge = |place: usize| !has_gaps || place.is_multiple_of(2);
        let along = along.filter(|[first, _]| is_edge(first % columns));
        let down = down.filter(|[first, _]| is_edge(first / columns));
        along.chain(down).collect()
    }

    /// Where its points are in a grey picture.
    ///
    /// # Errors
    /// As [`chessboard::find`] and [`circle_grid::find`]; [`CalibrationError::TagsNotFound`] where
    /// tags show too few points, and [`CalibrationError::Blur`] where the picture cannot be
    /// filtered.
    pub fn find<T: Sample>(&self, picture: &Plane<T>) -> Result<FoundBoard, CalibrationError> {
        let (size, arrangement) = match self.0 {
            Kind::Plain(Pattern::Chessboard, size, _) => return chessboard::find(picture, size),
            Kind::Plain(Pattern::Circles, size, _) => (size, Arrangement::Symmetric),
            Kind::Plain(Pattern::AsymmetricCircles, size, _) => (size, Arrangement::Asymmetric),
            Kind::Charuco(board) => return self.of_tags(board.find(picture)?),
            Kind::AprilGrid(grid) => return self.of_tags(grid.find(picture)),
        };
        // Discs are bounded by levels of 8 bits.
        let levels = picture.map(|value| u8::from_unit(value.to_unit()));
        circle_grid::find(&levels, size, arrangement)
    }

    /// The same, and of a chessboard that the border of the picture cuts the part that is seen, as
    /// [`chessboard::find_part`].
    ///
    /// # Errors
    /// As [`find`](Self::find).
    pub fn find_part<T: Sample>(&self, picture: &Plane<T>) -> Result<FoundBoard, CalibrationError> {
        match self.0 {
            Kind::Plain(Pattern::Chessboard, size, _) => chessboard::find_part(picture, size),
            _ => self.find(picture),
        }
    }
}

impl From<CharucoBoard> for Board {
    fn from(board: CharucoBoard) -> Self {
        Self(Kind::Charuco(board))
    }
}

impl From<AprilGrid> for Board {
    fn from(grid: AprilGrid) -> Self {
        Self(Kind::AprilGrid(grid))
    }
}

impl Board {
    fn columns(&self) -> usize {
        match self.0 {
            Kind::Plain(_, size, _) => size.columns(),
            Kind::Charuco(board) => board.columns(),
            Kind::AprilGrid(grid) => grid.columns(),
        }
    }

    fn of_tags(&self, view: BoardView) -> Result<FoundBoard, CalibrationError> {
        match self.places_a_board(&view) {
            true => Ok(FoundBoard::new(self.columns(), view, Vec::new())),
            false => Err(CalibrationError::TagsNotFound {
                found: view.points().len(),
                count: self.places().len(),
            }),
        }
    }

    /// Whether points say where the board is, which those of a line do not: they are enough, and
    /// four of them are around a square or a tag.
    pub(crate) fn places_a_board(&self, view: &BoardView) -> bool {
        let columns = self.columns();
        let is_square = |seen: &SeenPoint| {
            let others = [1, columns, columns + 1].map(|step| seen.point + step);
            !(seen.point + 1).is_multiple_of(columns)
                && others.into_iter().all(|point| view.shows(point))
        };
        view.points().len() >= LEAST_FOUND && view.points().iter().any(is_square)
    }
}

/// What was found in a picture, which may show no board: then the reason.
pub(crate) fn or_reason(
    found: Result<FoundBoard, CalibrationError>,
) -> Result<Result<FoundBoard, String>, CalibrationError> {
    match found {
        Err(error) if error.is_not_found() => Ok(Err(error.to_string())),
        found => found.map(Ok),
    }
}
