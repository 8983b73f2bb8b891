//! Tests that cross the crates of Nullcone. The programs of the README run here as they stand
//! there.

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
