//! The normal equations, and their solution by elimination of groups.

use nalgebra_035::{Cholesky, DMatrix, DVector, Dyn};

use super::covariance::Covariance;
use super::loss::Loss;

/// The unknowns of a step: first the shared ones, then those of each group.
///
/// A residual may depend on all shared unknowns and on those of one group: in a calibration the
/// shared unknowns are those of the cameras, and each board has a group for its motor. The groups
/// are eliminated one by one, so that the work grows with their number and not with its cube (the
/// Schur complement; D. C. Brown, "A solution to the general problem of multiple station analytical
/// stereotriangulation", 1958).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns {
    shared: usize,
    group_size: usize,
    groups: usize,
}

impl Columns {
    /// Unknowns that are all shared.
    #[must_use]
    pub fn dense(count: usize) -> Self {
        Self::grouped(count, 0, 0)
    }

    /// Shared unknowns, and groups of equal size. The column of the unknown k of the group g is
    /// `shared + g · group_size + k`.
    #[must_use]
    pub fn grouped(shared: usize, groups: usize, group_size: usize) -> Self {
        Self {
            shared,
            group_size,
            groups,
        }
    }

    /// The number of unknowns.
    #[must_use]
    pub fn count(&self) -> usize {
        self.shared + self.groups * self.group_size
    }
}

/// The sum of the residuals' losses at a state, and the normal equations of a step from there.
#[derive(Clone, Debug)]
pub struct Equations {
    columns: Columns,
    loss: Loss,
    cost: f64,
    residuals: usize,
    /// `JᵀWJ` between shared columns, the lower triangle.
    shared: DMatrix<f64>,
    /// For each group, `JᵀWJ` between its columns, the lower triangle.
    own: Vec<DMatrix<f64>>,
    /// For each group, `JᵀWJ` between its columns (rows here) and the shared ones.
    mixed: Vec<DMatrix<f64>>,
    /// `JᵀWr` for all columns.
    gradient: DVector<f64>,
    /// Where they are asked for, the residuals with their derivatives.
    linearised: Option<Linearised>,
}

/// All residuals and their derivatives by the unknowns.
#[derive(Clone, Debug, Default)]
struct Linearised {
    residuals: Vec<f64>,
    /// Of a row and a column.
    derivatives: Vec<(usize, usize, f64)>,
}

impl Linearised {
    fn add<const N: usize>(&mut self, residual: [f64; N], derivatives: &[(usize, [f64; N])]) {
        let first = self.residuals.len();
        self.residuals.extend(residual);
        for (column, derivative) in derivatives {
            let entry = |(row, value): (usize, &f64)| (first + row, *column, *value);
            self.derivatives
                .extend(derivative.iter().enumerate().map(entry));
        }
    }
}

/// How groups follow the shared unknowns, so that the cost stays the least for these.
#[derive(Clone, Debug)]
pub(super) struct Following {
    /// The derivatives of the residuals by the shared unknowns.
    pub(super) jacobian: DMatrix<f64>,
    /// For each group the derivatives of its unknowns by the shared ones.
    groups: Vec<DMatrix<f64>>,
}

impl Following {
    /// The step of all unknowns with one of the shared ones.
    pub(super) fn step(&self, shared: &[f64]) -> Vec<f64> {
        let shared = DVector::from_column_slice(shared);
        let groups = self.groups.iter().map(|group| group * &shared);
        let groups: Vec<DVector<f64>> = groups.collect();
        let groups = groups.iter().flat_map(|group| group.iter().copied());
        shared.iter().copied().chain(groups).collect()
    }
}

/// A step, and what it does to the linear model of the residuals.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) values: Vec<f64>,
    /// The sum of the squares of the changes of the residuals, `δᵀJᵀWJδ`.
    pub(super) size: f64,
    /// By how much the sum of squares falls.
    pub(super) predicted: f64,
}

impl Equations {
    pub(super) fn new(columns: Columns, loss: Loss) -> Self {
        let (shared, size) = (columns.shared, columns.group_size);
        Self {
            loss,
            cost: 0.0,
            residuals: 0,
            shared: DMatrix::zeros(shared, shared),
            own: vec![DMatrix::zeros(size, size); columns.groups],
            mixed: vec![DMatrix::zeros(size, shared); columns.groups],
            gradient: DVector::zeros(columns.count()),
            linearised: None,
            columns,
        }
    }

    /// The same for the residuals and derivatives of further states, which it keeps.
    pub(super) fn keeping(&self) -> Self {
        Self {
            linearised: Some(Linearised::default()),
            ..self.clone()
        }
    }

    /// The residuals that were kept.
    pub(super) fn kept_residuals(&self) -> &[f64] {
        match &self.linearised {
            Some(kept) => &kept.residuals,
            None => &[],
        }
    }

