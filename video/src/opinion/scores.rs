//! Scores of a measure beside the opinion of people.

use ga_files::table::Table;

use super::OpinionError;

/// The scores that a measure gave to pictures or videos, and the mean opinion scores that people
/// gave to the same ones.
///
/// ```
/// use ga_video::opinion::{OpinionError, Scores};
///
/// let scores = Scores::new(vec![30.0, 35.0, 40.0], vec![2.0, 3.0, 4.5])?;
/// assert_eq!(scores.len(), 3);
/// let wrong = Scores::new(vec![30.0, f64::NAN], vec![2.0, 3.0]);
/// assert!(matches!(wrong, Err(OpinionError::NotFinite { row: 1, .. })));
/// # Ok::<(), OpinionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scores {
    objective: Vec<f64>,
    subjective: Vec<f64>,
    deviations: Option<Vec<f64>>,
}

impl Scores {
    /// Scores of a measure, and the mean opinion scores in the same order.
    ///
    /// # Errors
    ///
    /// [`OpinionError::Lengths`], [`OpinionError::NotFinite`]; [`OpinionError::TooFew`] for fewer
    /// than 2; [`OpinionError::Constant`] where all numbers of a column are equal.
    pub fn new(objective: Vec<f64>, subjective: Vec<f64>) -> Result<Self, OpinionError> {
        same_length(&objective, &subjective)?;
        if objective.len() < 2 {
            return Err(OpinionError::TooFew {
                what: "scores",
                found: objective.len(),
                least: 2,
            });
        }
        for (column, values) in [("objective", &objective), ("subjective", &subjective)] {
            finite(column, values)?;
            if is_constant(values) {
                let column = column.to_owned();
                return Err(OpinionError::Constant { column });
            }
        }
        Ok(Self {
            objective,
            subjective,
            deviations: None,
        })
    }

    /// The scores in a column of a table, and the mean opinion scores in its column `subjective`,
    /// with their standard deviations where it has a column `deviation`.
    ///
    /// # Errors
    ///
    /// [`OpinionError::Table`] where a column or a number is missing; those of [`new`](Self::new)
    /// and [`with_deviations`](Self::with_deviations).
    pub fn of_column(table: &Table, objective: &str) -> Result<Self, OpinionError> {
        let scores = Self::new(table.numbers(objective)?, table.numbers("subjective")?)?;
        match table.column("deviation") {
            Some(_) => scores.with_deviations(table.numbers("deviation")?),
            None => Ok(scores),
        }
    }

    /// The same scores with the standard deviation of the mean opinion scores, one for each: a
    /// prediction that is off by more than two of them is an outlier.
    ///
    /// # Errors
    ///
    /// [`OpinionError::Lengths`], [`OpinionError::NotFinite`], [`OpinionError::Deviation`].
    pub fn with_deviations(mut self, deviations: Vec<f64>) -> Result<Self, OpinionError> {
        same_length(&self.objective, &deviations)?;
        finite("deviation", &deviations)?;
        if let Some((row, value)) = deviations.iter().enumerate().find(|(_, d)| **d < 0.0) {
            return Err(OpinionError::Deviation { row, value: *value });
        }
        self.deviations = Some(deviations);
        Ok(self)
    }

    /// The number of scores.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "there are always two scores")]
    pub fn len(&self) -> usize {
        self.objective.len()
    }

    /// The scores of the measure.
    #[must_use]
    pub fn objective(&self) -> &[f64] {
        &self.objective
    }

    /// The mean opinion scores.
    #[must_use]
    pub fn subjective(&self) -> &[f64] {
        &self.subjective
    }

    /// The standard deviations of the mean opinion scores, where they are known.
    #[must_use]
    pub fn deviations(&self) -> Option<&[f64]> {
        self.deviations.as_deref()
    }

    /// The scores with these numbers, in this order, which may repeat; `None` where all numbers of
    /// a column would be equal.
    pub(super) fn drawn(&self, rows: &[usize]) -> Option<Self> {
        let pick = |values: &[f64]| rows.iter().map(|row| values[*row]).collect::<Vec<_>>();
        let (objective, subjective) = (pick(&self.objective), pick(&self.subjective));
        (!is_constant(&objective) && !is_constant(&subjective)).then(|| Self {
            objective,
            subjective,
            deviations: self.deviations.as_deref().map(pick),
        })
    }
}

/// Whether two columns have one length.
pub(super) fn same_length(first: &[f64], second: &[f64]) -> Result<(), OpinionError> {
    if first.len() == second.len() {
        return Ok(());
    }
    Err(OpinionError::Lengths {
        first: first.len(),
        second: second.len(),
    })
}

/// Whether all numbers are finite.
fn finite(column: &str, values: &[f64]) -> Result<(), OpinionError> {
    match values.iter().enumerate().find(|(_, v)| !v.is_finite()) {
        None => Ok(()),
        Some((row, value)) => Err(OpinionError::NotFinite {
            row,
            column: column.to_owned(),
            value: *value,
        }),
    }
}

fn is_constant(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[0] == pair[1])
}
