//! Algebras declared outside ga-runtime: with other metrics, under other names, and wherever a
//! module can be.
//!
//! Each is tested by the product tests of its declaration. The lints below apply to emitted code
//! too.

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

mod blades;
mod conformal;
mod elements;
#[path = "../interop/every_type.rs"]
mod every_type;
mod interface;
mod metrics;
mod parameters;
mod places;
mod same_text;
mod tied;
mod versors;
