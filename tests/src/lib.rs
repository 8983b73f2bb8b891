//! What the tests that cross crates share. The programs of the README are run as doctests of this
//! library.

pub mod plain;

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
