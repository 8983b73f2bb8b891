//! What a picture shows of a board.

use super::error::CalibrationError;
use ga_runtime::cga3::Point;

/// The points of a board that a picture shows: all of them, or some.
///
/// ```
/// use ga_vision::calibration::{BoardView, SeenPoint};
///
/// let seen = |point: usize, pixel: [f64; 2]| SeenPoint { point, pixel };
/// let left = BoardView::new(vec![seen(7, [90.0, 12.0]), seen(3, [40.0, 11.0])])?;
/// let right = BoardView::new(vec![seen(7, [81.0, 12.5]), seen(8, [95.0, 12.5])])?;
/// assert_eq!(left.points()[0].point, 3);
/// let [left, right] = left.shared(&right);
/// assert_eq!(left.points(), [seen(7, [90.0, 12.0])]);
/// assert_eq!(right.points(), [seen(7, [81.0, 12.5])]);
/// # Ok::<(), ga_vision::calibration::CalibrationError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoardView {
    points: Vec<SeenPoint>,
}

/// A point of a board in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenPoint {
    /// Its index among the points of the board.
    pub point: usize,
    /// Where it is.
    pub pixel: [f64; 2],
}

impl BoardView {
    /// A view of some points, which are put in the order of the board.
    ///
    /// # Errors
    /// [`CalibrationError::RepeatedPoint`] where a point is listed twice.
    pub fn new(points: Vec<SeenPoint>) -> Result<Self, CalibrationError> {
        let view = Self::of_different(points);
        let mut pairs = view.points.windows(2);
        match pairs.find(|pair| pair[0].point == pair[1].point) {
            Some(pair) => Err(CalibrationError::RepeatedPoint {
                point: pair[0].point,
            }),
            None => Ok(view),
        }
    }

    /// A view of points that are known to be different ones.
    pub(crate) fn of_different(mut points: Vec<SeenPoint>) -> Self {
        points.sort_by_key(|seen| seen.point);
        Self { points }
    }

    /// A view of the first points of a board, usually of all.
    #[must_use]
    pub fn complete(pixels: &[[f64; 2]]) -> Self {
        let points = pixels.iter().enumerate();
        let points = points.map(|(point, &pixel)| SeenPoint { point, pixel });
        Self {
            points: points.collect(),
        }
    }

    /// The points, in the order of the board.
    #[must_use]
    pub fn points(&self) -> &[SeenPoint] {
        &self.points
    }

    /// Where they are in the picture.
    #[must_use]
    pub fn pixels(&self) -> Vec<[f64; 2]> {
        self.points.iter().map(|seen| seen.pixel).collect()
    }

    /// Where they are on a board, of which `places` has all points. `None` where the board does not
    /// have one of them.
    #[must_use]
    pub fn places(&self, places: &[Point<f64>]) -> Option<Vec<Point<f64>>> {
        let place = |seen: &SeenPoint| places.get(seen.point).copied();
        self.points.iter().map(place).collect()
    }

    /// Whether a point is seen.
    #[must_use]
    pub fn shows(&self, point: usize) -> bool {
        self.points
            .binary_search_by_key(&point, |seen| seen.point)
            .is_ok()
    }

    /// Two views with the points that both show, in the same order.
    #[must_use]
    pub fn shared(&self, other: &Self) -> [Self; 2] {
        let within = |view: &Self, other: &Self| {
            let is_shared = |seen: &&SeenPoint| other.shows(seen.point);
            Self {
                points: view.points.iter().filter(is_shared).copied().collect(),
            }
        };
        [within(self, other), within(other, self)]
    }
}
