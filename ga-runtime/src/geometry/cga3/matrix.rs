//! Small linear systems and symmetric eigenproblems.

use alloc::vec::Vec;

use crate::scalar::{Field, Real, Ring};

pub(super) type Matrix<S, const N: usize> = [[S; N]; N];

/// The identity matrix.
pub(super) fn identity<S: Ring, const N: usize>() -> Matrix<S, N> {
    core::array::from_fn(|row| {
        core::array::from_fn(|column| if row == column { S::one() } else { S::zero() })
    })
}

/// The symmetric matrix of which the entries on and below the diagonal are given.
pub(super) fn symmetric<S: Ring, const N: usize>(lower: Matrix<S, N>) -> Matrix<S, N> {
    core::array::from_fn(|row| {
        core::array::from_fn(|column| lower[row.max(column)][row.min(column)])
    })
}

/// The solution x of `A x = b` by elimination with the largest pivot of each column; `None` where a
/// pivot is zero or not finite.
pub(super) fn solve<S: Real<Mask = bool>, const N: usize>(
    mut a: Matrix<S, N>,
    mut b: [S; N],
) -> Option<[S; N]> {
    for column in 0..N {
        let mut pivot = column;
        for row in column + 1..N {
            if a[pivot][column].abs().less_than(a[row][column].abs()) {
                pivot = row;
            }
        }
        a.swap(column, pivot);
        b.swap(column, pivot);
        let (upper, divided) = (a[column], b[column]);
        if upper[column].is_zero() || !upper[column].is_finite() {
            return None;
        }
        for row in column + 1..N {
            let factor = a[row][column] / upper[column];
            for place in column..N {
                a[row][place] = upper[place].neg_mul_add(factor, a[row][place]);
            }
            b[row] = divided.neg_mul_add(factor, b[row]);
        }
    }
    for row in (0..N).rev() {
        let known = (row + 1..N).fold(S::zero(), |sum, k| a[row][k].mul_add(b[k], sum));
        b[row] = (b[row] - known) / a[row][row];
    }
    Some(b)
}

/// The solutions of a block tridiagonal system for several right sides, by elimination without
/// pivots between the blocks. Of each row of blocks the first is left of the diagonal, the last
/// right of it; the first of the first row and the last of the last row are zero. `None` where a
/// block on the diagonal becomes singular.
pub(super) fn solve_tridiagonal<S: Real<Mask = bool>, const N: usize, const SIDES: usize>(
    rows: &[[Matrix<S, N>; 3]],
    mut sides: Vec<[[S; N]; SIDES]>,
) -> Option<Vec<[[S; N]; SIDES]>> {
    let mut above: Vec<Matrix<S, N>> = Vec::with_capacity(rows.len());
    for (k, &[before, mut diagonal, after]) in rows.iter().enumerate() {
        if let Some(up) = k.checked_sub(1) {
            for i in 0..N {
                for j in 0..N {
                    for m in 0..N {
                        diagonal[i][j] = before[i][m].neg_mul_add(above[up][m][j], diagonal[i][j]);
                    }
                }
            }
            let solved = sides[up];
            subtract(&mut sides[k], &before, solved);
        }
        let inverse = inverse(diagonal)?;
        let columns = transposed(after).map(|column| applied(&inverse, column));
        above.push(transposed(columns));
        sides[k] = sides[k].map(|side| applied(&inverse, side));
    }
    for k in (1..rows.len()).rev() {
        let solved = sides[k];
        subtract(&mut sides[k - 1], &above[k - 1], solved);
    }
    Some(sides)
}

/// The inverse; `None` where a pivot is zero or not finite.
pub(super) fn inverse<S: Real<Mask = bool>, const N: usize>(
    a: Matrix<S, N>,
) -> Option<Matrix<S, N>> {
    let mut columns = identity();
    for column in &mut columns {
        *column = solve(a, *column)?;
    }
    Some(transposed(columns))
}

/// The matrix with rows and columns exchanged.
pub(super) fn transposed<S: Ring, const N: usize>(a: Matrix<S, N>) -> Matrix<S, N> {
    core::array::from_fn(|i| core::array::from_fn(|j| a[j][i]))
}

/// The product of a matrix and a column.
fn applied<S: Ring, const N: usize>(a: &Matrix<S, N>, x: [S; N]) -> [S; N] {
    a.map(|row| {
        row.into_iter()
            .zip(x)
            .fold(S::zero(), |sum, (a, x)| a.mul_add(x, sum))
    })
}

