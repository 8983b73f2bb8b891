//! The cells of which attention is computed.

use ga_image::plane::Plane;

/// The side of a cell in reduced pixels.
pub(super) const CELL: usize = 8;

/// Columns and rows of cells.
pub(super) fn cells(picture: &Plane<u8>) -> [usize; 2] {
    [picture.width(), picture.height()].map(|side| side.div_ceil(CELL))
}
