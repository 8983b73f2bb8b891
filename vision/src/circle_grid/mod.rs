//! Grids of circles in pictures: the centres of discs in columns and rows.
//!
//! [`find`] takes the dark regions of a picture at several thresholds that are ellipses, lets
//! lattices grow from one to the next, and takes one that is the board, neither more nor less;
//! where there is none, it does so with the bright regions. The centre of mass of a disc is that of
//! its ellipse, which under perspective is not the image of the disc's centre; the difference is
//! computed from the homography of the neighbours and removed. What remains is the difference by
//! the distortion of the lens within a disc.

mod centre;
mod disc;
mod lattice;

use ga_image::plane::Plane;
use ga_runtime::vga2::Vector;

use crate::calibration::{BoardView, CalibrationError};
use crate::chessboard::BoardSize;
use crate::found_board::FoundBoard;
use lattice::Cell;

/// How the rows of a grid lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// In columns, the distance of which is that of the rows.
    Symmetric,
    /// Every other row moved by half the distance of neighbours in a row, which is also that of the
    /// rows: point j of row i at (2 j + i mod 2, i).
    Asymmetric,
}

impl Arrangement {
    /// The places of the points in a board's plane, in distances of rows.
    fn places(self, size: BoardSize) -> Vec<[f64; 2]> {
        let places = (0..size.count()).map(|index| self.place(size, index));
        places.map(|place| place.map(f64::from)).collect()
    }

    fn place(self, size: BoardSize, index: usize) -> [i32; 2] {
        let columns = size.columns();
        let [column, row] = [index % columns, index / columns].map(|k| k as i32);
        match self {
            Self::Symmetric => [column, row],
            Self::Asymmetric => [2 * column + row % 2, row],
        }
    }

    /// The cells of the points in a lattice, whose two steps are the shortest between points.
    fn cells(self, size: BoardSize) -> Vec<Cell> {
        let places = (0..size.count()).map(|index| self.place(size, index));
        match self {
            Self::Symmetric => places.collect(),
            // The steps are (1, 1) and (−1, 1).
            Self::Asymmetric => places.map(|[x, y]| [(x + y) / 2, (y - x) / 2]).collect(),
        }
    }
}

/// The centres of the circles of a grid in a grey picture. All are darker than what is around
/// them, or all brighter, and 8 pixels wide or wider. All of them must be seen, and no others of
/// like size that continue the grid.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::circle_grid::{Arrangement, find};
///
/// // Discs with a radius of 6 pixels in distances of 20, from (40, 30) on.
/// let picture = Plane::from_fn(200, 140, |u: usize, v: usize| {
///     let from_centre = |x: usize, first: usize, count: usize| {
///         let nearest = (x.saturating_sub(first) as f64 / 20.0).round().min(count as f64 - 1.0);
///         x as f64 - first as f64 - 20.0 * nearest
///     };
///     let is_dark = from_centre(u, 40, 6).hypot(from_centre(v, 30, 4)) < 6.0;
///     if is_dark { 30u8 } else { 220 }
/// });
/// let grid = find(&picture, "6x4".parse()?, Arrangement::Symmetric)?;
/// let [u, v] = grid.view().pixels()[7];
/// assert!((u - 60.0).abs() < 0.01 && (v - 50.0).abs() < 0.01);
/// assert!(find(&picture, "5x4".parse()?, Arrangement::Symmetric).is_err());
/// # Ok::<(), ga_vision::calibration::CalibrationError>(())
/// ```
///
/// # Errors
/// [`CalibrationError::CirclesNotFound`].
pub fn find(
    picture: &Plane<u8>,
    size: BoardSize,
    arrangement: Arrangement,
) -> Result<FoundBoard, CalibrationError> {
    let dark = find_dark(picture, size, arrangement);
    let bright = || find_dark(&picture.map(|level| 255 - level), size, arrangement);
    dark.or_else(|dark| bright().map_err(|bright| dark.max(bright)))
        .map_err(
            |Largest { discs, largest }| CalibrationError::CirclesNotFound {
                size: [size.columns(), size.rows()],
                discs,
                largest,
            },
        )
}

/// The largest grid where none is the board: how many discs there are, and how many lie in it.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Largest {
    largest: usize,
    discs: usize,
}

/// The board in a picture of dark discs.
fn find_dark(
    picture: &Plane<u8>,
    size: BoardSize,
    arrangement: Arrangement,
) -> Result<FoundBoard, Largest> {
    let discs = disc::discs(picture);
    let cells = arrangement.cells(size);
    let mut largest = 0;
    for lattice in lattice::lattices(&discs) {
        largest = largest.max(lattice.len());
        let orders = lattice.orders(&cells);
        let places = arrangement.places(size);
        let sum = |order: &[usize]| {
            let Vector { e1, e2 } = discs[order[0]].centre;
            e1 + e2
        };
        let first = orders.iter().min_by(|a, b| sum(a).total_cmp(&sum(b)));
        if let Some(order) = first
            && let Some(centres) = centre::centres(&discs, order, &places)
        {
            let others = orders.iter().filter(|other| *other != order);
            let others = others.map(|other| {
                let index = |disc: &usize| order.iter().position(|own| own == disc);
                other.iter().filter_map(index).collect()
            });
            let others: Vec<Vec<usize>> = others.collect();
            let view = BoardView::complete(&centres);
            return Ok(FoundBoard::new(size.columns(), view, others));
        }
    }
    Err(Largest {
        largest,
        discs: discs.len(),
    })
}
