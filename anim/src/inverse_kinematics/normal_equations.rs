//! The equations of a damped Gauss–Newton step.

use ga_runtime::vga3::Vector;
use nalgebra_035::{Cholesky, DMatrix, DVector};

/// `(JᵀWJ + μ D) δ = −JᵀWr`, for sums over rows that are non-zero in few columns, with D the mean
/// of the diagonal of JᵀWJ times the identity. What the rows do not determine gets no step: δ is a
/// combination of rows.
#[derive(Clone, Debug)]
pub(super) struct NormalEquations {
    /// JᵀWJ, of which the lower triangle is filled.
    matrix: DMatrix<f64>,
    /// JᵀWr.
    gradient: DVector<f64>,
    factor: DMatrix<f64>,
    step: DVector<f64>,
}

/// A direction of one to three columns from `first` on that a step must not have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blocked {
    pub(super) first: usize,
    pub(super) count: usize,
    pub(super) direction: Vector<f64>,
}

impl NormalEquations {
    pub(super) fn new(columns: usize) -> Self {
        Self {
            matrix: DMatrix::zeros(columns, columns),
            gradient: DVector::zeros(columns),
            factor: DMatrix::zeros(columns, columns),
            step: DVector::zeros(columns),
        }
    }

    pub(super) fn clear(&mut self) {
        self.matrix.fill(0.0);
        self.gradient.fill(0.0);
    }

    /// Adds three rows, the derivatives of a residual in space: its non-zero columns, rising.
    pub(super) fn add(
        &mut self,
        rows: &[(usize, Vector<f64>)],
        residual: Vector<f64>,
        weight: f64,
    ) {
        for (place, &(column, derivative)) in rows.iter().enumerate() {
            let weighted = derivative * weight;
            self.gradient[column] += weighted.dot(residual);
            for &(below, other) in &rows[place..] {
                self.matrix[(below, column)] += weighted.dot(other);
            }
        }
    }

    /// Whether the sum of squares falls in a direction.
    pub(super) fn falls(
        &self,
        &Blocked {
            first,
            count,
            direction,
        }: &Blocked,
    ) -> bool {
        let slopes = (0..count).map(|k| self.gradient[first + k] * direction[k]);
        slopes.sum::<f64>() < 0.0
    }

    /// Computes the step δ for a damping μ that is perpendicular to directions. `None` where the
    /// equations have no solution in floating point.
    pub(super) fn solve(&mut self, damping: f64, blocked: &[Blocked]) -> Option<()> {
        /// How much stiffer a blocked direction is than the others.
        const STIFF: f64 = 1e7;
        let count = self.matrix.nrows();
        let mut factor = std::mem::replace(&mut self.factor, DMatrix::zeros(0, 0));
        if factor.nrows() == count {
            factor.copy_from(&self.matrix);
        } else {
            factor = self.matrix.clone();
        }
        let mean = self.matrix.trace() / count.max(1) as f64;
        for k in 0..count {
            factor[(k, k)] += damping * mean;
        }
        for &Blocked {
            first,
            count,
            direction,
        } in blocked
        {
            for row in 0..count {
                for column in 0..=row {
                    factor[(first + row, first + column)] +=
                        STIFF * mean * direction[row] * direction[column];
                }
            }
        }
        let cholesky = Cholesky::new(factor)?;
        self.step.copy_from(&self.gradient);
        self.step.neg_mut();
        cholesky.solve_mut(&mut self.step);
        self.factor = cholesky.unpack_dirty();
        self.step.iter().all(|x| x.is_finite()).then_some(())
    }

    /// By how much the sum of squares falls after the step that was computed last, by the
    /// equations: `−δᵀJᵀWr + μ δᵀDδ`.
    pub(super) fn predicted(&self, damping: f64) -> f64 {
        let mean = self.matrix.trace() / self.matrix.nrows().max(1) as f64;
        damping * mean * self.step.norm_squared() - self.gradient.dot(&self.step)
    }

    /// The step that was computed last.
    pub(super) fn step(&self) -> &DVector<f64> {
        &self.step
    }
}
