//! Equations of closed curves, in which each point is joined to two neighbours on either side.

use nalgebra_035::{Matrix4, Vector4};

/// A symmetric matrix of 2 × 2 blocks, one row of blocks for each point of a closed curve,
/// factorised. A point has a block of its own; its neighbours have the numbers b and those after
/// them the numbers c, times the identity.
///
/// With the coordinates of the points one after the other and without the last two points, the
/// matrix has four diagonals on either side: `T = L D Lᵀ`. The last two points are found from the
/// Schur complement.
#[derive(Clone, Debug, Default)]
pub struct Ring {
    /// The reciprocals of D.
    reciprocals: Vec<f64>,
    /// The four numbers of each row of L before its 1, the nearest first.
    rows: Vec<[f64; 4]>,
    /// L⁻¹ times the columns of the last two points.
    border: Vec<[f64; 4]>,
    /// The inverse of the Schur complement.
    inverse: Matrix4<f64>,
}

impl Ring {
    /// The least number of points.
    pub const LEAST: usize = 6;

    /// Factorises a matrix of at least [`LEAST`](Self::LEAST) points from the blocks
    /// `[xx, xy, yy]`, the number that is added to their diagonals, and `[b, c]`. `None` where the
    /// matrix is not positive definite.
    ///
    /// ```
    /// use ga_numerics::banded::ring::Ring;
    ///
    /// // 4 x − x_before − x_after = 2 for all points, and so for both coordinates: x = 1.
    /// let mut ring = Ring::default();
    /// ring.factorise(&[[0.0; 3]; 8], 4.0, [-1.0, 0.0]).ok_or("not positive definite")?;
    /// let mut values = [[2.0, 4.0]; 8];
    /// ring.solve(&mut values);
    /// assert!(values.iter().all(|[x, y]| (x - 1.0).abs() < 1e-15 && (y - 2.0).abs() < 1e-15));
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn factorise(
        &mut self,
        blocks: &[[f64; 3]],
        diagonal: f64,
        [b, c]: [f64; 2],
    ) -> Option<()> {
        let (inner, last) = blocks.split_at(blocks.len() - 2);
        self.factorise_inner(inner, diagonal, [b, c])?;
        let places = inner.len();
        self.border.clear();
        self.border.resize(2 * places, [0.0; 4]);
        for axis in 0..2 {
            for (point, column, value) in [
                (0, 0, c),
                (0, 2, b),
                (1, 2, c),
                (places - 2, 0, c),
                (places - 1, 0, b),
                (places - 1, 2, c),
            ] {
                self.border[2 * point + axis][column + axis] += value;
            }
        }
        let mut complement = Matrix4::zeros();
        for (point, [xx, xy, yy]) in last.iter().enumerate() {
            let first = 2 * point;
            complement[(first, first)] = xx + diagonal;
            complement[(first + 1, first)] = *xy;
            complement[(first, first + 1)] = *xy;
            complement[(first + 1, first + 1)] = yy + diagonal;
        }
        for axis in 0..2 {
            complement[(axis, axis + 2)] = b;
            complement[(axis + 2, axis)] = b;
        }
        let mut before = [[0.0; 4]; 4];
        for ((values, row), reciprocal) in self
            .border
            .iter_mut()
            .zip(&self.rows)
            .zip(&self.reciprocals)
        {
            for (factor, earlier) in row.iter().zip(&before) {
                for (value, earlier) in values.iter_mut().zip(earlier) {
                    *value -= factor * earlier;
                }
            }
            let vector = Vector4::from(*values);
            complement -= vector * (vector * *reciprocal).transpose();
            before = [*values, before[0], before[1], before[2]];
        }
        self.inverse = complement.cholesky()?.inverse();
        Some(())
    }

    fn factorise_inner(
        &mut self,
        blocks: &[[f64; 3]],
        diagonal: f64,
        [b, c]: [f64; 2],
    ) -> Option<()> {
        self.reciprocals.clear();
        self.rows.clear();
        // The last four rows and reciprocals, the nearest first; zero before the beginning.
        let mut rows = [[0.0; 4]; 4];
        let mut reciprocals = [0.0; 4];
        for (point, [xx, xy, yy]) in blocks.iter().enumerate() {
            for (own, beside) in [(*xx, 0.0), (*yy, *xy)] {
                let fourth = if point >= 2 { c } else { 0.0 };
                let third = -fourth * rows[2][0];
                let second =
                    if point >= 1 { b } else { 0.0 } - fourth * rows[1][1] - third * rows[1][0];
                let first = beside - fourth * rows[0][2] - third * rows[0][1] - second * rows[0][0];
                let products = [first, second, third, fourth];
                let mut pivot = own + diagonal;
                let mut row = [0.0; 4];
                for k in 0..4 {
                    row[k] = products[k] * reciprocals[k];
                    pivot -= products[k] * row[k];
                }
                if pivot.is_nan() || pivot <= 1e-12 * (own + diagonal).abs() {
                    return None;
                }
                rows = [row, rows[0], rows[1], rows[2]];
                reciprocals = [
                    pivot.recip(),
                    reciprocals[0],
                    reciprocals[1],
                    reciprocals[2],
                ];
                self.rows.push(row);
                self.reciprocals.push(reciprocals[0]);
            }
        }
        Some(())
    }

