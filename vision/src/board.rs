//! Boards for calibration: what is printed on them, how large it is, and where it is in a picture.

use std::fmt;

use ga_image::plane::Plane;
use ga_image::sample::Sample;
use ga_runtime::cga3::Point;

use crate::calibration::CalibrationError;
use crate::chessboard::{self, BoardSize};
use crate::circle_grid::{self, Arrangement};
use crate::found_board::FoundBoard;

/// What is printed on a board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pattern {
    /// Squares, bright and dark in turn; the points are their inner corners.
    #[default]
    Chessboard,
    /// Dark discs in columns and rows; the points are their centres.
    Circles,
    /// Dark discs of which every other row is moved by half the distance of two neighbours in it.
    AsymmetricCircles,
}

/// A flat board with points in columns and rows, at known places.
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
pub struct Board {
    pattern: Pattern,
    size: BoardSize,
    spacing: f64,
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
            true => Ok(Self {
                pattern,
                size,
                spacing,
            }),
            false => Err(CalibrationError::Spacing { metres: spacing }),
        }
    }

    /// What is printed on it.
    #[must_use]
    pub fn pattern(&self) -> Pattern {
        self.pattern
    }

    /// The numbers of its points.
    #[must_use]
    pub fn size(&self) -> BoardSize {
        self.size
    }

    /// The length in metres by which it was made.
    #[must_use]
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Where its points are in metres: in the plane z = 0, from the origin along x, then along y.
    /// With every other row moved, point j of row i is at `((2 j + i mod 2) s, i s)`, as OpenCV has
    /// it.
    #[must_use]
    pub fn places(&self) -> Vec<Point<f64>> {
        match self.pattern {
            Pattern::Chessboard | Pattern::Circles => self.size.places(self.spacing),
            Pattern::AsymmetricCircles => {
                let columns = self.size.columns();
                let place = |index: usize| {
                    let (column, row) = (index % columns, index / columns);
                    let x = (2 * column + row % 2) as f64 * self.spacing;
                    Point::new(x, row as f64 * self.spacing, 0.0)
                };
                (0..self.size.count()).map(place).collect()
            }
        }
    }

    /// Pairs of neighbouring points: those that follow each other in a row, or in a column.
    #[must_use]
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let (columns, count) = (self.size.columns(), self.size.count());
        let along = (1..count).filter(|index| index % columns > 0);
        let along = along.map(|index| [index - 1, index]);
        // With every other row moved, the row after the next is the one above.
        let stride = match self.pattern {
            Pattern::AsymmetricCircles => 2 * columns,
            _ => columns,
        };
        let down = (stride..count).map(|index| [index - stride, index]);
        along.chain(down).collect()
    }

    /// Where its points are in a grey picture.
    ///
    /// # Errors
    /// As [`chessboard::find`] and [`circle_grid::find`].
    pub fn find<T: Sample>(&self, picture: &Plane<T>) -> Result<FoundBoard, CalibrationError> {
        let arrangement = match self.pattern {
            Pattern::Chessboard => return chessboard::find(picture, self.size),
            Pattern::Circles => Arrangement::Symmetric,
            Pattern::AsymmetricCircles => Arrangement::Asymmetric,
        };
        // Discs are bounded by levels of 8 bits.
        let levels = picture.map(|value| u8::from_unit(value.to_unit()));
        circle_grid::find(&levels, self.size, arrangement)
    }
}

impl Board {
    /// The same, where a picture may show no board: then the reason.
    pub(crate) fn look_for<T: Sample>(
        &self,
        picture: &Plane<T>,
    ) -> Result<Result<FoundBoard, String>, CalibrationError> {
        match self.find(picture) {
            Err(error) if error.is_not_found() => Ok(Err(error.to_string())),
            found => found.map(Ok),
        }
    }
}

impl fmt::Display for Pattern {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Chessboard => "chessboard",
            Self::Circles => "circles",
            Self::AsymmetricCircles => "asymmetric circles",
        })
    }
}
