//! From measurements to the tables of `RESULTS.md`.

mod error;
mod measurements;
mod report;
mod targets;

pub use error::ResultsError;
pub use measurements::{Group, Measurements, Record, records};
pub use report::{Report, Setting, write};
