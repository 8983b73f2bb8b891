//! What a measure of quality is worth, in all numbers that are reported: both curves, correlations
//! and errors with intervals, and the difference from another measure.

mod page;
mod plot;

use ga_files::table::Table;
use serde::Serialize;

use super::logistic::{Curve, Fit, Logistic4, Logistic5};
use super::performance::{self, Bootstrap, Difference, Interval, Performance};
use super::{OpinionError, Scores};

/// Scores, and the curves that were fitted to them.
///
/// ```
/// use ga_files::table::Table;
/// use ga_video::opinion::OpinionError;
/// use ga_video::opinion::evaluation::Fitted;
/// use ga_video::opinion::performance::Bootstrap;
///
/// let rows = (0..20).map(|k| {
///     let x = 25.0 + f64::from(k);
///     format!("{x},{}\n", 1.0 + 4.0 / (1.0 + f64::exp(0.4 * (33.0 - x))))
/// });
/// let text = format!("objective,subjective\n{}", rows.collect::<String>());
/// let fitted = Fitted::of_column(&Table::with_names(text.as_bytes())?, "objective")?;
/// let found = fitted.evaluate(Bootstrap { draws: 20, ..Bootstrap::default() })?;
/// assert_eq!((found.scores, found.performance.spearman.value), (20, 1.0));
/// assert!((found.logistic4.parameters[2] - 33.0).abs() < 1e-4);
/// # Ok::<(), OpinionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Fitted {
    scores: Scores,
    four: Fit<Logistic4>,
    five: Fit<Logistic5>,
}

/// Scores for each parameter of a curve below which its fit says little of the measure.
const SCORES_FOR_PARAMETER: usize = 2;

/// How well a measure predicts opinion scores. As JSON, the numbers of [`Performance`] and of
/// [`Bootstrap`] stand beside the others.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Evaluation {
    /// The number of scores.
    pub scores: usize,
    /// What the measure is worth; numbers of the prediction are those of the curve with five
    /// parameters.
    #[serde(flatten)]
    pub performance: Performance<Interval>,
    /// The fitted curve with four parameters.
    pub logistic4: FittedCurve,
    /// The fitted curve with five parameters.
    pub logistic5: FittedCurve,
    /// How the intervals were found.
    #[serde(flatten)]
    pub bootstrap: Bootstrap,
    /// The difference from another measure, where one was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against: Option<Comparison>,
}

/// A fitted curve, and how well it predicts the scores.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FittedCurve {
    /// β₁ and so on.
    pub parameters: Vec<f64>,
    /// The sum of the squared errors.
    #[serde(rename = "sse")]
    pub sum_of_squares: f64,
    /// As in [`Fit`].
    #[serde(rename = "held_monotone")]
    pub is_held_monotone: bool,
    /// As in [`Performance`].
    #[serde(rename = "plcc")]
    pub linear_correlation: f64,
    /// As in [`Performance`].
    #[serde(rename = "rmse")]
    pub root_mean_square_error: f64,
    /// As in [`Performance`].
    pub outlier_ratio: f64,
}

/// A measure beside another one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The column of the other measure.
    pub column: String,
    /// The linear correlation of the other measure's prediction.
    #[serde(rename = "plcc")]
    pub linear_correlation: f64,
    /// As in [`Fit`], of the curve of the other measure.
    #[serde(rename = "held_monotone")]
    pub is_held_monotone: bool,
    /// The numbers of this measure less those of the other one.
    #[serde(flatten)]
    pub difference: Difference,
}

impl Fitted {
    /// Fits both curves to the scores in a column of a table, whose columns `subjective` and, where
    /// it is there, `deviation` have the mean opinion scores and their standard deviations.
    ///
    /// # Errors
    ///
    /// Those of [`Scores::of_column`]; [`OpinionError::TooFew`] where there are fewer scores than
    /// parameters.
    pub fn of_column(table: &Table, objective: &str) -> Result<Self, OpinionError> {
        let scores = Scores::of_column(table, objective)?;
        Ok(Self {
            four: Logistic4::fit(&scores)?,
            five: Logistic5::fit(&scores)?,
            scores,
        })
    }

    /// What the measure is worth, not compared with another one.
    ///
    /// # Errors
    ///
    /// Those of [`performance::with_intervals`].
    pub fn evaluate(&self, bootstrap: Bootstrap) -> Result<Evaluation, OpinionError> {
        let Self { scores, four, five } = self;
        Ok(Evaluation {
            scores: scores.len(),
            logistic4: FittedCurve::of(scores, four, &four.curve.parameters),
            logistic5: FittedCurve::of(scores, five, &five.curve.parameters),
            performance: performance::with_intervals(scores, five, &bootstrap)?,
            bootstrap,
            against: None,
        })
    }

    /// The difference from the measure in another column of the table, by the curve with five
    /// parameters.
    ///
    /// # Errors
    ///
    /// Those of [`of_column`](Self::of_column) and of [`performance::difference`].
    pub fn compare(
        &self,
        table: &Table,
        column: &str,
        bootstrap: &Bootstrap,
    ) -> Result<Comparison, OpinionError> {
        let other = Scores::of_column(table, column)?;
        let fit = Logistic5::fit(&other)?;
        let (scores, fits) = ([&self.scores, &other], [&self.five, &fit]);
        Ok(Comparison {
            column: column.to_owned(),
            difference: performance::difference(scores, fits, bootstrap)?,
            linear_correlation: performance::of(&other, &fit).linear_correlation,
            is_held_monotone: fit.is_held_monotone,
        })
    }
}

impl Evaluation {
    /// Why the fit says little, where there are few scores for the parameters of the curve.
    #[must_use]
    pub fn too_few(&self) -> Option<String> {
        let (scores, parameters) = (self.scores, Logistic5::PARAMETERS);
        let wanted = SCORES_FOR_PARAMETER * parameters;
        (scores < wanted).then(|| {
            format!(
                "{scores} scores are few for a curve with {parameters} parameters: PLCC, RMSE and \
                 outlier ratio describe the curve more than the measure; at least {wanted} scores \
                 are wanted"
            )
        })
    }

    /// For each measure whose curve with five parameters was kept from bending back, what was done.
    #[must_use]
    pub fn held_monotone(&self) -> Vec<String> {
        let of_measure = self.logistic5.is_held_monotone.then_some("the measure");
        let against = self.against.as_ref().filter(|found| found.is_held_monotone);
        let columns = against.map(|found| found.column.as_str());
        let message = |of| {
            format!(
                "the curve with 5 parameters that fits {of} best bends back between the scores; \
                 the best monotone one is taken (ITU-T P.1401)"
            )
        };
        of_measure.into_iter().chain(columns).map(message).collect()
    }
}

impl FittedCurve {
    fn of<C: Curve>(scores: &Scores, fit: &Fit<C>, parameters: &[f64]) -> Self {
        let found = performance::of(scores, fit);
        Self {
            parameters: parameters.to_vec(),
            sum_of_squares: fit.sum_of_squares,
            is_held_monotone: fit.is_held_monotone,
            linear_correlation: found.linear_correlation,
            root_mean_square_error: found.root_mean_square_error,
            outlier_ratio: found.outlier_ratio,
        }
    }
}