    /// How groups follow the shared unknowns, from derivatives that were kept. `None` where a group
    /// is not determined.
    pub(super) fn following(&self) -> Option<Following> {
        let kept = self.linearised.as_ref()?;
        let groups = self.own.iter().zip(&self.mixed);
        let groups = groups.map(|(own, mixed)| Some(-Cholesky::new(symmetric(own))?.solve(mixed)));
        let groups: Vec<DMatrix<f64>> = groups.collect::<Option<_>>()?;
        let mut jacobian = DMatrix::zeros(kept.residuals.len(), self.columns.shared);
        for &(row, column, value) in &kept.derivatives {
            if column < self.columns.shared {
                jacobian[(row, column)] += value;
            } else {
                let (group, place) = self.place(column);
                let mut row = jacobian.row_mut(row);
                row += groups[group].row(place) * value;
            }
        }
        Some(Following { jacobian, groups })
    }

    /// The step of the groups alone, and by how much the sum of squares falls. `None` where a group
    /// is not determined.
    pub(super) fn step_of_groups(&self) -> Option<(Vec<f64>, f64)> {
        let Columns {
            shared: count,
            group_size: size,
            ..
        } = self.columns;
        let mut step = vec![0.0; self.columns.count()];
        let mut fall = 0.0;
        for (group, own) in self.own.iter().enumerate() {
            let first = count + group * size;
            let gradient = self.gradient.rows(first, size);
            let change = Cholesky::new(symmetric(own))?.solve(&gradient);
            fall += gradient.dot(&change);
            for (place, change) in change.iter().enumerate() {
                step[first + place] = -change;
            }
        }
        Some((step, fall))
    }

    /// How many unknowns are shared, and how many groups there are.
    pub(super) fn parts(&self) -> [usize; 2] {
        [self.columns.shared, self.columns.groups]
    }

    pub(super) fn clear(&mut self) {
        self.cost = 0.0;
        self.residuals = 0;
        self.shared.fill(0.0);
        self.own.iter_mut().for_each(|block| block.fill(0.0));
        self.mixed.iter_mut().for_each(|block| block.fill(0.0));
        self.gradient.fill(0.0);
        if let Some(kept) = &mut self.linearised {
            kept.residuals.clear();
            kept.derivatives.clear();
        }
    }

    /// Adds a residual of N components with its derivatives by the columns on which it depends, in
    /// any order. A column that occurs twice counts with the sum.
    ///
    /// # Panics
    /// Where a column does not exist, or where two columns belong to different groups.
    pub fn add<const N: usize>(&mut self, residual: [f64; N], derivatives: &[(usize, [f64; N])]) {
        let dot = |a: &[f64; N], b: &[f64; N]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        if let Some(kept) = &mut self.linearised {
            kept.add(residual, derivatives);
        }
        let (loss, weight) = self.loss.of(dot(&residual, &residual));
        self.cost += loss;
        self.residuals += N;
        let shared = self.columns.shared;
        // All of them but the shared ones are in one group.
        let own = derivatives.iter().find(|(column, _)| *column >= shared);
        let (group, first) = own.map_or((0, shared), |(column, _)| {
            let (group, row) = self.place(*column);
            (group, column - row)
        });
        for (place, (column, derivative)) in derivatives.iter().enumerate() {
            let is_in_group = (first..first + self.columns.group_size).contains(column);
            assert!(
                *column < shared || is_in_group,
                "a residual depends on two groups"
            );
            let weighted = derivative.map(|value| weight * value);
            self.gradient[*column] += dot(&weighted, &residual);
            for (second, (other, other_derivative)) in derivatives[..=place].iter().enumerate() {
                let mut product = dot(&weighted, other_derivative);
                if second != place && column == other {
                    product *= 2.0;
                }
                let (low, high) = (*column.min(other), *column.max(other));
                if high < shared {
                    self.shared[(high, low)] += product;
                } else if low < shared {
                    self.mixed[group][(high - first, low)] += product;
                } else {
                    self.own[group][(high - first, low - first)] += product;
                }
            }
        }
    }

    /// The group of a column that is not shared, and its place there.
    fn place(&self, column: usize) -> (usize, usize) {
        let beyond = column - self.columns.shared;
        (
            beyond / self.columns.group_size,
            beyond % self.columns.group_size,
        )
    }

    pub(super) fn cost(&self) -> f64 {
        self.cost
    }

    pub(super) fn residuals(&self) -> usize {
        self.residuals
    }

    pub(super) fn unknowns(&self) -> usize {
        self.columns.count()
    }

    /// Whether residuals and derivatives are finite. A derivative that is not makes its diagonal
    /// entry so.
    pub(super) fn is_finite(&self) -> bool {
        let is_finite =
            |block: &DMatrix<f64>| (0..block.nrows()).all(|k| block[(k, k)].is_finite());
        self.cost.is_finite()
            && self.gradient.iter().all(|value| value.is_finite())
            && is_finite(&self.shared)
            && self.own.iter().all(is_finite)
    }

