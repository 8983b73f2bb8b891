//! Chessboards in pictures: the inner corners of the squares, to a small part of a pixel.
//!
//! [`find`] takes the saddle points of the brightness, in several sizes of the picture, and lets
//! grids grow from one to the next along the edges that cross there. A neighbour must lie on the
//! edge, and its bright and dark quadrants must be exchanged. A complete rectangle in a grid is a
//! board where its squares are bright and dark in turn and no further row or column of corners
//! follows. Its corners are refined in the picture itself, to where the gradients around them meet
//! at right angles.
//!
//! Grids that grow from corner to corner are those of A. Geiger and others, "Automatic camera and
//! range sensor calibration using a single shot", 2012, who find corners by templates; the saddle
//! points, and the conditions on edges and quadrants, are our own. The refinement is that of
//! W. Förstner and E. Gülch, "A fast operator for detection and precise location of distinct
//! points, corners and centres of circular features", 1987.

mod board_size;
mod grid;
mod picture;
mod places;
pub(crate) mod refinement;
mod saddle;
mod search;
mod whole_board;

use ga_image::plane::PlaneView;
use ga_image::sample::Sample;

use crate::calibration::CalibrationError;
use crate::found_board::FoundBoard;
pub use board_size::BoardSize;
pub use picture::pair_picture;
use search::Search;

/// The inner corners of a chessboard in a grey picture, whatever its brightness. All of them must
/// be seen, with a part of the outermost squares around them; other things in the picture may be
/// beside the board but not on it. Squares should be 8 pixels wide or wider.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::chessboard::{BoardSize, find};
///
/// // Squares of 20 pixels, from (40, 30) on: the edges are half a pixel before pixel centres.
/// let picture = Plane::from_fn(240, 200, |column: usize, row: usize| {
///     let inside = (40..180).contains(&column) && (30..130).contains(&row);
///     let dark = inside && ((column - 40) / 20 + (row - 30) / 20) % 2 == 0;
///     if dark { 20u8 } else { 230 }
/// });
/// let board = find(&picture, BoardSize::new(6, 4)?)?;
/// let [u, v] = board.view().pixels()[0];
/// assert!((u - 59.5).abs() < 1e-3 && (v - 49.5).abs() < 1e-3);
/// assert!(find(&picture, BoardSize::new(7, 4)?).is_err());
/// # Ok::<(), ga_vision::calibration::CalibrationError>(())
/// ```
///
/// # Errors
///
/// [`CalibrationError::NotFound`] where no complete board of this size is seen, or a larger one of
/// which it would be a part. Of a board that goes on outside the picture nothing is known: what is
/// within the picture is taken for the whole.
pub fn find<'a, T: Sample>(
    picture: impl Into<PlaneView<'a, T>>,
    size: BoardSize,
) -> Result<FoundBoard, CalibrationError> {
    Search::new(picture.into().map(Sample::to_unit), size).whole()
}

/// The same, or, where there is no complete board, the rows and columns of one that are complete
/// where the border of the picture cuts it: three or more of each, with half of its corners.
///
/// Which rows and columns they are cannot be told. The corners have the numbers that they would
/// have on a board with the first corner of the part as its own, which is enough for one camera:
/// the board of each view has a motor of its own.
///
/// # Errors
///
/// As [`find`].
pub fn find_part<'a, T: Sample>(
    picture: impl Into<PlaneView<'a, T>>,
    size: BoardSize,
) -> Result<FoundBoard, CalibrationError> {
    let mut search = Search::new(picture.into().map(Sample::to_unit), size);
    match search.whole() {
        Err(CalibrationError::NotFound { .. }) => search.part(),
        whole => whole,
    }
}
