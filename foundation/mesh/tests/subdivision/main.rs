//! Subdivision surfaces beside known answers, closed forms and a second implementation.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod attributes;
mod closed_forms;
mod corner_values;
mod dense;
mod errors;
mod limit;
mod opensubdiv;
mod oracle;
mod properties;
mod second;
mod shapes;
