//! Why a table cannot be read.

/// What is wrong with a table. Lines and columns count from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TableError {
    /// The bytes are not UTF-8.
    #[error("line {line}: the text is not UTF-8")]
    Encoding {
        /// The line.
        line: usize,
    },
    /// A cell begins with a quotation mark and does not end with one.
    #[error("line {line}, column {column}: a quotation mark is not closed")]
    Quotation {
        /// The line where the cell begins.
        line: usize,
        /// The column.
        column: usize,
    },
    /// A row has another number of cells than the names.
    #[error("line {line} has {found} cells, and the first line names {expected} columns")]
    Cells {
        /// The line.
        line: usize,
        /// The line of the names.
        first: usize,
        /// How many cells it has.
        found: usize,
        /// How many columns have names.
        expected: usize,
    },
    /// A row of a [rectangular](super::Table::rectangular) table has another number of columns than
    /// the first line.
    #[error("line {line}: {found} columns, but line {first} has {expected}")]
    Columns {
        /// The line.
        line: usize,
        /// The first line.
        first: usize,
        /// How many columns it has.
        found: usize,
        /// How many columns the first line has.
        expected: usize,
    },
    /// The table has no rows, so that no line names its columns.
    #[error("the table is empty")]
    Empty,
    /// A column is not there.
    #[error("there is no column {wanted}; the first line names {names}")]
    Column {
        /// The name that was looked for.
        wanted: String,
        /// The names that are there.
        names: String,
    },
    /// A cell is not a finite number.
    #[error("line {line}, column {column}: {text:?} is not a finite number")]
    Number {
        /// The line.
        line: usize,
        /// The name of the column, or its number where it has none.
        column: String,
        /// What the cell says.
        text: String,
    },
}
