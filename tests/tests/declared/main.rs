//! Algebras declared outside ga-runtime: in other metrics, under other names, and in every place
//! where a module can be.
//!
//! Each brings the tests that its declaration stands for, exact against the dense reference. The
//! lints below hold for what the macro emits too.

#![deny(
    missing_copy_implementations,
    missing_debug_implementations,
    missing_docs,
    nonstandard_style,
    trivial_casts,
    trivial_numeric_casts,
    unreachable_pub,
    unsafe_code,
    unused,
    unused_lifetimes,
    unused_qualifications,
    clippy::pedantic
)]

mod conformal;
mod interface;
mod metrics;
mod places;
mod same_text;
mod versors;
