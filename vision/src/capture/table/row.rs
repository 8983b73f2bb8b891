//! A row of a table of points.

use ga_runtime::cga3::Point;

/// The points of a frame, as a row of a table has them.
#[derive(Clone, Debug)]
pub struct PointRow {
    /// The line in the file, from 1.
    pub line: usize,
    /// Its name: what the column of frames has, or else the number of the row, from 0.
    pub label: String,
    /// The time in seconds, where the table has a column for it or the rate.
    pub time: Option<f64>,
    /// Each point, `None` where it was not seen.
    pub points: Vec<Option<Point<f64>>>,
}
