//! Errors of reading measurements and writing their tables.

use std::io;
use std::path::PathBuf;

/// The reason why measurements could not be read, or their tables could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ResultsError {
    /// A file or folder could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file or folder.
        path: PathBuf,
        /// The error of the operating system.
        source: io::Error,
    },
    /// A file does not have the form that criterion writes.
    #[error("{} is not a file of criterion: {source}", path.display())]
    Criterion {
        /// The file.
        path: PathBuf,
        /// The first difference from the expected form.
        source: serde_json::Error,
    },
    /// A time or a count of elements is not a positive number.
    #[error("{}: the median time is {value}", path.display())]
    NoTime {
        /// The file.
        path: PathBuf,
        /// The value found in place of a time.
        value: f64,
    },
    /// The folder contains no run with the required name.
    #[error("{} contains no runs named {prefix}1, {prefix}2 and so on", path.display())]
    NoRuns {
        /// The folder.
        path: PathBuf,
        /// The beginning of the names of runs.
        prefix: String,
    },
    /// A line of a list of figures does not consist of name, contender and number.
    #[error("{}, line {line}: expected name, contender and number, found {text:?}", path.display())]
    Record {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// The text of the line.
        text: String,
    },
    /// The tables could not be written; an earlier file of that name is unchanged.
    #[error(transparent)]
    Write(#[from] ga_files::WriteError),
}
