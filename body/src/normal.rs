//! The normal equations of a step.

use super::chain::{Chain, Places};
use ga_runtime::vga3::Vector;
use nalgebra_035::{DMatrix, DVector};

/// The negative logarithm of a likelihood, doubled, and the equations of a step from there.
#[derive(Clone, Debug)]
pub(super) struct Normal {
    pub(super) cost: f64,
    /// Half the second derivative, in the lower triangle.
    pub(super) matrix: DMatrix<f64>,
    /// Half the first derivative.
    pub(super) gradient: DVector<f64>,
    rows: Vec<(usize, Vector<f64>)>,
}

impl Normal {
    pub(super) fn new(count: usize) -> Self {
        Self {
            cost: 0.0,
            matrix: DMatrix::zeros(count, count),
            gradient: DVector::zeros(count),
            rows: Vec::new(),
        }
    }

    /// Adds to the equations that a point should move along the downward gradient −b, where its
    /// squared error grows with the matrix A.
    pub(super) fn add(
        &mut self,
        places: &Places,
        chain: &Chain<'_>,
        point: usize,
        error: &PointError,
    ) {
        let mut rows = std::mem::take(&mut self.rows);
        chain.derivatives(places, point, &mut rows);
        for (index, (row, by_row)) in rows.iter().enumerate() {
            self.gradient[*row] += by_row.dot(error.gradient);
            let weighted = Vector::from(error.matrix.map(|line| line.dot(*by_row)));
            for (column, by_column) in &rows[..=index] {
                self.matrix[(*row, *column)] += weighted.dot(*by_column);
            }
        }
        self.rows = rows;
    }
}

/// The errors of a point in all views as a function of where it is.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct PointError {
    pub(super) gradient: Vector<f64>,
    pub(super) matrix: [Vector<f64>; 3],
}

impl PointError {
    /// The squared length of a way from where the point should be, times a weight.
    pub(super) fn of_distance(way: Vector<f64>, weight: f64) -> Self {
        Self {
            gradient: way * weight,
            matrix: [0, 1, 2]
                .map(|row| Vector::from([0, 1, 2].map(|k| if k == row { weight } else { 0.0 }))),
        }
    }
}
