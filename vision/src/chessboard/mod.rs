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
mod whole_board;

use std::borrow::Cow;
use std::collections::HashSet;

use ga_image::plane::{Plane, PlaneView};
use ga_image::pyramid::halved;
use ga_image::sample::Sample;
use ga_runtime::vga2::Vector;

use crate::calibration::{BoardView, CalibrationError, SeenPoint};
use crate::found_board::FoundBoard;
pub use board_size::BoardSize;
pub use picture::pair_picture;
use refinement::Gradient;

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
    let picture = picture.into().map(Sample::to_unit);
    let mut search = Search::new(&picture, size);
    match search.board(&[size])? {
        Some((_, corners)) => {
            let view = BoardView::complete(&corners);
            Ok(FoundBoard::new(size.columns(), view, other_orders(size)))
        }
        None => Err(search.not_found()),
    }
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
    let picture = picture.into();
    let whole = find(picture, size);
    if !matches!(whole, Err(CalibrationError::NotFound { .. })) {
        return whole;
    }
    let picture = picture.map(Sample::to_unit);
    match Search::new(&picture, size).board(&size.parts())? {
        Some((part, corners)) => {
            let seen = corners.into_iter().enumerate().map(|(index, pixel)| {
                let (column, row) = (index % part.columns(), index / part.columns());
                let point = row * size.columns() + column;
                SeenPoint { point, pixel }
            });
            let view = BoardView::of_different(seen.collect());
            Ok(FoundBoard::new(size.columns(), view, Vec::new()))
        }
        None => whole,
    }
}

/// A search for a board in several sizes of a picture.
struct Search<'a> {
    picture: &'a Plane<f32>,
    size: BoardSize,
    /// How many corners the largest grid has, and its columns and rows.
    largest: (usize, [usize; 2]),
}

impl<'a> Search<'a> {
    fn new(picture: &'a Plane<f32>, size: BoardSize) -> Self {
        Self {
            picture,
            size,
            largest: (0, [0, 0]),
        }
    }

    fn not_found(&self) -> CalibrationError {
        let (corners, extent) = self.largest;
        CalibrationError::NotFound {
            size: [self.size.columns(), self.size.rows()],
            corners,
            extent,
        }
    }

    /// The first of several sizes, of the whole board or of parts, in which it is found, and the
    /// pixels of the corners.
    fn board(&mut self, sizes: &[BoardSize]) -> Result<Option<Found>, CalibrationError> {
        /// Where the longer side of a picture is within this, it is not made smaller at first.
        const FIRST_SIDE: usize = 1000;
        /// The least of the shorter side of a picture that is made smaller.
        const LEAST_SIDE: usize = 80;
        let picture = self.picture;
        let mut levels = vec![Cow::Borrowed(picture)];
        let side = |level: &Plane<f32>| level.width().max(level.height());
        while let Some(last) = levels.last()
            && last.width().min(last.height()) >= 2 * LEAST_SIDE
        {
            let next = halved(last.as_ref());
            levels.push(Cow::Owned(next));
        }
        let first = levels.iter().position(|level| side(level) <= FIRST_SIDE);
        let first = first.unwrap_or(levels.len() - 1);
        let order = (0..=first).rev().chain(first + 1..levels.len());
        let mut gradient = None;
        for level in order {
            let saddles = saddle::saddles(&levels[level], self.size.count())?;
            // Grids that share saddle points have candidates in common.
            let mut tried = HashSet::new();
            for grid in grid::grids(&saddles) {
                if grid.corner_count() > self.largest.0 {
                    self.largest = (grid.corner_count(), grid.extent());
                }
                let boards = |size: &BoardSize| {
                    let size = *size;
                    grid.boards(size)
                        .into_iter()
                        .map(move |board| (size, board))
                };
                for (size, indices) in sizes.iter().flat_map(boards) {
                    if tried.contains(&indices) {
                        continue;
                    }
                    // The centre of a pixel of a halved picture is that of a pixel of the picture.
                    let scale = f64::from(1_u32 << level);
                    let corners = indices.iter().map(|&index| saddles[index].place * scale);
                    let corners: Vec<Vector<f64>> = corners.collect();
                    if !whole_board::is_cut_where_short(picture, &corners, size, self.size) {
                        continue;
                    }
                    tried.insert(indices);
                    if !whole_board::is_board(picture, &corners, size, self.size) {
                        continue;
                    }
                    let gradient = match &mut gradient {
                        Some(gradient) => gradient,
                        none => none.insert(Gradient::new(picture)?),
                    };
                    if let Some(corners) = gradient.refine(&corners, size) {
                        let corners = corners.into_iter().map(Vector::coordinates);
                        return Ok(Some((size, corners.collect())));
                    }
                }
            }
        }
        Ok(None)
    }
}

/// A size, and the pixels of the corners.
type Found = (BoardSize, Vec<[f64; 2]>);

/// The orders other than the first in which a board looks the same, as indices of its corners.
fn other_orders(size: BoardSize) -> Vec<Vec<usize>> {
    let BoardSize { columns, rows } = size;
    let index = |column: usize, row: usize| row * columns + column;
    let (right, bottom) = (columns - 1, rows - 1);
    let rotated = |from: &dyn Fn(usize, usize) -> usize| -> Vec<usize> {
        let corners = 0..size.count();
        corners.map(|k| from(k % columns, k / columns)).collect()
    };
    let mut orders = Vec::new();
    if (columns + rows).is_multiple_of(2) {
        orders.push(rotated(&|column, row| index(right - column, bottom - row)));
    }
    if columns == rows && columns.is_multiple_of(2) {
        orders.push(rotated(&|column, row| index(right - row, column)));
        orders.push(rotated(&|column, row| index(row, bottom - column)));
    }
    orders
}
