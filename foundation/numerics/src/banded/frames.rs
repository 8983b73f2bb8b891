//! Symmetric systems of equations in which a frame depends on the two frames before it.

use nalgebra_035::{Cholesky, DMatrix, DVector};

/// The matrix of frames, symmetric: their couplings, of which all but those within a frame are
/// block diagonal: blocks of
/// 3×3 or of 1×1 for the unknowns of each joint.
#[derive(Clone, Debug)]
pub struct Couplings {
    /// For each frame, its own matrix, the lower triangle.
    pub own: Vec<DMatrix<f64>>,
    /// For each frame, the rows of the frame and the columns of the frame before.
    pub before: Vec<Blocks>,
    /// The columns of the frame before that.
    pub two_before: Vec<Blocks>,
}

/// A block-diagonal matrix: for each block its first row and its entries, of which a block of one
/// row uses the first.
pub type Blocks = Vec<Block>;

/// A block on the diagonal of a block-diagonal matrix.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    /// Its first row and column.
    pub first: usize,
    /// How many rows it has, 1 or 3.
    pub size: usize,
    /// Its entries, row by row.
    pub entries: [[f64; 3]; 3],
}

/// The Cholesky factor, by blocks of frames.
#[derive(Clone, Debug)]
pub struct Factor {
    /// For each frame the inverse of its triangle, L⁻¹.
    inverse: Vec<DMatrix<f64>>,
    before: Vec<DMatrix<f64>>,
    two_before: Vec<DMatrix<f64>>,
}

/// `block-diagonal · matrix`.
fn times(blocks: &Blocks, matrix: &DMatrix<f64>, product: &mut DMatrix<f64>) {
    for column in 0..matrix.ncols() {
        for block in blocks {
            for row in 0..block.size {
                let sum = (0..block.size)
                    .map(|k| block.entries[row][k] * matrix[(block.first + k, column)]);
                product[(block.first + row, column)] = sum.sum();
            }
        }
    }
}

impl Couplings {
    /// Adds a block to those within a frame.
    pub fn add_own(&mut self, frame: usize, block: &Block) {
        for row in 0..block.size {
            for column in 0..=row {
                let place = (block.first + row, block.first + column);
                self.own[frame][place] += block.entries[row][column];
            }
        }
    }

    /// Adds a block to those with the frame before.
    pub fn add_before(&mut self, frame: usize, block: &Block) {
        let blocks = &mut self.before[frame];
        let Some(found) = blocks.iter_mut().find(|found| found.first == block.first) else {
            blocks.push(*block);
            return;
        };
        for (found, added) in found
            .entries
            .iter_mut()
            .flatten()
            .zip(block.entries.iter().flatten())
        {
            *found += added;
        }
    }

    /// The factor, by elimination frame by frame (A. George, J. Liu, Computer Solution of Large
    /// Sparse Positive Definite Systems, 1981, chapter 4). `None` where the matrix is not positive
    /// definite in floating point.
    ///
    /// ```
    /// use ga_numerics::banded::frames::{Block, Couplings};
    /// use nalgebra_035::{DMatrix, DVector};
    ///
    /// // Two frames of one unknown each: 2 x + y = 3 and x + 2 y = 3.
    /// let coupling = Block { first: 0, size: 1, entries: [[1.0; 3]; 3] };
    /// let couplings = Couplings {
    ///     own: vec![DMatrix::from_element(1, 1, 2.0); 2],
    ///     before: vec![vec![], vec![coupling]],
    ///     two_before: vec![vec![]; 2],
    /// };
    /// let mut values = vec![DVector::from_element(1, 3.0); 2];
    /// couplings.factor().ok_or("not positive definite")?.solve(&mut values);
    /// assert!(values.iter().all(|x| (x[0] - 1.0).abs() < 1e-15));
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn factor(&self) -> Option<Factor> {
        let mut factor = Factor {
            inverse: Vec::with_capacity(self.own.len()),
            before: Vec::with_capacity(self.own.len()),
            two_before: Vec::with_capacity(self.own.len()),
        };
        let size = self.own.first().map_or(0, DMatrix::nrows);
        for (frame, own) in self.own.iter().enumerate() {
            let mut own = own.clone();
            let mut two_before = DMatrix::zeros(size, size);
            let mut before = DMatrix::zeros(size, size);
            if frame >= 2 {
                let inverse = factor.inverse[frame - 2].transpose();
                times(&self.two_before[frame], &inverse, &mut two_before);
                own.gemm(-1.0, &two_before, &two_before.transpose(), 1.0);
            }
            if frame >= 1 {
                let inverse = factor.inverse[frame - 1].transpose();
                times(&self.before[frame], &inverse, &mut before);
                if frame >= 2 {
                    let mixed = &factor.before[frame - 1].transpose() * &inverse;
                    before.gemm(-1.0, &two_before, &mixed, 1.0);
                }
                own.gemm(-1.0, &before, &before.transpose(), 1.0);
            }
            let lower = Cholesky::new(own)?.unpack();
            factor.inverse.push(inverted(&lower));
            factor.before.push(before);
            factor.two_before.push(two_before);
        }
        Some(factor)
    }
}

