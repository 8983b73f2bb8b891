//! Sizes of boards.

use crate::calibration::CalibrationError;
use ga_runtime::cga3::Point;
use std::fmt;
use std::str::FromStr;

/// How many inner corners a chessboard has, in a row and rows: 9 × 6 for one of 10 × 7 squares. Of
/// a grid of circles it is the number of circles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BoardSize {
    pub(super) columns: usize,
    pub(super) rows: usize,
}

impl BoardSize {
    const LEAST: usize = 3;
    const GREATEST: usize = 100;

    /// A size from the number of inner corners in a row and of rows.
    ///
    /// # Errors
    /// [`CalibrationError::BoardSize`] where one of them is below 3 or above 100.
    pub fn new(columns: usize, rows: usize) -> Result<Self, CalibrationError> {
        let is_possible = |count: usize| (Self::LEAST..=Self::GREATEST).contains(&count);
        match is_possible(columns) && is_possible(rows) {
            true => Ok(Self { columns, rows }),
            false => Err(CalibrationError::BoardSize { columns, rows }),
        }
    }

    /// Inner corners in a row.
    #[must_use]
    pub fn columns(self) -> usize {
        self.columns
    }

    /// Rows of inner corners.
    #[must_use]
    pub fn rows(self) -> usize {
        self.rows
    }

    /// All inner corners.
    #[must_use]
    pub fn count(self) -> usize {
        self.columns * self.rows
    }

    /// The sizes of its parts that have half of the corners or more, the largest first.
    pub(super) fn parts(self) -> Vec<Self> {
        let columns = Self::LEAST..=self.columns;
        let sizes = columns.flat_map(|columns| {
            let rows = Self::LEAST..=self.rows;
            rows.map(move |rows| Self { columns, rows })
        });
        let is_part = |part: &Self| *part != self && 2 * part.count() >= self.count();
        let mut parts: Vec<Self> = sizes.filter(is_part).collect();
        parts.sort_by_key(|part| std::cmp::Reverse(part.count()));
        parts
    }

    /// The places of the corners on a board with squares of the given side: in the plane z = 0,
    /// from the origin along x, then along y.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_vision::chessboard::BoardSize;
    ///
    /// let places = "9x6".parse::<BoardSize>()?.places(0.025);
    /// assert_eq!(places.len(), 54);
    /// assert_eq!(places[9 + 2], Point::new(0.05, 0.025, 0.0));
    /// # Ok::<(), ga_vision::calibration::CalibrationError>(())
    /// ```
    #[must_use]
    pub fn places(self, square: f64) -> Vec<Point<f64>> {
        let place = |index: usize| {
            let (column, row) = (index % self.columns, index / self.columns);
            Point::new(column as f64 * square, row as f64 * square, 0.0)
        };
        (0..self.count()).map(place).collect()
    }
}

impl fmt::Display for BoardSize {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} × {}", self.columns, self.rows)
    }
}

impl FromStr for BoardSize {
    type Err = CalibrationError;

    fn from_str(text: &str) -> Result<Self, CalibrationError> {
        let wrong = || CalibrationError::BoardText(text.to_owned());
        let (columns, rows) = text.split_once('x').ok_or_else(wrong)?;
        let number = |text: &str| text.trim().parse().map_err(|_| wrong());
        Self::new(number(columns)?, number(rows)?)
    }
}
