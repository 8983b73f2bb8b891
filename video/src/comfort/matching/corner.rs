//! Corners, one in each cell of a grid.

use ga_image::plane::Plane;

use super::reduced::RADIUS;

/// Columns and rows of the grid.
const CELLS: [usize; 2] = [28, 16];

/// The least strength of a corner, in squared levels per squared pixel.
const LEAST_STRENGTH: f32 = 1.0;

/// The structure tensor is averaged over this number of pixels on either side.
const AROUND: usize = 2;

/// The least number of pixels on either side of a corner.
const MARGIN: usize = RADIUS + 1;

/// Finds the corners of views of one size.
#[derive(Clone, Debug)]
pub(super) struct Corners {
    /// The smaller eigenvalue of the structure tensor at each pixel.
    strengths: Plane,
    /// Products of slopes for rows, and their sums over rows.
    products: [Vec<f32>; 3],
    found: Vec<[usize; 2]>,
}

impl Corners {
    pub(super) fn new([width, height]: [usize; 2]) -> Self {
        Self {
            strengths: Plane::filled(width, height, 0.0),
            products: [(); 3].map(|()| vec![0.0; width]),
            found: Vec::with_capacity(CELLS[0] * CELLS[1]),
        }
    }

    /// The strongest corner of each cell that has one, by rows of cells.
    ///
    /// The strength is the smaller eigenvalue of the structure tensor, the mean of `∇I ∇Iᵀ` over
    /// 5 × 5 pixels (J. Shi and C. Tomasi, "Good features to track", 1994). A corner is a maximum
    /// of it among its eight neighbours.
    #[inline(always)]
    pub(super) fn find(&mut self, levels: &Plane) -> &[[usize; 2]] {
        let (width, height) = (levels.width(), levels.height());
        for row in MARGIN - 1..=height - MARGIN {
            self.measure_row(levels, row);
        }
        self.found.clear();
        let ranges = [width, height].map(|side| MARGIN..side - MARGIN);
        let [inner_columns, inner_rows] = &ranges;
        for cell in 0..CELLS[0] * CELLS[1] {
            let range = |index: usize, axis: usize, inner: &std::ops::Range<usize>| {
                let side = [width, height][axis];
                let ends = [index, index + 1].map(|end| end * side / CELLS[axis]);
                ends[0].max(inner.start)..ends[1].min(inner.end)
            };
            let columns = range(cell % CELLS[0], 0, inner_columns);
            let rows = range(cell / CELLS[0], 1, inner_rows);
            let mut best = (LEAST_STRENGTH, None);
            for row in rows {
                let line = self.strengths.row(row);
                for column in columns.clone() {
                    if line[column] > best.0 && is_top(&self.strengths, [column, row]) {
                        best = (line[column], Some([column, row]));
                    }
                }
            }
            self.found.extend(best.1);
        }
        &self.found
    }

    #[inline(always)]
    fn measure_row(&mut self, levels: &Plane, row: usize) {
        const COUNT: f32 = ((2 * AROUND + 1) * (2 * AROUND + 1)) as f32;
        let width = levels.width();
        let [xx, xy, yy] = &mut self.products;
        for sums in [&mut *xx, &mut *xy, &mut *yy] {
            sums.fill(0.0);
        }
        for near in row - AROUND..=row + AROUND {
            let line = levels.row(near);
            let [above, below] = [near - 1, near + 1].map(|row| levels.row(row));
            for column in 1..width - 1 {
                let x = 0.5 * (line[column + 1] - line[column - 1]);
                let y = 0.5 * (below[column] - above[column]);
                xx[column] += x * x;
                xy[column] += x * y;
                yy[column] += y * y;
            }
        }
        let strengths = self.strengths.row_mut(row);
        for column in AROUND + 1..width - AROUND - 1 {
            let mean = |sums: &[f32]| {
                let around = &sums[column - AROUND..=column + AROUND];
                (around[0] + around[1] + around[2] + around[3] + around[4]) / COUNT
            };
            let [a, b, c] = [mean(xx), mean(xy), mean(yy)];
            let (middle, half) = (0.5 * (a + c), 0.5 * (a - c));
            strengths[column] = middle - (half * half + b * b).sqrt();
        }
    }
}

/// Whether a value is the greatest of its neighbourhood; of equal ones the last one is.
#[inline(always)]
fn is_top(strengths: &Plane, [column, row]: [usize; 2]) -> bool {
    let centre = strengths.row(row)[column];
    let [above, line, below] =
        [row - 1, row, row + 1].map(|row| &strengths.row(row)[column - 1..=column + 1]);
    above.iter().all(|value| *value <= centre)
        && line[0] <= centre
        && line[2] < centre
        && below.iter().all(|value| *value < centre)
}