/// The inverse of a lower triangle.
fn inverted(lower: &DMatrix<f64>) -> DMatrix<f64> {
    let size = lower.nrows();
    let mut inverse = DMatrix::zeros(size, size);
    let entries = lower.as_slice();
    for column in 0..size {
        let solution = &mut inverse.as_mut_slice()[column * size..(column + 1) * size];
        solution[column] = 1.0;
        for k in column..size {
            let pivot = solution[k] / entries[k * size + k];
            solution[k] = pivot;
            let (below, of_column) = (&mut solution[k + 1..], &entries[k * size + k + 1..]);
            for (value, entry) in below.iter_mut().zip(of_column) {
                *value -= pivot * entry;
            }
        }
    }
    inverse
}

impl Factor {
    /// The solution of the equations with a right side, in its place.
    pub fn solve(&self, right: &mut [DVector<f64>]) {
        for frame in 0..right.len() {
            let mut own = std::mem::replace(&mut right[frame], DVector::zeros(0));
            if frame >= 1 {
                own.gemv(-1.0, &self.before[frame], &right[frame - 1], 1.0);
            }
            if frame >= 2 {
                own.gemv(-1.0, &self.two_before[frame], &right[frame - 2], 1.0);
            }
            right[frame] = &self.inverse[frame] * own;
        }
        self.solve_transposed(right);
    }

    /// The solution x of `Lᵀ x = right`.
    fn solve_transposed(&self, right: &mut [DVector<f64>]) {
        for frame in (0..right.len()).rev() {
            let mut own = std::mem::replace(&mut right[frame], DVector::zeros(0));
            if let Some(after) = right.get(frame + 1) {
                own.gemv_tr(-1.0, &self.before[frame + 1], after, 1.0);
            }
            if let Some(after) = right.get(frame + 2) {
                own.gemv_tr(-1.0, &self.two_before[frame + 2], after, 1.0);
            }
            right[frame] = self.inverse[frame].tr_mul(&own);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against nalgebra's solution of the dense matrix.
    #[test]
    fn factors_solve_the_dense_system() {
        let (frames, size) = (5, 4);
        let value = |k: usize| ((k * 7919 + 13) % 101) as f64 / 101.0 - 0.5;
        let blocks = |seed: usize| -> Blocks {
            let block = |first, size, seed: usize| Block {
                first,
                size,
                entries: [0, 1, 2].map(|r| [0, 1, 2].map(|c| value(seed + 3 * r + c))),
            };
            vec![block(0, 3, seed), block(3, 1, seed + 50)]
        };
        let own = |frame: usize| {
            let mixed = DMatrix::from_fn(size, size, |r, c| value(frame * 31 + 5 * r + c));
            &mixed * mixed.transpose() + DMatrix::identity(size, size) * 6.0
        };
        let couplings = Couplings {
            own: (0..frames).map(own).collect(),
            before: (0..frames).map(|frame| blocks(1000 + frame)).collect(),
            two_before: (0..frames).map(|frame| blocks(2000 + 3 * frame)).collect(),
        };
        let mut dense = DMatrix::zeros(frames * size, frames * size);
        let mut put = |row: usize, column: usize, blocks: &Blocks| {
            for block in blocks {
                for r in 0..block.size {
                    for c in 0..block.size {
                        let (i, j) = (
                            row * size + block.first + r,
                            column * size + block.first + c,
                        );
                        dense[(i, j)] = block.entries[r][c];
                        dense[(j, i)] = block.entries[r][c];
                    }
                }
            }
        };
        for frame in 1..frames {
            put(frame, frame - 1, &couplings.before[frame]);
            if frame >= 2 {
                put(frame, frame - 2, &couplings.two_before[frame]);
            }
        }
        for frame in 0..frames {
            let mut view = dense.view_mut((frame * size, frame * size), (size, size));
            view.copy_from(&couplings.own[frame]);
        }
        let factor = couplings.factor().expect("positive definite");
        let right = DVector::from_fn(frames * size, |k, _| value(3 * k));
        let mut found: Vec<DVector<f64>> = (0..frames)
            .map(|f| right.rows(f * size, size).into_owned())
            .collect();
        factor.solve(&mut found);
        let exact = dense.clone().lu().solve(&right).expect("regular");
        for (frame, found) in found.iter().enumerate() {
            assert!((found - exact.rows(frame * size, size)).norm() < 1e-12);
        }
    }
}
