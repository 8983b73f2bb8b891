//! Output besides the items of an algebra: counts, formulas and graphs.
//!
//! Formulas and graphs are read back from their text and evaluated over the prime field, where they
//! must agree with the graph that they were written from. Counts must agree with the cost that the
//! compiler computes. Shaders are tested in a crate of their own.

mod count;
mod dot;
mod formula;
mod random;
mod source;
