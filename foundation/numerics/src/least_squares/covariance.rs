//! How well the unknowns are determined.

use nalgebra_035::DMatrix;

/// Variances and covariances of the shared unknowns, and of each group by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Covariance {
    shared: DMatrix<f64>,
    groups: Vec<DMatrix<f64>>,
}

impl Covariance {
    pub(super) fn new(shared: DMatrix<f64>, groups: Vec<DMatrix<f64>>) -> Self {
        Self { shared, groups }
    }

    /// The same groups with another covariance of the shared unknowns.
    pub(super) fn with_shared(&self, shared: DMatrix<f64>) -> Self {
        Self {
            shared,
            groups: self.groups.clone(),
        }
    }

    /// The covariance of two shared unknowns.
    ///
    /// # Panics
    /// Where a column is not one of the shared ones.
    #[must_use]
    pub fn shared(&self, row: usize, column: usize) -> f64 {
        self.shared[(row, column)]
    }

    /// The covariance of two unknowns of one group, by their places in it.
    ///
    /// # Panics
    /// Where there is no such group or no such place in it.
    #[must_use]
    pub fn group(&self, group: usize, row: usize, column: usize) -> f64 {
        self.groups[group][(row, column)]
    }

    /// The standard deviation of a shared unknown.
    ///
    /// # Panics
    /// Where the column is not one of the shared ones.
    #[must_use]
    pub fn standard_deviation(&self, column: usize) -> f64 {
        self.shared[(column, column)].max(0.0).sqrt()
    }
}
