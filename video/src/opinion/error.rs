//! What is wrong with scores and ratings.

use ga_files::table::TableError;

/// Why scores or ratings cannot be evaluated. Rows count from 0, without a header.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum OpinionError {
    /// The table is wrong.
    #[error(transparent)]
    Table(#[from] TableError),
    /// Two columns have different lengths.
    #[error("the columns have different lengths: {first} and {second}")]
    Lengths {
        /// The length of the first.
        first: usize,
        /// The length of the second.
        second: usize,
    },
    /// A number is not finite.
    #[error("row {row}, column {column}: {value} is not a finite number")]
    NotFinite {
        /// The row.
        row: usize,
        /// The name of the column.
        column: String,
        /// The number.
        value: f64,
    },
    /// A standard deviation is negative.
    #[error("row {row}: the standard deviation {value} is negative")]
    Deviation {
        /// The row.
        row: usize,
        /// The number.
        value: f64,
    },
    /// There are too few rows.
    #[error("{found} {what} are too few; at least {least} are needed")]
    TooFew {
        /// What is counted.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many there should be.
        least: usize,
    },
    /// All numbers of a column are equal, so that nothing can depend on it.
    #[error("all numbers of the column {column} are equal")]
    Constant {
        /// The name of the column.
        column: String,
    },
    /// The first column of a table of ratings does not say what the rows are.
    #[error(
        "the first column, {name:?}, does not say whether the rows are raters or stimuli: name it \
         rater or clip, or give --rows raters or --rows stimuli"
    )]
    Orientation {
        /// The name of the column.
        name: String,
    },
    /// A table whose rows are stimuli has groups, which only raters have.
    #[error("the rows are stimuli, and only raters can have a column group")]
    Groups,
    /// A row has another number of ratings than there are questions.
    #[error("rater {rater} has {found} ratings, but there are {expected} questions")]
    Ragged {
        /// The rater's name.
        rater: String,
        /// How many ratings there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A rating is not finite.
    #[error("rater {rater}, question {question}: {value} is not a finite number")]
    Rating {
        /// The rater's name.
        rater: String,
        /// The question.
        question: String,
        /// The number.
        value: f64,
    },
    /// A question has no ratings.
    #[error("the question {question} has no ratings")]
    Unanswered {
        /// The question.
        question: String,
    },
    /// A name stands for two raters or two questions.
    #[error("the {what} {name} occurs twice")]
    Repeated {
        /// What the name stands for.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A level of confidence is not between 0 and 1.
    #[error("{0} is not a level of confidence between 0 and 1")]
    Confidence(f64),
}
