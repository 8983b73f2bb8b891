//! Symmetric systems whose unknowns form a tree: two unknowns are coupled only where one is above
//! the other.
//!
//! The equations of a pose are such a system, since a joint moves only what is below it. Eliminated
//! from the leaves to the root, `A = LᵀL` has nothing where A has nothing (R. Featherstone,
//! "Efficient factorization of the joint-space inertia matrix for branched kinematic trees",
//! International Journal of Robotics Research 24, 2005).

use nalgebra_035::{DMatrix, DVector};

/// For each unknown the one above it, which comes before it.
pub(super) type Above = Vec<Option<usize>>;

/// Replaces the lower triangle of A by L. Returns the logarithm of the determinant of A; `None`
/// where A is not positive definite in floating point.
pub(super) fn factor(matrix: &mut DMatrix<f64>, above: &Above) -> Option<f64> {
    let mut logarithm = 0.0;
    for k in (0..above.len()).rev() {
        let pivot = matrix[(k, k)];
        if !(pivot > 0.0 && pivot.is_finite()) {
            return None;
        }
        logarithm += pivot.ln();
        let root = pivot.sqrt();
        matrix[(k, k)] = root;
        let mut row = above[k];
        while let Some(i) = row {
            matrix[(k, i)] /= root;
            row = above[i];
        }
        let mut row = above[k];
        while let Some(i) = row {
            let factor = matrix[(k, i)];
            let mut column = Some(i);
            while let Some(j) = column {
                matrix[(i, j)] -= factor * matrix[(k, j)];
                column = above[j];
            }
            row = above[i];
        }
    }
    Some(logarithm)
}

/// Replaces b by the solution x of `LᵀL x = b`.
pub(super) fn solve(factor: &DMatrix<f64>, above: &Above, right: &mut DVector<f64>) {
    for i in (0..above.len()).rev() {
        right[i] /= factor[(i, i)];
        let mut column = above[i];
        while let Some(j) = column {
            right[j] -= factor[(i, j)] * right[i];
            column = above[j];
        }
    }
    for i in 0..above.len() {
        let mut column = above[i];
        while let Some(j) = column {
            right[i] -= factor[(i, j)] * right[j];
            column = above[j];
        }
        right[i] /= factor[(i, i)];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn trees_are_solved_as_dense_systems_are() {
        // Two branches of two unknowns on a trunk of two.
        let above: Above = vec![None, Some(0), Some(1), Some(2), Some(1), Some(4)];
        let is_above =
            |i: usize, j: usize| std::iter::successors(Some(i), |&k| above[k]).any(|k| k == j);
        let dense = DMatrix::from_fn(6, 6, |i, j| {
            match (i == j, is_above(i, j) || is_above(j, i)) {
                (true, _) => 5.0 + i as f64,
                (_, true) => 1.0 / (1.0 + (i + j) as f64),
                _ => 0.0,
            }
        });
        let right = DVector::from_fn(6, |i, _| (i as f64).sin() + 0.3);
        let mut factored = dense.clone();
        let logarithm = factor(&mut factored, &above).expect("positive definite");
        let mut found = right.clone();
        solve(&factored, &above, &mut found);
        assert!((logarithm - dense.determinant().ln()).abs() < 1e-12);
        assert!((&dense * found - right).norm() < 1e-13);
        let mut indefinite = dense;
        indefinite[(3, 3)] = -1.0;
        assert_eq!(factor(&mut indefinite, &above), None);
    }
}