    /// The step for a damping. `None` where the equations have no solution in floating point.
    pub(super) fn solve(&self, damping: f64) -> Option<Step> {
        let Columns {
            shared: count,
            group_size: size,
            ..
        } = self.columns;
        let mut reduced = damped(&self.shared, damping);
        let mut right = -self.gradient.rows(0, count).into_owned();
        let mut factors = Vec::with_capacity(self.own.len());
        for (group, (own, mixed)) in self.own.iter().zip(&self.mixed).enumerate() {
            let factor = Cholesky::new(damped(own, damping))?;
            let gradient = self.gradient.rows(count + group * size, size);
            let eliminated = factor.solve(mixed);
            reduced -= mixed.tr_mul(&eliminated);
            right += eliminated.tr_mul(&gradient);
            factors.push(factor);
        }
        let mut values = DVector::zeros(self.columns.count());
        if count > 0 {
            let solution = Cholesky::new(reduced)?.solve(&right);
            values.rows_mut(0, count).copy_from(&solution);
        }
        for (group, (factor, mixed)) in factors.iter().zip(&self.mixed).enumerate() {
            let first = count + group * size;
            let gradient = self.gradient.rows(first, size);
            let right = -(gradient + mixed * values.rows(0, count));
            values
                .rows_mut(first, size)
                .copy_from(&factor.solve(&right));
        }
        let size = self.quadratic_form(&values);
        let predicted = -2.0 * self.gradient.dot(&values) - size;
        values.iter().all(|value| value.is_finite()).then(|| Step {
            values: values.data.into(),
            size,
            predicted,
        })
    }

    /// `δᵀJᵀWJδ`.
    fn quadratic_form(&self, step: &DVector<f64>) -> f64 {
        let Columns {
            shared: count,
            group_size: size,
            ..
        } = self.columns;
        let shared = step.rows(0, count);
        let mut sum = shared.dot(&(symmetric(&self.shared) * shared));
        for (group, (own, mixed)) in self.own.iter().zip(&self.mixed).enumerate() {
            let part = step.rows(count + group * size, size);
            sum += part.dot(&(symmetric(own) * part)) + 2.0 * part.dot(&(mixed * shared));
        }
        sum
    }

    /// The inverse of `JᵀWJ` times a variance, for the shared columns and within each group. Else
    /// the first column that the columns before it, in the order of elimination (the groups, then
    /// the shared ones), leave undetermined.
    pub(super) fn covariance(&self, variance: f64) -> Result<Covariance, usize> {
        let mut reduced = symmetric(&self.shared);
        let mut parts = Vec::with_capacity(self.own.len());
        for (group, (own, mixed)) in self.own.iter().zip(&self.mixed).enumerate() {
            let own = symmetric(own);
            let first = self.columns.shared + group * self.columns.group_size;
            let factor = Cholesky::new(own.clone())
                .ok_or_else(|| first + first_singular(&own, Cholesky::new))?;
            let eliminated = factor.solve(mixed);
            reduced -= mixed.tr_mul(&eliminated);
            parts.push((factor.inverse(), eliminated));
        }
        let shared = match reduced.nrows() {
            0 => reduced,
            _ => well_conditioned(reduced.clone())
                .ok_or_else(|| first_singular(&reduced, well_conditioned))?
                .inverse(),
        };
        let groups = parts.into_iter().map(|(inverse, eliminated)| {
            (inverse + &eliminated * &shared * eliminated.transpose()) * variance
        });
        let groups: Vec<DMatrix<f64>> = groups.collect();
        Ok(Covariance::new(shared * variance, groups))
    }
}

/// The Cholesky factor of a matrix that rounding errors have not made regular: scaled to a diagonal
/// of ones, its pivots stay above them.
fn well_conditioned(matrix: DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
    const LEAST_PIVOT: f64 = 1e-14;
    let diagonal = matrix.diagonal();
    let factor = Cholesky::new(matrix)?;
    let lower = factor.l_dirty();
    let is_regular = |k: usize| lower[(k, k)] * lower[(k, k)] > LEAST_PIVOT * diagonal[k].abs();
    (0..diagonal.len()).all(is_regular).then_some(factor)
}

/// The first column without which the columns up to it have a factor, of a matrix without one.
fn first_singular(
    matrix: &DMatrix<f64>,
    factor: fn(DMatrix<f64>) -> Option<Cholesky<f64, Dyn>>,
) -> usize {
    let leading = |count: usize| matrix.view((0, 0), (count, count)).into_owned();
    let is_singular = |column: &usize| factor(leading(column + 1)).is_none();
    (0..matrix.nrows()).find(is_singular).unwrap_or_default()
}

/// The full matrix of a lower triangle.
fn symmetric(lower: &DMatrix<f64>) -> DMatrix<f64> {
    let mut full = lower.clone();
    full.fill_upper_triangle_with_lower_triangle();
    full
}

/// The full matrix with its diagonal enlarged by a part of it. A column without derivatives gets 1,
/// so that its step is 0.
fn damped(lower: &DMatrix<f64>, damping: f64) -> DMatrix<f64> {
    let mut full = symmetric(lower);
    for k in 0..full.nrows() {
        let diagonal = full[(k, k)];
        full[(k, k)] = match diagonal > 0.0 {
            true => diagonal * (1.0 + damping),
            false => 1.0,
        };
    }
    full
}
