//! Equations of closed curves, in which each point is joined to two neighbours on either side.

/// The symmetric matrix with the same five numbers round the diagonal of every row,
/// `c b a b c`, that continue from the last column to the first, factorised.
///
/// Without the last two unknowns the matrix has five diagonals, `T = L D Lᵀ`; they are found first,
/// by the Schur complement.
#[derive(Clone, Debug, Default)]
pub(super) struct Cyclic {
    /// The diagonal of D, and the two of L below that of ones.
    diagonal: Vec<f64>,
    below: Vec<[f64; 2]>,
    /// T⁻¹ times the columns of the last two unknowns.
    border: Vec<[f64; 2]>,
    /// The inverse of the Schur complement: its diagonal numbers and the one beside them.
    inverse: [f64; 3],
    /// b and c.
    beside: [f64; 2],
}

impl Cyclic {
    /// The least number of unknowns.
    pub(super) const LEAST: usize = 6;

    /// Factorises the matrix of `count` unknowns, at least [`LEAST`](Self::LEAST), with the numbers
    /// a, b, c. The matrix has to be positive definite.
    pub(super) fn factorise(&mut self, count: usize, [a, b, c]: [f64; 3]) {
        let inner = count - 2;
        self.beside = [b, c];
        self.diagonal.clear();
        self.below.clear();
        for index in 0..inner {
            let far = if index >= 2 {
                c / self.diagonal[index - 2]
            } else {
                0.0
            };
            let mut near = 0.0;
            let mut pivot = a;
            if index >= 2 {
                pivot -= far * far * self.diagonal[index - 2];
            }
            if index >= 1 {
                let mixed = if index >= 2 {
                    far * self.diagonal[index - 2] * self.below[index - 1][0]
                } else {
                    0.0
                };
                near = (b - mixed) / self.diagonal[index - 1];
                pivot -= near * near * self.diagonal[index - 1];
            }
            self.diagonal.push(pivot);
            self.below.push([near, far]);
        }
        let mut border = std::mem::take(&mut self.border);
        border.clear();
        border.resize(inner, [0.0; 2]);
        for (row, column, value) in [
            (0, 0, c),
            (0, 1, b),
            (1, 1, c),
            (inner - 2, 0, c),
            (inner - 1, 0, b),
            (inner - 1, 1, c),
        ] {
            border[row][column] += value;
        }
        self.solve_inner(&mut border);
        let [first, second] = self.outer(&border);
        let (p, q, r) = (a - first[0], b - first[1], a - second[1]);
        let determinant = p * r - q * q;
        self.inverse = [r / determinant, -q / determinant, p / determinant];
        self.border = border;
    }

    /// Replaces right-hand sides, of two sets of unknowns, by the solutions.
    pub(super) fn solve(&self, values: &mut [[f64; 2]]) {
        let (inner, last) = values.split_at_mut(self.diagonal.len());
        self.solve_inner(inner);
        let sums = self.outer(inner);
        let [p, q, r] = self.inverse;
        let rest = [0, 1].map(|k| [0, 1].map(|axis| last[k][axis] - sums[k][axis]));
        last[0] = [0, 1].map(|axis| p * rest[0][axis] + q * rest[1][axis]);
        last[1] = [0, 1].map(|axis| q * rest[0][axis] + r * rest[1][axis]);
        for (value, border) in inner.iter_mut().zip(&self.border) {
            for (axis, number) in value.iter_mut().enumerate() {
                *number -= border[0] * last[0][axis] + border[1] * last[1][axis];
            }
        }
    }

    /// The rows of the last two unknowns, times values of the others.
    fn outer(&self, values: &[[f64; 2]]) -> [[f64; 2]; 2] {
        let [b, c] = self.beside;
        let count = values.len();
        let sum = |terms: [(f64, usize); 3]| {
            [0, 1].map(|axis| {
                let products = terms
                    .iter()
                    .map(|(weight, index)| weight * values[*index][axis]);
                products.sum::<f64>()
            })
        };
        [
            sum([(c, 0), (c, count - 2), (b, count - 1)]),
            sum([(b, 0), (c, 1), (c, count - 1)]),
        ]
    }

    fn solve_inner(&self, values: &mut [[f64; 2]]) {
        let count = values.len();
        for axis in 0..2 {
            let [mut before, mut second] = [0.0; 2];
            for (value, [near, far]) in values.iter_mut().zip(&self.below) {
                value[axis] -= near * before + far * second;
                second = before;
                before = value[axis];
            }
            let [mut after, mut second] = [0.0; 2];
            for index in (0..count).rev() {
                let near = self.below.get(index + 1).map_or(0.0, |below| below[0]);
                let far = self.below.get(index + 2).map_or(0.0, |below| below[1]);
                let value = values[index][axis] / self.diagonal[index];
                values[index][axis] = value - near * after - far * second;
                second = after;
                after = values[index][axis];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra_035::DMatrix;

    use super::*;

    #[test]
    fn solutions_are_those_of_the_dense_matrix() {
        for count in [6, 7, 8, 9, 40] {
            let numbers = [9.0, -2.5, 1.25];
            let mut matrix = DMatrix::zeros(count, count);
            for row in 0..count {
                for (offset, value) in [0, 1, 2].into_iter().zip(numbers) {
                    matrix[(row, (row + offset) % count)] = value;
                    matrix[(row, (row + count - offset) % count)] = value;
                }
            }
            let right = DMatrix::from_fn(count, 2, |row, axis| ((7 * row + axis) % 5) as f64);
            let expected = matrix.lu().solve(&right).unwrap();
            let mut cyclic = Cyclic::default();
            cyclic.factorise(count, numbers);
            let mut values: Vec<[f64; 2]> = right.row_iter().map(|row| [row[0], row[1]]).collect();
            cyclic.solve(&mut values);
            for (value, expected) in values.iter().zip(expected.row_iter()) {
                assert!((value[0] - expected[0]).abs() < 1e-13, "{count}");
                assert!((value[1] - expected[1]).abs() < 1e-13, "{count}");
            }
        }
    }
}
