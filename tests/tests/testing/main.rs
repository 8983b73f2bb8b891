//! What ga-runtime offers to tests: strategies, comparisons and benchmarks of products. The
//! examples of ga-runtime are found here too.

mod bench;
mod close;
mod elements;
mod examples;
mod geometry;
