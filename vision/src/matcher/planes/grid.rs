//! A view at half its size.

use super::super::view::View;

/// The pixels of a cell on a side.
const SIDE: usize = 2;

/// The sums of the levels of 2 × 2 pixels each, as cells of a grid. Cells at the right and the
/// lower border of a view of odd size repeat its outermost pixels.
pub(super) struct Grid {
    columns: usize,
    width: usize,
    sums: Vec<u16>,
}

impl Grid {
    pub(super) fn new(view: &View) -> Self {
        let (width, height) = (view.width(), view.height());
        let columns = width.div_ceil(SIDE);
        let mut sums = Vec::with_capacity(columns * height.div_ceil(SIDE));
        for row in (0..height).step_by(SIDE) {
            let rows = [view.row(row), view.row((row + 1).min(height - 1))];
            for column in (0..width).step_by(SIDE) {
                let next = (column + 1).min(width - 1);
                let sum = rows.map(|row| u16::from(row[column]) + u16::from(row[next]));
                sums.push(sum[0] + sum[1]);
            }
        }
        Self {
            columns,
            width,
            sums,
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

    /// Four times the mean level of a cell.
    pub(super) fn sum(&self, cell: usize) -> u16 {
        self.sums[cell]
    }

    /// The cell of a pixel.
    #[inline(always)]
    pub(super) fn cell(&self, column: usize, row: usize) -> usize {
        row / SIDE * self.columns + column / SIDE
    }

    /// The column and the row of the first pixel of a cell.
    pub(super) fn place(&self, cell: usize) -> [usize; 2] {
        [cell % self.columns, cell / self.columns].map(|place| place * SIDE)
    }

    /// The number of the first pixel of a cell.
    pub(super) fn pixel(&self, cell: usize) -> usize {
        let [column, row] = self.place(cell);
        row * self.width + column
    }
}
