//! What can go wrong between measurements and their tables.

use std::io;
use std::path::PathBuf;

/// Measurements could not be read, or their tables not be written.
#[derive(Debug, thiserror::Error)]
pub enum ResultsError {
    /// A file or folder could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file or folder.
        path: PathBuf,
        /// What the operating system said.
        source: io::Error,
    },
    /// A file of criterion is not what criterion writes.
    #[error("{} is not a file of criterion: {source}", path.display())]
    Criterion {
        /// The file.
        path: PathBuf,
        /// Where it departs from the expected form.
        source: serde_json::Error,
    },
    /// A time or a count of elements is not a positive number.
    #[error("{}: the median time is {value}", path.display())]
    NoTime {
        /// The file.
        path: PathBuf,
        /// What stands for the time.
        value: f64,
    },
    /// The folder holds no run of the name that runs must have.
    #[error("{} holds no runs named {prefix}1, {prefix}2 and so on", path.display())]
    NoRuns {
        /// The folder.
        path: PathBuf,
        /// How the names of runs begin.
        prefix: String,
    },
    /// A line of a list of figures does not have name, contender and number.
    #[error("{}, line {line}: expected name, contender and number, found {text:?}", path.display())]
    Record {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// The tables could not be written; whatever stood under the name before still does.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: io::Error,
    },
}
