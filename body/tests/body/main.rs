//! Poses of bodies against scenes that are known and independent formulas.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod dot;
mod evaluation;
mod fit;
mod format;
mod marker;
mod person;
mod pictures;
mod pose_error;
mod studio;
