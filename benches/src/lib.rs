//! The parts that the benchmarks share: inputs, measurement, functions and rivals.
//!
//! `METHODOLOGY.md` describes how the figures of `RESULTS.md` are measured.

pub mod comparison;
pub mod declaration;
pub mod dense;
pub mod functions;
pub mod inputs;
pub mod precision;
pub mod results;
pub mod rivals;
pub mod scene;
