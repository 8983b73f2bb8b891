//! A view at half its size.

use super::super::view::View;

/// The pixels of a cell on a side.
const SIDE: usize = 2;

/// The sums of the levels of 2 × 2 pixels each, as cells of a grid. Cells at the right and the
/// lower border of a view of odd size repeat its outermost pixels.
#[derive(Debug, Default)]
pub(super) struct Grid {
    columns: usize,
    sums: Vec<u16>,
}

/// A cell of a grid.
#[derive(Clone, Copy)]
pub(super) struct Cell {
    pub(super) number: usize,
    /// The column and the row of its first pixel.
    pub(super) place: [usize; 2],
}

impl Grid {
    /// Takes the levels of a view.
    pub(super) fn fill(&mut self, view: &View) {
        let (width, height) = (view.width(), view.height());
        self.columns = width.div_ceil(SIDE);
        self.sums.clear();
        self.sums.reserve(self.columns * height.div_ceil(SIDE));
        for row in (0..height).step_by(SIDE) {
            let [upper, lower] = [view.row(row), view.row((row + 1).min(height - 1))];
            let pairs = upper.chunks(SIDE).zip(lower.chunks(SIDE));
            self.sums.extend(pairs.map(|(upper, lower)| {
                let sum = |pair: &[u8]| u16::from(pair[0]) + u16::from(pair[pair.len() - 1]);
                sum(upper) + sum(lower)
            }));
        }
    }

    /// The number of cells.
    pub(super) fn cells(&self) -> usize {
        self.sums.len()
    }

    /// The number of cells in a row.
    pub(super) fn columns(&self) -> usize {
        self.columns
    }

    /// The sums of the rows of cells.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[u16]> {
        self.sums.chunks_exact(self.columns)
    }

    /// Four times the mean level of a cell.
    pub(super) fn sum(&self, cell: usize) -> u16 {
        self.sums[cell]
    }

    /// All cells, row by row.
    pub(super) fn each(&self, mut visit: impl FnMut(Cell)) {
        for (row, cells) in self.rows().enumerate() {
            for column in 0..cells.len() {
                visit(Cell {
                    number: row * self.columns + column,
                    place: [column * SIDE, row * SIDE],
                });
            }
        }
    }

    /// The cell of a pixel.
    #[inline(always)]
    pub(super) fn cell(&self, column: usize, row: usize) -> usize {
        row / SIDE * self.columns + column / SIDE
    }
}
