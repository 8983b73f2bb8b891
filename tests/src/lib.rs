//! What the tests that cross crates share. The programs of the README are run as doctests of this
//! library.

pub mod oracle;
pub mod plain;
pub mod random;

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