    /// Replaces right-hand sides by the solutions.
    pub fn solve(&self, values: &mut [[f64; 2]]) {
        let (inner, last) = values.as_flattened_mut().split_at_mut(self.rows.len());
        let mut before = [0.0; 4];
        let mut sums = Vector4::zeros();
        for (index, row) in self.rows.iter().enumerate() {
            let mut value = inner[index];
            for (factor, earlier) in row.iter().zip(before) {
                value -= factor * earlier;
            }
            before = [value, before[0], before[1], before[2]];
            sums += Vector4::from(self.border[index]) * (value * self.reciprocals[index]);
            inner[index] = value;
        }
        let found = self.inverse * (Vector4::from_column_slice(last) - sums);
        last.copy_from_slice(found.as_slice());
        for (index, border) in self.border.iter().enumerate() {
            inner[index] -= Vector4::from(*border).dot(&found);
            inner[index] *= self.reciprocals[index];
        }
        for index in (0..inner.len()).rev() {
            let value = inner[index];
            for (k, factor) in self.rows[index].iter().enumerate().take(index) {
                inner[index - 1 - k] -= factor * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra_035::DMatrix;

    use super::*;

    /// The matrix in full.
    fn dense(blocks: &[[f64; 3]], diagonal: f64, neighbours: [f64; 2]) -> DMatrix<f64> {
        let count = blocks.len();
        let mut matrix = DMatrix::zeros(2 * count, 2 * count);
        for (point, [xx, xy, yy]) in blocks.iter().enumerate() {
            let first = 2 * point;
            matrix[(first, first)] = xx + diagonal;
            matrix[(first + 1, first + 1)] = yy + diagonal;
            matrix[(first, first + 1)] = *xy;
            matrix[(first + 1, first)] = *xy;
            for (offset, value) in [1, 2].into_iter().zip(neighbours) {
                for axis in 0..2 {
                    let other = 2 * ((point + offset) % count) + axis;
                    matrix[(first + axis, other)] = value;
                    matrix[(other, first + axis)] = value;
                }
            }
        }
        matrix
    }

    fn blocks(count: usize) -> Vec<[f64; 3]> {
        let number = |k: usize| ((7 * k + 3) % 11) as f64 / 11.0 - 0.5;
        (0..count)
            .map(|k| [number(k), number(k + 5), number(k + 2)])
            .collect()
    }

    #[test]
    fn solutions_are_those_of_the_dense_matrix() {
        for count in [6, 7, 8, 9, 40] {
            let (blocks, neighbours) = (blocks(count), [-2.5, 1.25]);
            let right = DMatrix::from_fn(2 * count, 1, |row, _| ((7 * row) % 5) as f64);
            let matrix = dense(&blocks, 9.0, neighbours);
            let expected = matrix.lu().solve(&right).unwrap();
            let mut ring = Ring::default();
            ring.factorise(&blocks, 9.0, neighbours).unwrap();
            let mut values: Vec<[f64; 2]> = right
                .as_slice()
                .chunks(2)
                .map(|pair| [pair[0], pair[1]])
                .collect();
            ring.solve(&mut values);
            for (value, expected) in values.as_flattened().iter().zip(expected.iter()) {
                assert!(
                    (value - expected).abs() < 1e-12,
                    "{count}: {value} {expected}"
                );
            }
        }
    }

    #[test]
    fn only_positive_definite_matrices_are_factorised() {
        for count in [6, 7, 25] {
            let (blocks, neighbours) = (blocks(count), [-2.5, 1.25]);
            let least = dense(&blocks, 0.0, neighbours)
                .symmetric_eigenvalues()
                .min();
            let mut ring = Ring::default();
            let mut works = |diagonal| ring.factorise(&blocks, diagonal, neighbours).is_some();
            assert!(works(1e-6 - least), "{count}");
            assert!(!works(-1e-6 - least), "{count}");
        }
    }
}
