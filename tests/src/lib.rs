//! Helpers for the tests that use several crates. The programs in the README and in `docs` are run
//! as doctests of this library.

pub mod limits;
pub mod oracle;
pub mod plain;
pub mod random;
mod twofold;

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;

#[cfg(doctest)]
#[doc = include_str!("../../docs/engine.md")]
pub struct Engine;
