//! What a picture shows of a board.

use ga_runtime::cga3::Point;

use super::error::CalibrationError;

/// A corner of a board in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoardCorner {
    /// Its number among the places of the board, from 0.
    pub place: usize,
    /// Where it is in the picture.
    pub pixel: [f64; 2],
}

/// The corners of a board that a picture shows: all of them, some, or none.
///
/// ```
/// use ga_vision::calibration::{BoardCorner, BoardView};
/// // Pixels alone are those of all places, in their order.
/// let complete = BoardView::from(vec![[10.0, 20.0], [30.0, 21.0]]);
/// let second = BoardCorner { place: 1, pixel: [30.0, 21.0] };
/// assert_eq!(complete.corners()[1], second);
/// assert_eq!(BoardView::from(vec![second]).corners(), [second]);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoardView {
    corners: Vec<BoardCorner>,
    /// Whether it has to have all corners.
    is_complete: bool,
}

impl From<Vec<[f64; 2]>> for BoardView {
    fn from(pixels: Vec<[f64; 2]>) -> Self {
        let corners = pixels.into_iter().enumerate();
        Self {
            corners: corners
                .map(|(place, pixel)| BoardCorner { place, pixel })
                .collect(),
            is_complete: true,
        }
    }
}

impl From<Vec<BoardCorner>> for BoardView {
    fn from(corners: Vec<BoardCorner>) -> Self {
        Self {
            corners,
            is_complete: false,
        }
    }
}

impl BoardView {
    /// The corners.
    #[must_use]
    pub fn corners(&self) -> &[BoardCorner] {
        &self.corners
    }

    /// Whether the picture does not show the board.
    pub(super) fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// The pixels of the corners.
    pub(super) fn pixels(&self) -> Vec<[f64; 2]> {
        self.corners.iter().map(|corner| corner.pixel).collect()
    }

    /// The places of the corners, of those of the board.
    pub(super) fn places<T: Copy>(&self, places: &[T]) -> Vec<T> {
        self.corners
            .iter()
            .map(|corner| places[corner.place])
            .collect()
    }

    /// Checks that the corners are those of a board with these places.
    pub(super) fn check(&self, view: usize, places: &[Point<f64>]) -> Result<(), CalibrationError> {
        let (found, expected) = (self.corners.len(), places.len());
        if self.is_complete && found != expected {
            return Err(CalibrationError::Corners {
                view,
                found,
                expected,
            });
        }
        let mut is_seen = vec![false; expected];
        for (corner, BoardCorner { place, pixel }) in self.corners.iter().enumerate() {
            let is_new = is_seen
                .get_mut(*place)
                .map(|seen| !std::mem::replace(seen, true));
            if is_new != Some(true) {
                return Err(CalibrationError::Place {
                    view,
                    corner,
                    place: *place,
                });
            }
            let coordinates = places[*place].coordinates();
            if !pixel.iter().chain(&coordinates).all(|x| x.is_finite()) {
                return Err(CalibrationError::NotFinite { view, corner });
            }
        }
        Ok(())
    }
}