/// Subtracts the products of a matrix from vectors.
fn subtract<S: Ring, const N: usize, const SIDES: usize>(
    from: &mut [[S; N]; SIDES],
    matrix: &Matrix<S, N>,
    vectors: [[S; N]; SIDES],
) {
    for (side, vector) in from.iter_mut().zip(vectors) {
        let known = applied(matrix, vector);
        *side = core::array::from_fn(|k| side[k] - known[k]);
    }
}

/// The inverse of a positive definite matrix, with its diagonal scaled to 1 before; `None` where a
/// diagonal entry is not positive, or the matrix is singular up to rounding.
pub(super) fn inverse_of_positive_definite<S: Real<Mask = bool>, const N: usize>(
    mut a: Matrix<S, N>,
) -> Option<Matrix<S, N>> {
    let scales: [S; N] = core::array::from_fn(|k| a[k][k].sqrt().recip());
    if !scales.iter().all(|scale| scale.is_finite()) {
        return None;
    }
    for row in 0..N {
        for column in 0..N {
            a[row][column] *= scales[row] * scales[column];
        }
    }
    let most = (S::epsilon() * S::from_integer(64)).recip();
    let mut inverse = [[S::zero(); N]; N];
    for (row, unit) in identity::<S, N>().into_iter().enumerate() {
        let solution = solve(a, unit)?;
        let own = solution[row];
        if !(S::zero().less_than(own) && own.less_than(most)) {
            return None;
        }
        inverse[row] = core::array::from_fn(|k| solution[k] * scales[row] * scales[k]);
    }
    Some(inverse)
}

/// The eigenvalues of a symmetric matrix and their eigenvectors of length 1, the largest eigenvalue
/// first.
///
/// By the cyclic method of Jacobi (Golub and Van Loan, Matrix Computations, 2013, section 8.5):
/// each step makes one off-diagonal entry zero by a rotation in the plane of two axes.
pub(super) fn symmetric_eigen<S: Real<Mask = bool>, const N: usize>(
    mut a: Matrix<S, N>,
) -> [(S, [S; N]); N] {
    // Sweeps converge quadratically; small matrices rarely need more than six.
    const MOST_SWEEPS: usize = 40;
    let mut vectors = identity::<S, N>();
    let entries = a.iter().flatten();
    let size = entries.fold(S::zero(), |most, x| most.max(x.abs()));
    let negligible = size * S::epsilon() * S::epsilon();
    for _ in 0..MOST_SWEEPS {
        let mut is_diagonal = true;
        for p in 0..N {
            for q in p + 1..N {
                if negligible.less_than(a[p][q].abs()) {
                    is_diagonal = false;
                    turn(&mut a, &mut vectors, p, q);
                }
            }
        }
        if is_diagonal {
            break;
        }
    }
    let mut pairs: [(S, [S; N]); N] = core::array::from_fn(|k| (a[k][k], vectors[k]));
    for end in (1..N).rev() {
        for k in 0..end {
            if pairs[k].0.less_than(pairs[k + 1].0) {
                pairs.swap(k, k + 1);
            }
        }
    }
    pairs
}

/// One step: the rotation in the plane of two axes p < q that makes their common entry zero. The
/// eigenvectors are rows.
fn turn<S: Real<Mask = bool>, const N: usize>(
    a: &mut Matrix<S, N>,
    vectors: &mut Matrix<S, N>,
    p: usize,
    q: usize,
) {
    let slope = (a[q][q] - a[p][p]) / (a[p][q] + a[p][q]);
    let root = slope.mul_add(slope, S::one()).sqrt();
    let tangent = (slope.abs() + root).recip();
    let tangent = S::select(slope.less_than(S::zero()), -tangent, tangent);
    let cosine = tangent.mul_add(tangent, S::one()).sqrt().recip();
    let sine = tangent * cosine;
    let mixed = |x: S, y: S| (cosine * x - sine * y, sine * x + cosine * y);
    for row in a.iter_mut() {
        (row[p], row[q]) = mixed(row[p], row[q]);
    }
    turn_rows(a, p, q, mixed);
    turn_rows(vectors, p, q, mixed);
    // Zero by construction, up to rounding.
    (a[p][q], a[q][p]) = (S::zero(), S::zero());
}

fn turn_rows<S: Field, const N: usize>(
    matrix: &mut Matrix<S, N>,
    p: usize,
    q: usize,
    mixed: impl Fn(S, S) -> (S, S),
) {
    let (head, tail) = matrix.split_at_mut(q);
    for (x, y) in head[p].iter_mut().zip(&mut tail[0]) {
        (*x, *y) = mixed(*x, *y);
    }
}
