//! What the benchmarks share: inputs, the way of measuring, the compared functions and the rivals.
//!
//! `METHODOLOGY.md` says how the figures of `RESULTS.md` come about.

pub mod comparison;
pub mod declaration;
pub mod dense;
pub mod functions;
pub mod inputs;
pub mod precision;
pub mod results;
pub mod rivals;
