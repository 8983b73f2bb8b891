//! The scalars: the prime field, dual numbers, lanes, and batches that use them.

mod batch;
mod dual;
mod dual_exact;
mod lanes;
mod prime_field;
mod step;
mod wide;
