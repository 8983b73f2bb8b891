//! The testing module of ga-runtime: strategies, comparisons and benchmarks of products; and a
//! check that all its examples are run.

mod bench;
mod close;
mod elements;
mod examples;
mod geometry;
